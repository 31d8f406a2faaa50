// What the readers of meshes have in common, and one reader per format. Each takes the whole file; `name`
// stands for it in messages.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "../mesh.hpp"
#include "../result.hpp"

namespace pardel::files {

[[nodiscard]] Result<Mesh> read_triangle_mesh(const std::filesystem::path& file);
[[nodiscard]] Result<Mesh> parse_msh(std::string_view text, const std::string& name);
[[nodiscard]] Result<Mesh> parse_vtu(std::string_view text, const std::string& name);
[[nodiscard]] Result<Mesh> parse_off(std::string_view text, const std::string& name);

/// One region per distinct attribute, in ascending order: attributes[t] is that of triangle t, NaN
/// where it has no region.
void set_regions(Mesh& mesh, std::span<const double> attributes);

}  // namespace pardel::files
