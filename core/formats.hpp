// Files: Triangle's formats, VTU, Gmsh MSH 4.1, OFF, SVG. Numbers are written so that they read back to
// the same double. A writer never leaves a partial file under the final name: it writes `NAME.partial`
// beside it and renames on success (targets that are no regular files, /dev/stdout say, are written to
// directly). Every error names the file, and for text the line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mesh.hpp"
#include "pslg.hpp"
#include "result.hpp"

namespace pardel {

/// Triangle's .poly (its .node beside it when its point section is empty), or a bare .node. Points must be
/// numbered consecutively from 0 or 1; the numbers of segments, holes and regions mean nothing. Coordinates and
/// attributes must be finite. What follows the fields of a line, or the last section, is ignored.
[[nodiscard]] Result<Pslg> read_pslg(const std::filesystem::path& file);
/// The same from text; `name` stands for the file in messages. A .poly whose points lie in a .node is refused.
[[nodiscard]] Result<Pslg> parse_poly(std::string_view text, const std::string& name);

/// base: 0 or 1, the number of the first vertex, in all Triangle files.
[[nodiscard]] Status write_poly(const Pslg& pslg, const std::filesystem::path& file, int base = 1);

/// A mesh that any program wrote, by suffix. Indices are in range and numbers finite; nothing else is certain
/// (triangles may be clockwise, flat or overlap): that is for the checker. Neighbours are rebuilt from the
/// triangles; where an edge has more than two, the neighbours of the surplus ones are no_index. Region
/// attributes are ascending. z is ignored. Where the format has no constrained edges, there are none.
///   .node, .ele  either name means both. Constrained edges from the .poly beside them if that has no points of
///                its own, else from the marked edges of the .edge. A .neigh must agree with the triangles.
///   .msh         4.1, ASCII or binary, and 2.x ASCII. Triangles; lines are constrained edges; points are
///                passed over. Attribute and marker are X and N for physical groups named `region X` and
///                `marker N`, else the group's tag. No markers or attributes of points.
///   .vtu         one uncompressed piece, arrays as text, base64 or raw. Triangles; lines (and our own arrays)
///                are constrained edges. Cell array `region`, point arrays `marker` and `attributes`.
///   .off         triangles only, nothing else.
[[nodiscard]] Result<Mesh> read_mesh(const std::filesystem::path& file);

enum class MshEncoding : std::uint8_t { ascii, binary };

/// By suffix: .node or .ele writes .node, .ele and .poly (all or, on an error, none); .vtu; .msh (as `msh` says);
/// .off; .svg.
/// Preconditions, here and for all writers of meshes: indices are in range, per-point and per-triangle arrays
/// have their lengths, and for .edge, .neigh and second order the neighbours are right.
[[nodiscard]] Status write_mesh(const Mesh& mesh, const Pslg& pslg, const std::filesystem::path& file,
                                MshEncoding msh = MshEncoding::binary);

/// All the files that write_mesh makes of this one name.
[[nodiscard]] std::vector<std::string> written_files(const std::filesystem::path& file);

/// True where write_mesh knows the suffix.
[[nodiscard]] bool is_mesh_suffix(const std::filesystem::path& file);

/// What Triangle's switches can leave out or add.
struct TriangleFiles {
  int base = 1;
  bool write_node = true;
  bool write_ele = true;
  bool write_poly = true;  ///< vertex count 0, constrained edges as segments, holes and regions
  bool write_edge = false;
  bool write_neigh = false;
  bool markers = true;
  bool holes = true;          ///< in the .poly
  bool second_order = false;  ///< six-node .ele: mid-edge nodes are appended to the .node
};
/// Writes stem.node, stem.ele, ... as `files` says. Vertices without markers of their own get those of
/// constrained edges at them.
[[nodiscard]] Status write_triangle_files(const Mesh& mesh, const Pslg& pslg, const std::filesystem::path& stem,
                                          const TriangleFiles& files);

/// Triangle's .area file: one cap per triangle, +infinity where the file says negative.
[[nodiscard]] Result<std::vector<double>> read_area(const std::filesystem::path& file);
/// The same, written: cap i is that of triangle base + i, +infinity is written as -1. Precondition: caps are positive.
[[nodiscard]] Status write_area(const std::filesystem::path& file, std::span<const double> caps, int base = 1);
/// One positive number per input vertex, Triangle-like: `n` then `i size`.
[[nodiscard]] Result<std::vector<double>> read_sizes(const std::filesystem::path& file);

/// Each region's attribute and each marker is a physical group (`region X`, `marker N`; `domain` for triangles
/// without a region), its tag the number itself where that is a positive int. Vertices keep their order by tag,
/// triangles are grouped by region.
[[nodiscard]] Status write_msh(const Mesh& mesh, const std::filesystem::path& file, MshEncoding encoding);
/// Version 1.0, appended raw, UInt64 headers. Cell arrays `region` (attribute) and `quality` (smallest angle in
/// degrees), point arrays `marker` and `attributes`; constrained edges and their markers as field data.
[[nodiscard]] Status write_vtu(const Mesh& mesh, const std::filesystem::path& file);
[[nodiscard]] Status write_off(const Mesh& mesh, const std::filesystem::path& file);
/// Triangles are filled by region.
[[nodiscard]] Status write_svg(const Mesh& mesh, const std::filesystem::path& file);
/// Triangle i is filled with hue hues[i], in degrees below 360, or left white.
inline constexpr std::uint16_t no_hue = 360;
[[nodiscard]] Status write_svg(const Mesh& mesh, std::span<const std::uint16_t> hues,
                               const std::filesystem::path& file);
[[nodiscard]] Status write_svg(const Pslg& pslg, const std::filesystem::path& file);

}  // namespace pardel
