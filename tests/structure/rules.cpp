#include "rules.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>

namespace pardel::structure {
namespace {

namespace fs = std::filesystem;

// ---------------------------------------------------------------------------------------------------------------------
// The tables.

/// A folder and the other folders that its files may include. A file belongs to the longest folder path that contains
/// it.
struct Layer {
  std::string_view folder;
  std::vector<std::string_view> may_include;
};
const std::vector<Layer>& layers() {
  static const std::vector<Layer> table = {
      {"core", {}},
      {"parallel", {"core"}},
      {"off_the_shelf", {"core", "parallel"}},
      {"distributed", {"core", "parallel", "off_the_shelf"}},
      {"ref", {"core"}},
      {"properties/checker", {"core"}},
      {"properties/domains", {"core"}},
      {"properties/comparison", {"core"}},
      {"properties/defects", {"core", "properties/checker", "properties/domains"}},
      {"properties/wrong_meshes", {"core", "properties/checker", "properties/domains", "properties/defects"}},
      {"properties/theorems",
       {"core", "parallel", "distributed", "off_the_shelf", "ref", "properties/checker", "properties/comparison",
        "properties/domains", "properties/defects"}},
      {"properties/mutants", {"core", "properties/checker", "properties/defects", "properties/theorems"}},
      {"cli", {"core", "parallel", "off_the_shelf", "properties/checker", "properties/domains"}},
      {"cli/harness", {"core", "properties/checker", "properties/domains", "cli"}},
      {"bindings/python", {"core", "parallel", "properties/checker", "properties/domains", "cli"}},
      {"mpi", {"core", "parallel", "distributed", "off_the_shelf", "properties/checker", "cli"}},
      {"fuzz",
       {"core", "parallel", "ref", "properties/checker", "properties/comparison", "properties/domains",
        "properties/defects", "properties/wrong_meshes", "properties/theorems", "cli"}},
      {"bench",
       {"core", "parallel", "distributed", "off_the_shelf", "ref", "properties/checker", "properties/domains", "cli",
        "mpi"}},
      {"examples",
       {"core", "parallel", "distributed", "off_the_shelf", "properties/checker", "properties/domains", "mpi"}},
      {"scripts", {}},
      {"tests",
       {"core", "parallel", "distributed", "off_the_shelf", "ref", "properties/checker", "properties/comparison",
        "properties/domains", "properties/defects", "properties/wrong_meshes", "properties/theorems",
        "properties/mutants", "cli", "cli/harness", "fuzz", "mpi", "bench"}},
  };
  return table;
}

/// The folders whose headers are public. Headers in their subfolders are not public.
const std::set<std::string, std::less<>> public_folders = {"core",
                                                           "parallel",
                                                           "distributed",
                                                           "off_the_shelf",
                                                           "properties/checker",
                                                           "properties/domains",
                                                           "properties/domains/generators"};

/// A room is a subfolder of a public folder; it is private. Rooms have an order: a room may include itself, rooms of a
/// lower rank in the same folder, and the folder's public headers. Files directly in the folder may include all its
/// rooms.
struct Room {
  std::string_view folder;
  std::string_view room;
  int rank;
  std::string_view name_space;  ///< the only namespace, with those inside it, that its headers open
};
const std::vector<Room>& rooms() {
  static const std::vector<Room> table = {
      {"core", "core/support", 0, "pardel"},
      {"core", "core/formats", 1, "pardel::files"},
      {"parallel", "parallel/arithmetic", 0, "pardel::engine"},
      {"parallel", "parallel/threads", 1, "pardel::engine"},
      {"parallel", "parallel/decomposition", 2, "pardel::engine"},
      {"parallel", "parallel/segments", 2, "pardel::engine"},
      {"parallel", "parallel/domain", 3, "pardel::engine"},
      {"parallel", "parallel/location", 3, "pardel::engine"},
      {"parallel", "parallel/sizing", 3, "pardel::engine"},
      {"parallel", "parallel/triangulation", 3, "pardel::engine"},
      {"parallel", "parallel/construction", 4, "pardel::engine"},
      {"parallel", "parallel/quality", 4, "pardel::engine"},
      {"parallel", "parallel/conversion", 5, "pardel::engine"},
      {"parallel", "parallel/diagnosis", 5, "pardel::engine"},
      {"parallel", "parallel/patches", 5, "pardel::engine"},
      {"parallel", "parallel/refinement", 5, "pardel::engine"},
      {"parallel", "parallel/scheduling", 6, "pardel::engine"},
      {"parallel", "parallel/filling", 7, "pardel::engine"},
      {"parallel", "parallel/planning", 8, "pardel::engine"},
      {"distributed", "distributed/subdomain", 0, "pardel::engine"},
      {"distributed", "distributed/delaunay", 1, "pardel::engine"},
      {"distributed", "distributed/cdt", 2, "pardel::engine"},
      {"distributed", "distributed/meshing", 2, "pardel::engine"},
      {"distributed", "distributed/divided_input", 3, "pardel::engine"},
      {"off_the_shelf", "off_the_shelf/subdomains", 0, "pardel::engine"},
      {"off_the_shelf", "off_the_shelf/schemes", 1, "pardel::engine"},
      {"off_the_shelf", "off_the_shelf/meshers", 1, "pardel::engine"},
      {"properties/domains", "properties/domains/generators/lattice", 0, "pardel::generators"},
      {"properties/checker", "properties/checker/arithmetic", 0, "pardel::checker"},
      {"properties/checker", "properties/checker/model", 1, "pardel::checker"},
      {"properties/checker", "properties/checker/stages", 2, "pardel::checker"},
      {"properties/checker", "properties/checker/pieces", 3, "pardel::checker"},
  };
  return table;
}

/// Allows `from` to include private headers of `to` from outside. Both are folders or files.
struct Exception {
  std::string_view from;
  std::string_view to;
  std::string_view reason;
};
const std::vector<Exception>& exceptions() {
  static const std::vector<Exception> table = {
      {"parallel", "core/support", "core/support is for all folders of the project"},
      {"distributed", "core/support", "core/support is for all folders of the project"},
      {"distributed", "parallel", "the ranks run the engine on their parts"},
      {"distributed", "off_the_shelf/schemes", "the ranks share the tasks of the schemes"},
      {"off_the_shelf", "core/support", "core/support is for all folders of the project"},
      {"off_the_shelf", "parallel", "the schemes work on the engine's triangulation"},
      {"ref", "core/support", "core/support is for all folders of the project"},
      {"properties", "core/support", "core/support is for all folders of the project"},
      {"cli", "core/support", "core/support is for all folders of the project"},
      {"bindings", "core/support", "core/support is for all folders of the project"},
      {"bindings/python/src/bind_voronoi.cpp", "parallel/arithmetic", "finds four points on one circle exactly"},
      {"mpi", "core/support", "core/support is for all folders of the project"},
      {"fuzz", "core/support", "core/support is for all folders of the project"},
      {"bench", "core/support", "core/support is for all folders of the project"},
      {"tests", "core/support", "core/support is for all folders of the project"},
      {"tests/core", "core/formats", "tests the rooms of core"},
      {"tests/parallel", "parallel", "tests the rooms of the engine"},
      {"tests/distributed", "distributed", "tests the rooms of the ranks"},
      {"tests/distributed", "parallel", "compares parts of ranks with the engine's arrays"},
      {"tests/off_the_shelf", "off_the_shelf", "tests the rooms of the schemes"},
      {"tests/off_the_shelf", "parallel", "takes parts out of the engine's triangulation"},
      {"tests/races", "parallel/threads", "proves that the sanitizer sees a race in the engine's own loops"},
      {"tests/properties/checker", "properties/checker", "tests the rooms of the checker"},
      {"tests/parallel", "properties/checker/arithmetic/exact.hpp", "compares the engine with exact arithmetic"},
      {"fuzz/predicates.cpp", "parallel/arithmetic", "compares the predicates and expansions with rational numbers"},
      {"fuzz/many_signs", "parallel/arithmetic", "compares the predicates with exact signs"},
      {"fuzz/many_signs", "properties/checker/arithmetic", "compares the filters of the checker with exact signs"},
      {"fuzz/with_schedule.hpp", "parallel", "runs the tasks of the refinement in a given order"},
      {"properties/theorems/refinement/ranks_discards_test.cpp", "distributed",
       "begins with parts, to count what is discarded"},
      {"properties/theorems/refinement/ranks_discards_test.cpp", "parallel/scheduling", "counts what one run discards"},
      {"properties/theorems/refinement/ranks_messages_test.cpp", "distributed/meshing",
       "reads the messages of a phase"},
      {"properties/theorems/refinement/ranks_messages_test.cpp", "parallel", "looks at the mesh after each phase"},
      {"properties/defects", "properties/checker/arithmetic", "a defect is made, and proved, in exact arithmetic"},
      {"properties/wrong_meshes/drawing.cpp", "properties/checker/arithmetic/exact.hpp",
       "triangles of a wrong mesh are Delaunay, except where they are meant not to be"},
      {"bench/predicates_bench.cpp", "parallel/arithmetic/predicates.hpp", "measures the predicates alone"},
      {"bench/model", "distributed", "replays the run of one process as that of many ranks"},
      {"bench/model", "parallel", "replays the run of one process as that of many ranks"},
      {"bench/workloads", "parallel/arithmetic", "measures the predicates alone, and each stage of them"},
      {"bench/workloads", "parallel/construction", "measures insertions without the rest of a triangulation"},
  };
  return table;
}

/// Longer classes of the engine and of the ranks need a reason.
constexpr int most_lines_of_a_class = 200;

struct LongClass {
  std::string_view file;
  std::string_view name;
  std::string_view reason;
};
const std::vector<LongClass>& long_classes() {
  static const std::vector<LongClass> table = {
      {"parallel/sizing/feature_sources.cpp", "Features", "one pass over all features, with one list of sources"},
      {"parallel/segments/plane_sweep.cpp", "PlaneSweep", "one algorithm on one state: agenda, status and results"},
      {"distributed/delaunay/piece_of_points.cpp", "PointsPieceMaker", "steps that fill one piece"},
      {"distributed/divided_input/part_of_domain.cpp", "PartMaker", "steps that fill one part"},
      {"distributed/meshing/filled_pieces.cpp", "FilledPieceMaker", "steps that fill one piece"},
  };
  return table;
}

// ---------------------------------------------------------------------------------------------------------------------
// The rules.

bool lies_in(std::string_view path, std::string_view folder) {
  return path == folder || (path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/');
}

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

const Layer* layer_of(std::string_view file) {
  const Layer* longest = nullptr;
  for (const Layer& layer : layers())
    if (lies_in(file, layer.folder) && (longest == nullptr || layer.folder.size() > longest->folder.size()))
      longest = &layer;
  return longest;
}

const Room* room_of(std::string_view file) {
  const auto room = std::find_if(rooms().begin(), rooms().end(), [&](const Room& r) { return lies_in(file, r.room); });
  return room == rooms().end() ? nullptr : &*room;
}

bool is_header(std::string_view file) { return file.ends_with(".hpp"); }
bool is_public_header(const std::string& file) { return is_header(file) && public_folders.contains(folder_of(file)); }

/// True for a header below a public folder that is not public itself.
bool is_private_header(const std::string& file) {
  return is_header(file) && !is_public_header(file) &&
         std::any_of(public_folders.begin(), public_folders.end(), [&](const auto& f) { return lies_in(file, f); });
}

const Exception* exception_for(std::string_view from, std::string_view to) {
  const auto found = std::find_if(exceptions().begin(), exceptions().end(),
                                  [&](const Exception& e) { return lies_in(from, e.from) && lies_in(to, e.to); });
  return found == exceptions().end() ? nullptr : &*found;
}

/// The reason why `from` may not include `to`; nothing if `from` may include `to`.
std::optional<std::string> objection(const SourceTree& tree, const std::string& from, const std::string& to) {
  if (!tree.contains(to)) return "there is no such file";
  const Layer* mine = layer_of(from);
  const Layer* theirs = layer_of(to);
  if (mine == nullptr || theirs == nullptr)
    return "a file its folder is not in the list of folders (tests/structure/rules.cpp)";
  if (mine == theirs) {
    const Room* room = room_of(from);
    const Room* included = room_of(to);
    if (is_public_header(from) && !is_public_header(to)) return "a public header includes a private one";
    if (room != nullptr && included != nullptr && room != included && room->rank <= included->rank)
      return "it is not below " + std::string(room->room) + " in the order of rooms";
    if (room != nullptr && included == nullptr && !is_public_header(to))
      return "a room includes a source of its folder";
    return std::nullopt;
  }
  if (std::find(mine->may_include.begin(), mine->may_include.end(), theirs->folder) == mine->may_include.end())
    return std::string(mine->folder) + " may not use " + std::string(theirs->folder);
  if (is_private_header(to)) {
    if (is_public_header(from)) return "a public header includes a private one";
    if (exception_for(from, to) == nullptr) return "the header is private to " + std::string(theirs->folder);
  }
  return std::nullopt;
}

/// Appends the cycles of includes. `path` is a chain of includes from a visited file to `file`.
void find_circles(const SourceTree& tree, const std::string& file, std::vector<std::string>& path,
                  std::set<std::string>& done, std::vector<std::string>& found) {
  if (const auto again = std::find(path.begin(), path.end(), file); again != path.end()) {
    std::string circle;
    for (auto step = again; step != path.end(); ++step) circle += *step + " -> ";
    found.push_back(circle + file + ": files include each other in a circle");
    return;
  }
  const auto source = tree.find(file);
  if (source == tree.end() || done.contains(file)) return;
  path.push_back(file);
  for (const Include& include : source->second.includes) find_circles(tree, include.target, path, done, found);
  path.pop_back();
  done.insert(file);
}

void check_namespaces(const std::string& file, const SourceFile& source, std::vector<std::string>& found) {
  const Room* room = room_of(file);
  if (room == nullptr || !is_header(file)) return;
  for (const std::string& name : source.namespaces)
    if (name != room->name_space && !name.starts_with(std::string(room->name_space) + "::"))
      found.push_back(file + ": opens namespace " + name + ", but the namespace of its room is " +
                      std::string(room->name_space));
}

void check_classes(const std::string& file, const SourceFile& source, std::vector<std::string>& found) {
  if (!lies_in(file, "parallel") && !lies_in(file, "distributed") && !lies_in(file, "off_the_shelf")) return;
  for (const Class& each : source.classes) {
    const bool has_reason = std::ranges::any_of(
        long_classes(), [&](const LongClass& known) { return known.file == file && known.name == each.name; });
    if (has_reason == (each.lines > most_lines_of_a_class)) continue;
    found.push_back(file + ":" + std::to_string(each.line) + ": class " + each.name + " has " +
                    std::to_string(each.lines) + " lines" +
                    (has_reason ? " and needs no reason" : ", more than " + std::to_string(most_lines_of_a_class)));
  }
}

}  // namespace

std::vector<std::string> violations(const SourceTree& tree) {
  std::vector<std::string> found;
  for (const auto& [file, source] : tree) {
    if (layer_of(file) == nullptr)
      found.push_back(file + ": its folder is not in the list of folders (tests/structure/rules.cpp)");
    if (is_private_header(file) && room_of(file) == nullptr)
      found.push_back(file + ": its folder is not in the list of rooms (tests/structure/rules.cpp)");
    for (const Include& include : source.includes)
      if (const auto reason = objection(tree, file, include.target))
        found.push_back(file + ":" + std::to_string(include.line) + ": includes " + include.target + ": " + *reason);
    check_namespaces(file, source, found);
    check_classes(file, source, found);
  }
  std::set<std::string> done;
  std::vector<std::string> path;
  for (const auto& [file, source] : tree) find_circles(tree, file, path, done, found);
  return found;
}

std::vector<std::string> unused_exceptions(const SourceTree& tree) {
  std::set<const Exception*> used;
  for (const auto& [file, source] : tree)
    for (const Include& include : source.includes)
      if (layer_of(file) != layer_of(include.target) && is_private_header(include.target))
        used.insert(exception_for(file, include.target));
  std::vector<std::string> unused;
  for (const Exception& e : exceptions())
    if (!used.contains(&e)) unused.push_back(std::string(e.from) + " -> " + std::string(e.to));
  return unused;
}

std::vector<std::string> drawing(const SourceTree& tree) {
  std::map<std::string, int> arrows;
  for (const auto& [file, source] : tree)
    for (const Include& include : source.includes)
      if (folder_of(file) != folder_of(include.target)) ++arrows[folder_of(file) + " -> " + folder_of(include.target)];
  std::vector<std::string> lines;
  for (const auto& [arrow, count] : arrows) lines.push_back(arrow + " " + std::to_string(count));
  return lines;
}

}  // namespace pardel::structure
