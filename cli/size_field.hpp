// The edge lengths that --sizes names.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "../core/formats.hpp"
#include "../core/mesh.hpp"
#include "../core/raster.hpp"
#include "../core/result.hpp"
#include "../core/size_source.hpp"
#include "../parallel/validate.hpp"

namespace pardel::cli {

/// One edge length per input point.
using PointSizes = std::vector<double>;
/// What a file of edge lengths has; nothing if there is no file.
/// Of a mesh, the first attribute of a point is the length there; if it has none, the field `size`, else the first
/// field of single numbers, else the first value of the first field.
using SizeField = std::variant<std::monostate, PointSizes, Raster, Mesh>;

/// Reads a file of edge lengths: a raster if the suffix is .asc or .npy, a mesh if it is the suffix of a mesh. An empty
/// path means no file.
[[nodiscard]] Result<SizeField> read_size_field(const std::filesystem::path& file, const GoOn& go_on = {});

/// The edge lengths at the points of a mesh, as SizeField says. `name` names the file in messages. Fails with
/// `invalid_input` if the mesh has none, or not at every point.
[[nodiscard]] Result<PointSizes> sizes_at_points(const Mesh& mesh, const std::string& name);

/// The function for Goal::size; empty if the field is. `name` names the file in messages. Fails with `invalid_input` if
/// the field does not fit the domain, whose points have these numbers in messages (Mesh::numbers).
[[nodiscard]] Result<std::function<double(Point)>> size_function(const SizeField& field, const std::string& name,
                                                                 const ValidPslg& domain,
                                                                 const NumbersInFile& numbers = {});

/// The sources for Goal::sources: where the lengths of the field grow faster than `grading`. Precondition:
/// size_function() accepts the field.
[[nodiscard]] Result<std::vector<SizeSource>> sources_of(const SizeField& field, const ValidPslg& domain,
                                                         double grading);

}  // namespace pardel::cli
