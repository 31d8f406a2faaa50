// The numbers by which findings of the checker name things: those of the files of a domain and of a mesh.
#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "../core/formats.hpp"
#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../properties/checker/witness.hpp"

namespace pardel::cli {

/// Of a mesh that was read. Refers to mesh.numbers.
[[nodiscard]] NumbersInWitnesses numbers_of_files(FirstId of_domain, const Mesh& mesh);

/// Of a mesh that is written to several files: those of the first file, or from 0 if it has no numbers. A .msh groups
/// triangles by region; here they have the order of the mesh. `of_stream`: the format of standard output. Precondition:
/// there is an output.
[[nodiscard]] NumbersInWitnesses numbers_of_outputs(FirstId of_domain, std::span<const std::filesystem::path> outputs,
                                                    std::optional<MeshFormat> of_stream = {});

}  // namespace pardel::cli
