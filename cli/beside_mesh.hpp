// What files carry beside a mesh: notes about what is read, and about what a format cannot store.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "../core/formats.hpp"
#include "../core/mesh.hpp"

namespace pardel::cli {

/// Names the fields of a mesh that was read from `file`, and what the reader left out, on stderr: one line each, if
/// there are any. `use` follows the list of fields: ", which the check does not use".
void note_beside_mesh(const Mesh& mesh, const std::filesystem::path& file, const std::string& use = {});

/// Where the markers of points come from. The mesher gives them to all meshes, most of them from the edges at a point:
/// of its markers only those are lost that no edge at the point has.
enum class PointMarkers : std::uint8_t { file, mesher };

/// The parts of a mesh that are not in every format, for example `regions, markers of points, the field "T"`: those
/// that a file of this format cannot store. Empty if it stores all. Time O(n) for n points and edges.
[[nodiscard]] std::string losses(const Mesh& mesh, MeshFormat format, PointMarkers from);
/// Says on stderr what a file cannot store, if `list` is not empty. `format`: that of standard output.
void note_losses(const std::string& list, const std::filesystem::path& file, std::optional<MeshFormat> format);

/// The format in which a mesh is written: `of_stream` for standard output. Precondition: there is one.
[[nodiscard]] MeshFormat format_of_output(const std::filesystem::path& file, std::optional<MeshFormat> of_stream);

/// `marker 1 "wall"` or `region 2 "water"`.
[[nodiscard]] std::string text_of(const GroupName& name);

}  // namespace pardel::cli
