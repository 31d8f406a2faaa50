#include "../program_mesher.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

#include "../../core/formats.hpp"
#include "../../core/support/child_process.hpp"
#include "../../core/support/programs.hpp"
#include "../../core/support/shell_words.hpp"
#include "../../core/support/shortest.hpp"
#include "../../core/support/work_folder.hpp"
#include "../subdomains/box_of.hpp"
#include "../subdomains/without_triangles.hpp"
#include "area_caps.hpp"
#include "task_files.hpp"

namespace pardel {

namespace fs = std::filesystem;
using namespace engine;

namespace {

using Answer = RefinedSubdomain::Ending;

struct NamedProgram {
  std::string_view name;
  MesherProgram program;
};

std::vector<NamedProgram> all_named() {
  // r refines the mesh, p reads the segments, YY splits none of them, a reads the caps. B, P and Q: no markers, no
  // .poly, no messages.
  const std::string switches = " -rpBPQYYq{min-angle}aS{max-points} {mesh}";
  return {
      {"triangle",
       {"triangle" + switches,
        "ele",
        {0},
        false,
        "Debian has it in non-free, as triangle-bin (scripts/install-packages peers)"}},
      // Exit code 4 means: the files are written, and a bound is missed.
      {"pardel-triangle", {"pardel triangle" + switches, "ele", {0, 4}, true, "build the target pardel"}},
  };
}

Result<fs::path> find_mesher(const std::string& word) {
  const bool is_name = word.find('/') == std::string::npos;
  if (fs::path own = is_name ? beside_this_program(word) : fs::path(); !own.empty()) return own;
  return find_program(word);
}

bool uses(const std::vector<std::string>& words, std::string_view placeholder) {
  return std::any_of(words.begin() + 1, words.end(),
                     [&](const std::string& word) { return word.find(placeholder) != std::string::npos; });
}

/// The largest cap; for triangles without one, the area of the box around the subdomain.
double largest_cap(const Subdomain& subdomain, const std::vector<double>& caps) {
  const double largest = caps.empty() ? INFINITY : *std::ranges::max_element(caps);
  if (largest < INFINITY) return largest;
  const Box box = box_of(subdomain);
  return (box.max_x - box.min_x) * (box.max_y - box.min_y);
}

/// A task of a program.
class ProgramTask {
 public:
  ProgramTask(const std::vector<std::string>& words, const MesherProgram& program, const Subdomain& subdomain,
              const fs::path& folder)
      : words_(words), program_(program), subdomain_(subdomain), folder_(folder) {}

  RefinedSubdomain run() const {
    const std::vector<double> caps = area_caps(subdomain_);
    if (Status written = write_task(subdomain_, caps, stem(), uses(words_, "{poly}")); !written)
      return without_triangles(Answer::failed, written.error().message);
    return answer(run_child(command(caps), log(), limits(), [] { return false; }));
  }

 private:
  [[nodiscard]] fs::path stem() const { return folder_ / "part"; }
  [[nodiscard]] fs::path out() const { return folder_ / ("part.1." + program_.suffix); }
  [[nodiscard]] fs::path log() const { return folder_ / "log"; }

  [[nodiscard]] std::vector<std::string> command(const std::vector<double>& caps) const {
    const std::array<std::pair<std::string_view, std::string>, 6> values{{
        {"{mesh}", stem().string()},
        {"{poly}", stem().string() + ".poly"},
        {"{out}", out().string()},
        {"{min-angle}", fixed(subdomain_.goal.min_angle_deg)},
        {"{max-area}", fixed(largest_cap(subdomain_, caps))},
        {"{max-points}", std::to_string(subdomain_.most_new_points)},
    }};
    std::vector<std::string> words = words_;
    for (std::size_t i = 1; i < words.size(); ++i) words[i] = filled_in(words[i], values);
    return words;
  }

  [[nodiscard]] ChildLimits limits() const {
    // A program that goes wild must not fill the disk.
    constexpr std::uint64_t bytes_per_point = 1024, spare = std::uint64_t{1} << 26U;
    const std::uint64_t points = subdomain_.points.size() + subdomain_.most_new_points;
    return {.seconds = subdomain_.seconds, .file_bytes = bytes_per_point * points + spare, .one_thread = true};
  }

