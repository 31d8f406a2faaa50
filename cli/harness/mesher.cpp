#include "mesher.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "../../core/support/programs.hpp"
#include "../../core/support/shell_words.hpp"
#include "../../core/support/shortest.hpp"

namespace pardel::harness {
namespace fs = std::filesystem;
namespace {

struct Adaptor {
  const char* name;
  const char* command;
  const char* area_words;  ///< the arguments for an area bound
  const char* suffix;
  std::vector<int> success_codes;
  const char* needs;     ///< a program that must be on the PATH, or ""
  const char* obtained;  ///< how to get the missing program
};

const std::vector<Adaptor>& adaptors() {
  static const std::vector<Adaptor> all = {
      // Exit code 4 of pardel means: it wrote a mesh that misses a bound. The checker examines this mesh.
      {"pardel",
       "pardel mesh {poly} -o {out} --quiet --threads 1 --min-angle {min-angle}",
       " --max-area {max-area}",
       "ele",
       {0, 4},
       "",
       "build the target pardel"},
      {"cgal",
       "pardel-cgal {poly} {out} {min-angle}",
       " {max-area}",
       "off",
       {0},
       "",
       "it is built with the benchmarks (cmake --preset bench), because CGAL's Mesh_2 is under the GPL"},
      {"gmsh", "pardel-gmsh {poly} {out}", " {max-area}", "msh", {0}, "gmsh", "run scripts/install-packages test"},
      {"triangle",
       "pardel-triangle {poly} {min-angle}",
       " {max-area}",
       "ele",
       {0},
       "triangle",
       "Debian has it in non-free, as triangle-bin"},
  };
  return all;
}

Result<Mesher> adapted(const Adaptor& adaptor, bool with_area) {
  const std::string line = std::string(adaptor.command) + (with_area ? adaptor.area_words : "");
  Mesher mesher{*split_words(line), adaptor.suffix, adaptor.success_codes, line};
  const fs::path program = beside_this_program(mesher.words[0]);
  const bool lacks = *adaptor.needs != '\0' && on_path(adaptor.needs).empty();
  if (program.empty() || lacks) {
    return Error{ErrorKind::io,
                 fmt::format("--mesher {}: the program '{}' is not {}; {}", adaptor.name,
                             lacks ? adaptor.needs : mesher.words[0],
                             lacks ? "on the PATH" : "in the folder of pardel-harness", adaptor.obtained)};
  }
  mesher.words[0] = program;
  return mesher;
}

}  // namespace

Result<Mesher> find_mesher(const std::string& command, const std::string& suffix, bool with_area) {
  for (const Adaptor& adaptor : adaptors()) {
    if (command == adaptor.name) return adapted(adaptor, with_area);
  }
  const Result<std::vector<std::string>> words = split_words(command);
  if (!words) return Error{ErrorKind::usage, "--mesher: " + words.error().message};
  if (command.find("{poly}") == std::string::npos || words->front().find("{poly}") != std::string::npos) {
    return Error{
        ErrorKind::usage,
        fmt::format("--mesher: '{}' is neither the name of an adaptor nor a command with the argument {{poly}}, which "
                    "stands for the name of the input",
                    command)};
  }
  Mesher mesher{*words, suffix, {0}, command};
  const Result<fs::path> program = find_program(mesher.words[0]);
  if (!program) return Error{ErrorKind::io, "--mesher: " + program.error().message};
  mesher.words[0] = *program;
  return mesher;
}

std::string adaptors_text() {
  std::string text;
  for (const Adaptor& adaptor : adaptors()) text += fmt::format("  {:<10}{}\n", adaptor.name, adaptor.command);
  return text;
}

std::vector<std::string> command(const Mesher& mesher, const fs::path& poly, const fs::path& out, const Goal& goal) {
  std::vector<std::string> words = mesher.words;
  const std::pair<std::string_view, std::string> values[] = {{"{poly}", poly.string()},
                                                             {"{out}", out.string()},
                                                             {"{min-angle}", fixed(goal.min_angle_deg)},
                                                             {"{max-area}", fixed(goal.max_area)}};
  for (std::size_t i = 1; i < words.size(); ++i) words[i] = filled_in(words[i], values);
  return words;
}

}  // namespace pardel::harness
