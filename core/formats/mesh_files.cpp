// Reads and writes meshes; the suffix of the file determines the format.
#include <algorithm>
#include <cmath>

#include "../formats.hpp"
#include "mesh_readers.hpp"
#include "text_reader.hpp"

namespace pardel {
using namespace files;
namespace {

enum class Format : std::uint8_t { unknown, triangle, vtu, msh, off, svg };

Format format_of(const std::filesystem::path& file) {
  const std::string suffix = file.extension().string();
  if (suffix == ".node" || suffix == ".ele") return Format::triangle;
  if (suffix == ".vtu") return Format::vtu;
  if (suffix == ".msh") return Format::msh;
  if (suffix == ".off") return Format::off;
  if (suffix == ".svg") return Format::svg;
  return Format::unknown;
}

Error unknown_suffix(const std::filesystem::path& file, const char* known) {
  const std::string suffix = file.extension().string();
  const std::string what =
      suffix.empty() ? "the name has no suffix, which sets the format" : "'" + suffix + "' is not a known format";
  return {ErrorKind::usage, file.string() + ": " + what + "; the formats of a mesh are " + known};
}

}  // namespace

bool is_mesh_suffix(const std::filesystem::path& file) { return format_of(file) != Format::unknown; }

void files::set_regions(Mesh& mesh, std::span<const double> attributes) {
  std::vector<double> distinct;
  for (const double attribute : attributes) {
    if (!std::isnan(attribute) && (distinct.empty() || distinct.back() != attribute)) distinct.push_back(attribute);
  }
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  mesh.region.resize(attributes.size());
  for (std::size_t t = 0; t < attributes.size(); ++t) {
    const auto place = std::lower_bound(distinct.begin(), distinct.end(), attributes[t]);
    mesh.region[t] = std::isnan(attributes[t]) ? no_index : static_cast<Index>(place - distinct.begin());
  }
  mesh.region_attributes = std::move(distinct);
}

Result<Mesh> read_mesh(const std::filesystem::path& file) {
  const Format format = format_of(file);
  if (format == Format::triangle) return read_triangle_mesh(file);
  if (format == Format::unknown || format == Format::svg) {
    return unknown_suffix(file, ".node, .ele, .msh, .vtu and .off");
  }
  const auto text = read_file(file);
  if (!text.ok()) return text.error();
  if (format == Format::vtu) return parse_vtu(*text, file.string());
  if (format == Format::msh) return parse_msh(*text, file.string());
  return parse_off(*text, file.string());
}

std::vector<std::string> written_files(const std::filesystem::path& file) {
  if (format_of(file) != Format::triangle) return {file.string()};
  const std::string stem = std::filesystem::path(file).replace_extension().string();
  return {stem + ".node", stem + ".ele", stem + ".poly"};
}

Status write_mesh(const Mesh& mesh, const Pslg& pslg, const std::filesystem::path& file, MshEncoding msh) {
  switch (format_of(file)) {
    case Format::triangle:
      return write_triangle_files(mesh, pslg, std::filesystem::path(file).replace_extension(), TriangleFiles{});
    case Format::vtu:
      return write_vtu(mesh, file);
    case Format::msh:
      return write_msh(mesh, file, msh);
    case Format::off:
      return write_off(mesh, file);
    case Format::svg:
      return write_svg(mesh, file);
    case Format::unknown:
      break;
  }
  return unknown_suffix(file, ".node, .ele, .vtu, .msh, .off and .svg");
}

}  // namespace pardel
