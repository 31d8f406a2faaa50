// Reads and writes meshes in all formats.
#include <algorithm>
#include <cmath>

#include "../formats.hpp"
#include "mesh_readers.hpp"
#include "text_reader.hpp"

namespace pardel {
using namespace files;
namespace {

namespace fs = std::filesystem;

/// The format of a mesh by its first characters; empty if it begins like none.
std::optional<MeshFormat> format_of_text(std::string_view text) {
  if (text.starts_with("# vtk DataFile")) return MeshFormat::vtk;  // a comment in other formats
  TextReader in(text, {});
  in.next_line();
  if (in.rest().starts_with('$')) return MeshFormat::msh;
  if (in.rest().starts_with('<')) return MeshFormat::vtu;
  if (in.rest().starts_with("OFF")) return MeshFormat::off;
  if (in.rest().starts_with("MESH2D")) return MeshFormat::two_dm;
  return {};
}

/// Precondition: the format is one of a single file that can be read.
Result<Mesh> parse_mesh(MeshFormat format, std::string_view text, const std::string& name, StopSignal* stop) {
  if (format == MeshFormat::vtu) return parse_vtu(text, name, stop);
  if (format == MeshFormat::msh) return parse_msh(text, name, stop);
  if (format == MeshFormat::vtk) return parse_vtk(text, name, stop);
  if (format == MeshFormat::two_dm) return parse_2dm(text, name, stop);
  if (format == MeshFormat::gr3) return parse_gr3(text, name, stop);
  return parse_off(text, name, stop);
}

Error not_a_mesh(const fs::path& file) {
  return {ErrorKind::invalid_input,
          file.string() +
              ": a mesh without a suffix must be .msh, .vtu, .off, .vtk or .2dm, and so begin with \"$\", \"<\", "
              "\"OFF\", \"# vtk DataFile\" or \"MESH2D\"; a mesh in .node and .ele consists of two files, which need "
              "names"};
}

Error unknown_suffix(const fs::path& file, const char* known) {
  const std::string suffix = file.extension().string();
  const std::string what =
      suffix.empty() ? "the name has no suffix, which sets the format" : "'" + suffix + "' is not a known format";
  return {ErrorKind::usage, file.string() + ": " + what + "; the formats of a mesh are " + known};
}

template <class Read>
Result<std::variant<Pslg, Mesh>> either(Result<Read> read) {
  if (!read) return read.error();
  return std::variant<Pslg, Mesh>(std::move(*read));
}

Result<std::variant<Pslg, Mesh>> pslg_or_mesh(std::string_view text, const fs::path& file, StopSignal* stop) {
  if (const std::optional<MeshFormat> format = format_of_text(text))
    return either(parse_mesh(*format, text, file.string(), stop));
  return either(parse_pslg(text, file, stop));
}

Result<MeshOfFile> mesh_and_format(const fs::path& file, StopSignal* stop) {
  std::optional<MeshFormat> format = mesh_format(file);
  const auto of = [](MeshFormat which, Result<Mesh> mesh) -> Result<MeshOfFile> {
    if (!mesh) return mesh.error();
    return MeshOfFile{std::move(*mesh), which};
  };
  if (format == MeshFormat::triangle) return of(*format, read_triangle_mesh(file, stop));
  if (file.extension() == ".pvtu") return of(MeshFormat::vtu, read_pvtu(file, stop));
  if (format == MeshFormat::svg || format == MeshFormat::inp || (!format && file.has_extension()))
    return unknown_suffix(file, ".node, .ele, .msh, .vtu, .pvtu, .off, .vtk, .2dm, .gr3 and .14");
  if (std::error_code ignored;
      format == MeshFormat::msh && !fs::exists(file, ignored) && fs::exists(msh_of_piece(file, 1), ignored))
    return of(*format, read_msh_pieces(file, stop));
  const auto text = read_file(file, stop);
  if (!text) return text.error();
  if (!format) format = format_of_text(*text);
  if (!format) return not_a_mesh(file);
  return of(*format, parse_mesh(*format, *text, file.string(), stop));
}

}  // namespace

std::optional<MeshFormat> mesh_format(const fs::path& file) {
  const fs::path suffix = file.extension();
  if (suffix == ".node" || suffix == ".ele") return MeshFormat::triangle;
  if (suffix == ".vtu") return MeshFormat::vtu;
  if (suffix == ".msh") return MeshFormat::msh;
  if (suffix == ".off") return MeshFormat::off;
  if (suffix == ".svg") return MeshFormat::svg;
  if (suffix == ".vtk") return MeshFormat::vtk;
  if (suffix == ".2dm") return MeshFormat::two_dm;
  if (suffix == ".gr3" || suffix == ".14") return MeshFormat::gr3;
  if (suffix == ".inp") return MeshFormat::inp;
  return {};
}

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

Result<Mesh> read_mesh(const fs::path& file, const GoOn& go_on) {
  Result<MeshOfFile> read = read_mesh_and_format(file, go_on);
  if (!read) return read.error();
  return std::move(read->mesh);
}

Result<MeshOfFile> read_mesh_and_format(const fs::path& file, const GoOn& go_on) {
  return stoppable(go_on, [&](StopSignal* stop) { return mesh_and_format(file, stop); });
}

Result<std::variant<Pslg, Mesh>> read_pslg_or_mesh(const fs::path& file, const GoOn& go_on) {
  std::error_code ignored;
  if (file.extension() == ".node" && !fs::exists(fs::path(file).replace_extension(".ele"), ignored))
    return either(read_pslg(file, go_on));
  if (file.extension() == ".poly") return either(read_pslg(file, go_on));
  if (file.has_extension()) return either(read_mesh(file, go_on));
  return stoppable(go_on, [&](StopSignal* stop) -> Result<std::variant<Pslg, Mesh>> {
    const auto text = read_file(file, stop);
    if (!text) return text.error();
    return pslg_or_mesh(*text, file, stop);
  });
}

Result<std::variant<Pslg, Mesh>> parse_pslg_or_mesh(std::string_view text, const fs::path& file) {
  return pslg_or_mesh(text, file, nullptr);
}

Result<std::string> read_text(const fs::path& file, const GoOn& go_on) {
  return stoppable(go_on, [&](StopSignal* stop) -> Result<std::string> {
    const auto text = read_file(file, stop);
    if (!text) return text.error();
    return std::string(std::string_view(*text));
  });
}

std::vector<std::string> written_files(const fs::path& file) {
  if (mesh_format(file) != MeshFormat::triangle) return {file.string()};
  const std::string stem = fs::path(file).replace_extension().string();
  return {stem + ".node", stem + ".ele", stem + ".poly"};
}

bool has_second_order(MeshFormat format) {
  return format == MeshFormat::triangle || format == MeshFormat::msh || format == MeshFormat::vtu;
}

Status write_mesh(const Mesh& mesh, const Pslg& pslg, const fs::path& file, MshEncoding msh,
                  std::optional<MeshFormat> format) {
  return write_mesh(mesh, pslg, file, MeshFileOptions{.msh = msh, .format = format});
}

Status write_mesh(const Mesh& mesh, const Pslg& pslg, const fs::path& file, const MeshFileOptions& options) {
  const std::optional<MeshFormat> format = options.format ? options.format : mesh_format(file);
  if (!format) return unknown_suffix(file, ".node, .ele, .vtu, .msh, .off, .vtk, .2dm, .gr3, .14, .inp and .svg");
  const bool second_order = options.elements == ElementOrder::second;
  if (second_order && !has_second_order(*format))
    return Error{ErrorKind::usage, file.string() + ": only .node, .ele, .msh and .vtu can have elements of order 2"};
  switch (*format) {
    case MeshFormat::triangle:
      return write_triangle_files(mesh, pslg, fs::path(file).replace_extension(),
                                  {.second_order = second_order, .go_on = options.go_on});
    case MeshFormat::vtu:
      return write_vtu(mesh, file, options.elements, options.go_on);
    case MeshFormat::msh:
      return write_msh(mesh, file, options.msh, options.elements, options.go_on);
    case MeshFormat::off:
      return write_off(mesh, file, options.go_on);
    case MeshFormat::vtk:
      return write_vtk(mesh, file, options.go_on);
    case MeshFormat::two_dm:
      return write_2dm(mesh, file, options.go_on);
    case MeshFormat::gr3:
      return write_gr3(mesh, file, options.open_boundaries, options.go_on);
    case MeshFormat::inp:
      return write_inp(mesh, file, options.go_on);
    case MeshFormat::svg:
      break;
  }
  return write_svg(mesh, file, options.go_on);
}

}  // namespace pardel
