// The certificates of a mesh in memory and of the files that it is written to.
#pragma once

#include <string>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../../properties/checker/check.hpp"
#include "../../temporary_folder.hpp"

namespace pardel::testing {

/// A format that stores the constrained edges of a mesh.
struct WrittenAs {
  const char* file;
  MshEncoding msh = MshEncoding::binary;
};
inline std::vector<WrittenAs> formats_with_constrained_edges() {
  return {{"mesh.node"}, {"mesh.vtu"}, {"mesh.off"}, {"binary.msh"}, {"text.msh", MshEncoding::ascii}};
}

/// The verdict and the numbers of violations by kind, for comparison and for messages.
inline std::string verdict(const Certificate& certificate) {
  std::string text = certificate.valid ? "valid" : "not valid:";
  for (std::size_t kind = 0; kind < certificate.violation_counts.size(); ++kind)
    if (const auto n = certificate.violation_counts[kind])
      text += " " + std::string(name(static_cast<ViolationKind>(kind))) + " " + std::to_string(n);
  return text;
}

/// The verdict on the mesh after it was written and read, as `pardel check` computes it; or the error.
inline std::string verdict_on_file(const Pslg& pslg, const Mesh& mesh, const Goal& goal, WrittenAs format) {
  const TemporaryFolder folder;
  const Status written = write_mesh(mesh, pslg, folder / format.file, format.msh);
  if (!written) return written.error().message;
  const Result<Mesh> read = read_mesh(folder / format.file);
  if (!read) return read.error().message;
  return verdict(check(pslg, *read, goal, {.foreign = true}));
}

}  // namespace pardel::testing
