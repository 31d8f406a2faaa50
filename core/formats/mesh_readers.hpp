// One reader per format, and a function that the readers of meshes share. A reader takes the whole file as text.
// Messages use `name` as the file name.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "../mesh.hpp"
#include "../pslg.hpp"
#include "../result.hpp"

namespace pardel::files {

[[nodiscard]] Result<Mesh> read_triangle_mesh(const std::filesystem::path& file);
/// Reads all pieces, and joins them.
[[nodiscard]] Result<Mesh> read_pvtu(const std::filesystem::path& file);
[[nodiscard]] Result<Mesh> parse_msh(std::string_view text, const std::string& name);
[[nodiscard]] Result<Mesh> parse_vtu(std::string_view text, const std::string& name);
[[nodiscard]] Result<Mesh> parse_off(std::string_view text, const std::string& name);

/// The text of a .poly. `file`: its name; a .node of the same name may have the points, unless it is standard input.
[[nodiscard]] Result<Pslg> parse_pslg(std::string_view text, const std::filesystem::path& file);

/// Sets mesh.region and mesh.region_attributes: one region per distinct attribute, in ascending order. attributes[t] is
/// the attribute of triangle t, or NaN if it has no region.
void set_regions(Mesh& mesh, std::span<const double> attributes);

}  // namespace pardel::files
