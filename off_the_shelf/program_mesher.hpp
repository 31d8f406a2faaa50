// Programs as meshers. Each task is a process that reads and writes files in a temporary folder of its own.
//
//     const auto mesher = program_mesher(*named_program("triangle"));
//     if (!mesher) std::cerr << mesher.error().message << '\n';
//     else result = mesh_with_mesher(domain, {.min_angle_deg = 25, .max_area = 1e-4}, **mesher);
//
// The folder and all files in it are removed when the process has ended, whatever it has done.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../core/result.hpp"
#include "subdomain_mesher.hpp"

namespace pardel {

/// A program that refines a mesh in Triangle's files. A subdomain becomes four files of one name, numbered from 1:
///   part.node  its points, without attributes and markers
///   part.ele   its triangles, without attributes
///   part.poly  all SubdomainEdges as segments: no point may be put on one. Marker 1: on the border, 0: inside. The
///              points are those of the .node. A point in each hole, if the command uses {poly}.
///   part.area  the largest area of each triangle, or -1: the least that Subdomain::max_areas, Goal::max_area, and as
///              longest edges Goal::max_edge and Goal::size at the centroid allow. A longest edge stands for the area
///              of the equilateral triangle.
/// The program writes part.1.SUFFIX: first the points of part.node, bit for bit and in their order, then new ones; all
/// triangles counter-clockwise.
struct MesherProgram {
  /// The program and its arguments, split as by a shell, but without variables, wildcards and pipes. The program is a
  /// path, or a name, which is looked up in the folder of the running executable and then on the PATH. In arguments
  ///   {mesh}       is the path of the four files, without their suffixes
  ///   {poly}       is the path of part.poly
  ///   {out}        is the path of the file to write; programs may also choose this name themselves, as Triangle does
  ///   {min-angle}  is the bound on angles in degrees
  ///   {max-area}   is the largest cap in part.area or, if a triangle has none, an area that no triangle exceeds
  ///   {max-points} is the most new points
  /// Numbers have no exponents: Triangle reads -a1e-5 as -a1.
  std::string command;
  std::string suffix = "ele";         ///< of the file that it writes, in a format of read_mesh(); ele: .node and .ele
  std::vector<int> success_codes{0};  ///< the exit codes that mean: the files are written
  bool exempts_small_angles = false;  ///< see MesherAbilities
  std::string obtained{};             ///< how to get the program: the end of the message if it is missing
};

/// The program that has this name; empty for other names.
///   triangle         Shewchuk's Triangle, found on the PATH
///   pardel-triangle  the subcommand `triangle` of the program `pardel`
[[nodiscard]] std::optional<MesherProgram> named_program(std::string_view name);
/// The names that named_program() knows.
[[nodiscard]] std::vector<std::string> named_programs();

/// A mesher that runs the program. It keeps frozen edges, splits no segments, does not obey cells, and is thread-safe.
/// A process gets OMP_NUM_THREADS=1. It is killed, with all processes of its group, after Subdomain::seconds. Its
/// standard input is empty; what it prints is shown only if it fails: the line with "error", or the last one.
/// Errors: `usage` if the command cannot be split, or has neither {mesh} nor {poly} in its arguments; `io` if the
/// program does not exist.
[[nodiscard]] Result<std::unique_ptr<SubdomainMesher>> program_mesher(const MesherProgram& program);

}  // namespace pardel
