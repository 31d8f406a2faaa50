// Refining a mesh that meets the goal changes nothing, whoever made it and through whatever file it came. A mesh that
// does not meet the goal does so after one refinement.
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../core/formats.hpp"
#include "../../../core/join_pieces.hpp"
#include "../../../distributed/distributed.hpp"
#include "../framework/local_ranks.hpp"
#include "../framework/shares.hpp"
#include "turned_problems.hpp"

namespace pardel::properties {
namespace {

namespace fs = std::filesystem;

constexpr const char* again_source = "properties/THEORY.md, refining again";
constexpr const char* again_families =
    "lattice domains of every family, also turned; wedges; random goals; all formats";

/// Two to four segments that leave one point at small angles, in a square. Some have a point in the middle.
Pslg some_wedge() {
  const auto part = [](int from, int to) { return 0.01 * *rc::gen::inRange(from, to); };
  const Point apex{part(-50, 50), part(-50, 50)};
  Pslg pslg;
  pslg.points = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}, apex};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  double angle = part(0, 628);
  const auto add = [&](Point p, Index from) {
    pslg.points.push_back(p);
    pslg.segments.push_back({from, static_cast<Index>(pslg.points.size() - 1)});
    return pslg.segments.back().b;
  };
  for (int arms = *rc::gen::inRange(2, 5); arms > 0; --arms) {
    const double length = part(20, 140);
    const Point end{apex.x + length * std::cos(angle), apex.y + length * std::sin(angle)};
    const bool is_divided = *rc::gen::arbitrary<bool>();
    const Index from = is_divided ? add({(apex.x + end.x) / 2, (apex.y + end.y) / 2}, 4) : 4;
    add(end, from);
    angle += std::exp2(-*rc::gen::inRange(0, 12));
  }
  return pslg;
}

Goal some_goal(const generators::LatticeDomain& domain) {
  const auto make = [domain](generators::Random& random, int) { return generators::any_goal(domain, random); };
  const generators::LatticeGoal drawn = *generators::generator(make, generators::shrinks_of);
  Goal goal = to_goal(drawn, domain);
  goal.region_caps = false;  // a Mesh does not store area caps
  return goal;
}

/// A domain, a goal for a first mesh, and one for its refinement.
struct TwoGoals {
  Pslg pslg;
  Goal first, second;
};

TwoGoals some_two_goals(Exhibit& exhibit) {
  TwoGoals drawn;
  const int kind = *rc::gen::inRange(0, 3);
  if (kind == 0) {
    const generators::Case c = some_case(exhibit);
    drawn = {to_pslg(c.domain), to_goal(c.goal, c.domain), some_goal(c.domain)};
    drawn.first.region_caps = false;
  } else {
    const Problem problem = kind == 1 ? some_turned_problem(exhibit) : Problem{some_wedge(), {}};
    RC_PRE(find_problems(problem.pslg).empty());
    const auto goal = [&] {
      return Goal{.min_angle_deg = *rc::gen::element(0.0, 20.0, 28.0), .conforming = *rc::gen::inRange(0, 3) == 0};
    };
    drawn = {problem.pslg, goal(), goal()};
    if (kind == 2) drawn.second.max_area = *rc::gen::element(Goal{}.max_area, 0.1, 0.02);
  }
  if (*rc::gen::inRange(0, 4) == 0) {
    double extent = 0;
    for (const Point p : drawn.pslg.points) extent = std::max(extent, std::abs(p.x - drawn.pslg.points[0].x));
    drawn.second.max_edge = extent / *rc::gen::inRange(1, 12);
  }
  exhibit.show(drawn.pslg);
  return drawn;
}

