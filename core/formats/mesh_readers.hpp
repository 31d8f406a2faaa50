// One reader per format, and a function that the readers of meshes share. A reader takes the whole file as text.
// Messages use `name` as the file name. `stop`: see read_file().
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../join_pieces.hpp"
#include "../mesh.hpp"
#include "../pslg.hpp"
#include "../result.hpp"
#include "../support/stop_signal.hpp"

namespace pardel::files {

[[nodiscard]] Result<Mesh> read_triangle_mesh(const std::filesystem::path& file, StopSignal* stop = nullptr);
/// Reads all pieces, and joins them.
[[nodiscard]] Result<Mesh> read_pvtu(const std::filesystem::path& file, StopSignal* stop = nullptr);
/// Reads the pieces of `file` (msh_of_piece), and joins them.
[[nodiscard]] Result<Mesh> read_msh_pieces(const std::filesystem::path& file, StopSignal* stop = nullptr);
/// A file of VtuPieces.
[[nodiscard]] Result<NumberedMesh> read_piece(const std::filesystem::path& file, StopSignal* stop);
[[nodiscard]] Result<Mesh> parse_msh(std::string_view text, const std::string& name, StopSignal* stop = nullptr);
/// A piece of a partitioned mesh; NumberedMesh::number is the tag of a vertex, minus 1.
struct MshPiece : NumberedMesh {
  std::size_t partitions = 1;  ///< of the whole mesh
};
/// Lines that several pieces have are read from the first of them. `partition`: that of the file, from 1 on.
[[nodiscard]] Result<MshPiece> parse_msh_piece(std::string_view text, const std::string& name, int partition,
                                               StopSignal* stop = nullptr);
[[nodiscard]] Result<Mesh> parse_vtu(std::string_view text, const std::string& name, StopSignal* stop = nullptr);
[[nodiscard]] Result<Mesh> parse_off(std::string_view text, const std::string& name, StopSignal* stop = nullptr);
[[nodiscard]] Result<Mesh> parse_vtk(std::string_view text, const std::string& name, StopSignal* stop = nullptr);
[[nodiscard]] Result<Mesh> parse_2dm(std::string_view text, const std::string& name, StopSignal* stop = nullptr);
[[nodiscard]] Result<Mesh> parse_gr3(std::string_view text, const std::string& name, StopSignal* stop = nullptr);

/// The text of a .poly. `file`: its name; a .node of the same name may have the points, unless it is standard input.
[[nodiscard]] Result<Pslg> parse_pslg(std::string_view text, const std::filesystem::path& file,
                                      StopSignal* stop = nullptr);

/// Sets mesh.region and mesh.region_attributes: one region per distinct attribute, in ascending order. attributes[t] is
/// the attribute of triangle t, or NaN if it has no region.
void set_regions(Mesh& mesh, std::span<const double> attributes);

/// Joins pieces of which each has its own list of regions. `file`, and the number 0 in it: for messages.
[[nodiscard]] Result<Mesh> join_read_pieces(std::vector<NumberedMesh> pieces, const std::filesystem::path& file,
                                            FirstId first_id = {});

}  // namespace pardel::files
