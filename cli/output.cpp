#include "output.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <system_error>

#include "../core/formats.hpp"
#include "../core/support/open_file.hpp"
#include "../core/support/output_file.hpp"
#include "suffix.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

Error io_error(const fs::path& file, int error) {
  return {ErrorKind::io, fmt::format("{}: {}", file.string(), std::strerror(error))};
}

/// The error for a mesh of a format that is not written here. It names the program that writes it, if there is one.
Error unknown_mesh_format(const fs::path& file) {
  Error error = unknown_format(file, "a mesh", ".node, .ele, .vtu, .msh, .off, .vtk, .2dm, .gr3, .14, .inp and .svg");
  if (file.extension() == ".png") error.message += "; 'pardel draw' draws a mesh as .png";
  if (file.extension() == ".pvtu") error.message += "; 'pardel-mpi mesh' writes .pvtu";
  return error;
}

}  // namespace

Status write_text(std::string_view text, const fs::path& file) {
  if (file == "-") {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) return io_error("standard output", errno);
    return Done{};
  }
  OutputFile output(file);
  output.write(text);
  return output.commit();
}

bool has_standard_output(std::span<const fs::path> outputs) { return std::ranges::any_of(outputs, is_standard_output); }

Status check_standard_output(std::span<const fs::path> outputs) {
  if (std::ranges::count_if(outputs, is_standard_output) < 2) return Done{};
  return Error{ErrorKind::usage, "-: only one output can go to standard output"};
}

Status check_format_options(std::span<const fs::path> outputs, const MeshFormatOptions& options) {
  const auto usage = [](const std::string& message) { return Error{ErrorKind::usage, message}; };
  const bool has_stream = std::ranges::find(outputs, fs::path("-")) != outputs.end();
  if (has_stream && !options.of_stream)
    return usage("-: standard output has no suffix; set --format msh, off, svg, vtu, vtk, 2dm, gr3 or inp");
  if (!has_stream && options.of_stream)
    return usage("--format is for the output -; a suffix sets the format of a file");
  bool has_gr3 = false;
  for (const fs::path& output : outputs) {
    const std::optional<MeshFormat> format = output == "-" ? options.of_stream : mesh_format(output);
    has_gr3 = has_gr3 || format == MeshFormat::gr3;
    if (options.order == 2 && format && !has_second_order(*format))
      return usage(output.string() + ": --order 2 is for .node, .ele, .msh and .vtu");
  }
  if (!has_gr3 && !options.open_boundaries.empty()) return usage("--open-boundary is for .gr3 and .14");
  return Done{};
}

Status check_folder(const fs::path& file) {
  if (file.empty() || is_standard_output(file)) return Done{};
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) return io_error(file, EISDIR);
  const fs::path written = behind_links(file);
  if (fs::is_symlink(written, ignored)) return io_error(file, ELOOP);
  const fs::path folder = written.has_parent_path() ? written.parent_path() : fs::path(".");
  const auto error_of_folder = [&](int error) {
    return Error{ErrorKind::io,
                 fmt::format("{}: {} (the folder {})", file.string(), std::strerror(error), folder.string())};
  };
  if (access(folder.c_str(), F_OK) != 0) return error_of_folder(errno);
  if (!fs::is_directory(folder, ignored)) return error_of_folder(ENOTDIR);
  if (is_written_directly(file)) return access(file.c_str(), W_OK) == 0 ? Status(Done{}) : io_error(file, errno);
  if (access(folder.c_str(), W_OK) != 0) return error_of_folder(errno);
  return Done{};
}

Status check_poly_output(const fs::path& file) {
  if (file.extension() != ".poly" && !is_written_directly(file)) {
    return Error{ErrorKind::usage, fmt::format("{}: domains are written as .poly", file.string())};
  }
  return check_folder(file);
}

Status check_mesh_outputs(std::span<const fs::path> outputs) {
  for (const fs::path& output : outputs) {
    if (output == "-") continue;
    if (output.extension().empty() && is_written_directly(output)) {
      return Error{ErrorKind::usage,
                   fmt::format("{}: the name has no suffix, which sets the format; for standard output write "
                               "'-o - --format FORMAT'",
                               output.string())};
    }
    if (!mesh_format(output)) return unknown_mesh_format(output);
    if (Status folder = check_folder(output); !folder) return folder;
  }
  return Done{};
}

}  // namespace pardel::cli
