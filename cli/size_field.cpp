#include "size_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>

#include "../core/formats.hpp"
#include "../core/support/shortest.hpp"
#include "../parallel/mesher.hpp"
#include "../parallel/sizes.hpp"

namespace pardel::cli {
namespace {

using Size = Result<std::function<double(Point)>>;

using Sources = Result<std::vector<SizeSource>>;

/// The field `size`, else the first field of single numbers, else the first field; null if there is none at points.
const Field* field_of_sizes(const Mesh& mesh) {
  const auto first = [&](const auto& is_meant) {
    const auto found = std::ranges::find_if(
        mesh.fields, [&](const Field& field) { return field.place == Field::Place::points && is_meant(field); });
    return found == mesh.fields.end() ? nullptr : &*found;
  };
  const Field* field = first([](const Field& f) { return f.name == "size"; });
  if (field == nullptr) field = first([](const Field& f) { return f.components == 1; });
  return field != nullptr ? field : first([](const Field&) { return true; });
}

/// The first attribute of each point or, if points have no attributes, the first value of field_of_sizes().
PointSizes values_at_points(const Mesh& mesh) {
  const Field* field = mesh.attributes_per_point > 0 ? nullptr : field_of_sizes(mesh);
  const std::span<const double> values = (field != nullptr ? field->values : mesh.point_attributes).span();
  const std::size_t width = field != nullptr ? field->components : mesh.attributes_per_point;
  PointSizes sizes;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) sizes.push_back(values[i * width]);
  return sizes;
}

Size function_of(const PointSizes& sizes, const std::string& name, const ValidPslg& domain, const NumbersInFile&) {
  const std::size_t points = domain.pslg().points.size();
  if (sizes.size() != points) {
    return Error{ErrorKind::invalid_input, fmt::format("{}: {} sizes for {} input points", name, sizes.size(), points)};
  }
  return interpolated_size(domain, sizes);
}

Size function_of(const Raster& raster, const std::string& name, const ValidPslg& domain, const NumbersInFile& numbers) {
  const Pslg& pslg = domain.pslg();
  for (std::size_t i = 0; i < pslg.points.size(); ++i)
    if (!raster.covers(pslg.points[i])) {
      return Error{ErrorKind::invalid_input, fmt::format("{}: the raster from {} to {} does not cover point {} at {}",
                                                         name, shortest(raster.low()), shortest(raster.high()),
                                                         number_in_file(numbers, pslg.first_id, static_cast<Index>(i)),
                                                         shortest(pslg.points[i]))};
    }
  return interpolated_size(raster, name);
}

Size function_of(const Mesh& background, const std::string& name, const ValidPslg&, const NumbersInFile&) {
  const Result<PointSizes> sizes = sizes_at_points(background, name);
  if (!sizes) return sizes.error();
  Size size = interpolated_size(background, *sizes, {}, name);
  if (!size) return Error{size.error().kind, name + ": " + size.error().message};
  return size;
}

Size function_of(std::monostate, const std::string&, const ValidPslg&, const NumbersInFile&) {
  return std::function<double(Point)>();
}

Sources sources_in(const PointSizes& sizes, const ValidPslg& domain, double grading) {
  return size_sources(domain, sizes, grading);
}
Sources sources_in(const Raster& raster, const ValidPslg&, double grading) { return size_sources(raster, grading); }
Sources sources_in(const Mesh& background, const ValidPslg&, double grading) {
  return size_sources(background, values_at_points(background), grading);
}
Sources sources_in(std::monostate, const ValidPslg&, double) { return std::vector<SizeSource>(); }

}  // namespace

Result<SizeField> read_size_field(const std::filesystem::path& file, const GoOn& go_on) {
  if (file.empty()) return SizeField();
  const auto field = [](auto read) -> Result<SizeField> {
    if (!read) return read.error();
    return SizeField(std::move(*read));
  };
  std::string suffix = file.extension().string();
  std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".asc" || suffix == ".npy") return field(read_raster(file, go_on));
  if (const auto format = mesh_format(file); format && format != MeshFormat::svg) return field(read_mesh(file, go_on));
  return field(read_sizes(file, go_on));
}

Result<PointSizes> sizes_at_points(const Mesh& mesh, const std::string& name) {
  if (mesh.attributes_per_point == 0 && field_of_sizes(mesh) == nullptr) {
    return Error{
        ErrorKind::invalid_input,
        fmt::format("{}: the mesh has no values at its points that could be edge lengths (in a .vtu or .vtk a point "
                    "array such as 'size' or 'attributes', in a .msh $NodeData, in a .node the first "
                    "attribute)",
                    name)};
  }
  PointSizes sizes = values_at_points(mesh);
  if (const auto none = std::ranges::find_if(sizes, [](double size) { return std::isnan(size); });
      none != sizes.end()) {
    return Error{ErrorKind::invalid_input, fmt::format("{}: point {} has no value that could be an edge length", name,
                                                       number_in_file(mesh, static_cast<Index>(none - sizes.begin())))};
  }
  return sizes;
}

Size size_function(const SizeField& field, const std::string& name, const ValidPslg& domain,
                   const NumbersInFile& numbers) {
  return std::visit([&](const auto& sizes) { return function_of(sizes, name, domain, numbers); }, field);
}

Sources sources_of(const SizeField& field, const ValidPslg& domain, double grading) {
  return std::visit([&](const auto& sizes) { return sources_in(sizes, domain, grading); }, field);
}

}  // namespace pardel::cli
