// Files: Triangle's formats, VTU, Gmsh MSH 4.1, OFF, SVG. Numbers are written so that they read back to
// the same double. A writer never leaves a partial file under the final name: it writes `NAME.partial`
// beside it and renames on success (targets that are no regular files, /dev/stdout say, are written to
// directly). Every error names the file, and for text the line.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mesh.hpp"
#include "pslg.hpp"
#include "result.hpp"

namespace pardel {

/// Triangle's .poly (its .node beside it when its point section is empty), or a bare .node.
[[nodiscard]] Result<Pslg> read_pslg(const std::filesystem::path& file);
/// The same from text; `name` stands for the file in messages. A .poly whose points lie in a .node is refused.
[[nodiscard]] Result<Pslg> parse_poly(std::string_view text, const std::string& name);

/// base: 0 or 1, the number of the first vertex, in all Triangle files.
[[nodiscard]] Status write_poly(const Pslg& pslg, const std::filesystem::path& file, int base = 1);

/// A mesh that any program wrote, by suffix: .node/.ele (either name; .neigh, .edge and .poly beside it
/// are read when present), .msh (4.1, ASCII or binary), .vtu, .off. Neighbours are rebuilt from the triangles;
/// where an edge has more than two triangles, the neighbours of the surplus ones are no_index.
[[nodiscard]] Result<Mesh> read_mesh(const std::filesystem::path& file);

/// By suffix: .node or .ele writes .node, .ele and .poly; .vtu; .msh (binary) ; .off; .svg.
[[nodiscard]] Status write_mesh(const Mesh& mesh, const Pslg& pslg, const std::filesystem::path& file);

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
/// Writes stem.node, stem.ele, ... as `files` says.
[[nodiscard]] Status write_triangle_files(const Mesh& mesh, const Pslg& pslg, const std::filesystem::path& stem,
                                          const TriangleFiles& files);

/// Triangle's .area file: one cap per triangle, +infinity where the file says negative.
[[nodiscard]] Result<std::vector<double>> read_area(const std::filesystem::path& file);
/// One positive number per input vertex, Triangle-like: `n` then `i size`.
[[nodiscard]] Result<std::vector<double>> read_sizes(const std::filesystem::path& file);

enum class MshEncoding : std::uint8_t { ascii, binary };
[[nodiscard]] Status write_msh(const Mesh& mesh, const std::filesystem::path& file, MshEncoding encoding);
[[nodiscard]] Status write_vtu(const Mesh& mesh, const std::filesystem::path& file);
[[nodiscard]] Status write_off(const Mesh& mesh, const std::filesystem::path& file);
[[nodiscard]] Status write_svg(const Mesh& mesh, const std::filesystem::path& file);
[[nodiscard]] Status write_svg(const Pslg& pslg, const std::filesystem::path& file);

}  // namespace pardel