  [[nodiscard]] RefinedSubdomain answer(const ChildRun& run) const {
    switch (run.ending) {
      case ChildEnding::not_started:
        return without_triangles(Answer::failed, std::string("no process: ") + std::strerror(run.number));
      case ChildEnding::interrupted:
      case ChildEnding::timed_out:
        return without_triangles(Answer::timed_out, "no answer within " + shortest(subdomain_.seconds) + " s");
      case ChildEnding::signalled:
        return without_triangles(Answer::crashed, said_after(signal_name(run.number)));
      case ChildEnding::exited:
        break;
    }
    if (std::ranges::find(program_.success_codes, run.number) == program_.success_codes.end())
      return without_triangles(Answer::crashed, said_after("exit code " + std::to_string(run.number)));
    return read();
  }

  [[nodiscard]] RefinedSubdomain read() const {
    std::error_code ignored;
    if (!fs::exists(out(), ignored))
      return without_triangles(Answer::unreadable, said_after("it did not write " + out().filename().string()));
    if (const std::string odd = not_a_file(); !odd.empty())
      return without_triangles(Answer::unreadable, odd + " is not a regular file");
    const Result<Mesh> mesh = read_mesh(out());
    if (!mesh) return without_triangles(Answer::unreadable, replaced(mesh.error().message, folder_.string() + '/', ""));
    return answer_of(*mesh, subdomain_);
  }

  /// The name of an answer's file that is a pipe, a device or the like, which might never end; empty if there is none.
  [[nodiscard]] std::string not_a_file() const {
    std::error_code error;
    for (fs::directory_iterator file(folder_, error), end; !error && file != end; file.increment(error)) {
      const std::string name = file->path().filename().string();
      if (name.starts_with("part.1.") && !file->is_regular_file(error)) return name;
    }
    return "";
  }

  /// What has happened, and the words of the program.
  [[nodiscard]] std::string said_after(const std::string& what) const {
    const std::string said = telling_line(log(), folder_);
    return said.empty() ? what : what + ": " + said;
  }

  const std::vector<std::string>& words_;
  const MesherProgram& program_;
  const Subdomain& subdomain_;
  const fs::path& folder_;
};

class ProgramMesher final : public SubdomainMesher {
 public:
  ProgramMesher(MesherProgram program, std::vector<std::string> words)
      : program_(std::move(program)), words_(std::move(words)) {}

  [[nodiscard]] MesherAbilities abilities() const override {
    return {.obeys_cell = false,
            .keeps_frozen_edges = true,
            .splits_segments = false,
            .exempts_small_angles = program_.exempts_small_angles,
            .is_thread_safe = true};
  }

  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    WorkFolder folder;
    if (Status made = folder.make("pardel-task"); !made) return without_triangles(Answer::failed, made.error().message);
    return ProgramTask(words_, program_, subdomain, folder.path()).run();
  }

 private:
  MesherProgram program_;
  std::vector<std::string> words_;
};

}  // namespace

std::optional<MesherProgram> named_program(std::string_view name) {
  for (NamedProgram& each : all_named())
    if (each.name == name) return std::move(each.program);
  return {};
}

std::vector<std::string> named_programs() {
  std::vector<std::string> names;
  for (const NamedProgram& each : all_named()) names.emplace_back(each.name);
  return names;
}

Result<std::unique_ptr<SubdomainMesher>> program_mesher(const MesherProgram& program) {
  Result<std::vector<std::string>> words = split_words(program.command);
  if (!words) return words.error();
  if (words->empty() || !(uses(*words, "{mesh}") || uses(*words, "{poly}")))
    return Error{ErrorKind::usage, "'" + program.command +
                                       "' is no command with the argument {mesh} or {poly}, which stands for the files "
                                       "to read"};
  const Result<fs::path> found = find_mesher(words->front());
  if (!found)
    return Error{ErrorKind::io, found.error().message + (program.obtained.empty() ? "" : "; " + program.obtained)};
  words->front() = *found;
  return std::unique_ptr<SubdomainMesher>(std::make_unique<ProgramMesher>(program, std::move(*words)));
}

}  // namespace pardel