/// A folder that ends with this object.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("pardel-refining-again-" + std::to_string(::getpid()))) {
    fs::create_directory(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }
  [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

struct Format {
  const char* file;
  MshEncoding msh = MshEncoding::binary;
};
Format some_format() {
  return *rc::gen::elementOf(std::vector<Format>{
      {""}, {"mesh.node"}, {"mesh.vtu"}, {"mesh.off"}, {"mesh.msh"}, {"text.msh", MshEncoding::ascii}});
}

/// The mesh after it was written and read; in memory if the name of the file is empty.
Mesh through(const Format& format, const Mesh& mesh, const Pslg& pslg) {
  if (*format.file == '\0') return mesh;
  const Folder folder;
  const Status written = write_mesh(mesh, pslg, folder / format.file, format.msh);
  if (!written) RC_FAIL(written.error().message);
  Result<Mesh> read = read_mesh(folder / format.file);
  if (!read) RC_FAIL(read.error().message);
  return std::move(read).value();
}

void require_unchanged(const Mesh& mesh, const Goal& goal, const Options& options) {
  const Meshed again = value_of(refine(mesh, {}, goal, options));
  RC_ASSERT(again.report.inserted + again.report.segment_splits == 0U);
  RC_ASSERT(again.report.goal_met());
  RC_ASSERT(again.mesh.points == mesh.points);
  RC_ASSERT(again.mesh.triangles == mesh.triangles);
  RC_ASSERT(again.mesh.point_attributes == mesh.point_attributes);
  RC_ASSERT(digest(again.mesh) == digest(mesh));
}

PARDEL_PROPERTY(Refinement, of_a_certified_mesh_changes_nothing_in_any_format,
                {.statement = "A mesh is made for one goal, written, read, and refined for another one. If the checker "
                              "certifies the mesh for the second goal, nothing changes. If not, the refined mesh is "
                              "certified for it, is written, read and refined again, and nothing changes.",
                 .source = again_source,
                 .families = again_families}) {
  const TwoGoals drawn = some_two_goals(exhibit);
  const Options options = some_options();
  const Format format = some_format();
  const Mesh made = meshed({drawn.pslg, drawn.first}, exhibit, options).mesh;
  const Mesh read = through(format, made, drawn.pslg);
  require_unchanged(read, drawn.first, options);

  const CheckOptions foreign{.foreign = true};
  const bool is_met = check(drawn.pslg, read, drawn.second, foreign).valid;
  classify(is_met, "meets the second goal", 20);
  if (is_met) return require_unchanged(read, drawn.second, options);
  Meshed refined = value_of(refine(read, {}, drawn.second, options));
  // No file says on which segments vertices lie, and some do not have the markers of input points.
  if (read.origin.empty()) refined.mesh.origin.clear();
  if (read.point_markers.empty()) refined.mesh.point_markers.clear();
  exhibit.show(drawn.pslg, refined.mesh);
  classify(!refined.report.exempt.empty(), "exempt triangles", 5);
  RC_ASSERT(refined.report.goal_met());
  require_valid(check(drawn.pslg, refined.mesh, drawn.second, foreign));
  require_unchanged(through(format, refined.mesh, drawn.pslg), drawn.second, options);
}

PARDEL_PROPERTY(Refinement, of_a_mesh_of_several_ranks_changes_nothing,
                {.statement = "Two to four ranks make a mesh; its pieces are joined, written, read, and refined with "
                              "the same goal. Nothing changes.",
                 .source = again_source,
                 .families = again_families}) {
  const TwoGoals drawn = some_two_goals(exhibit);
  Options options = some_options();
  options.triangles_per_tile = 10;
  const ValidPslg domain = std::move(validate(drawn.pslg)).value();
  std::vector<NumberedMesh> pieces(*rc::gen::inRange<std::size_t>(2, 5));
  on_ranks(static_cast<int>(pieces.size()), [&](pardel::Ranks& ranks) {
    Result<MeshPiece> piece = mesh(domain, drawn.first, options, ranks);
    if (piece) pieces[static_cast<std::size_t>(ranks.rank())] = {std::move(piece->mesh), std::move(piece->number)};
  });
  std::erase_if(pieces, [](const NumberedMesh& piece) { return piece.mesh.points.empty(); });
  const Result<Mesh> joined = join_pieces(pieces);
  if (!joined) RC_FAIL(joined.error().message);
  require_unchanged(through(some_format(), *joined, drawn.pslg), drawn.first, options);
}

}  // namespace
}  // namespace pardel::properties
