// Meshes that are written to a file and read from it.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>

#include "../../../core/formats.hpp"
#include "../framework/property.hpp"

namespace pardel::properties {

/// A folder that ends with this object.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("pardel-mesh-file-" + std::to_string(::getpid()))) {
    std::filesystem::create_directory(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// The mesh after it was written and read. An error fails the case.
inline Mesh written_and_read(const Mesh& mesh, const Pslg& pslg, const std::string& name,
                             const MeshFileOptions& options) {
  const Folder folder;
  const Status written = write_mesh(mesh, pslg, folder / name, options);
  if (!written) RC_FAIL(written.error().message);
  Result<Mesh> read = read_mesh(folder / name);
  if (!read) RC_FAIL(read.error().message);
  return std::move(read).value();
}

}  // namespace pardel::properties
