#include "numbers_in_findings.hpp"

#include "beside_mesh.hpp"

namespace pardel::cli {
namespace {

/// The number of the first vertex and triangle in the files that write_mesh() writes; 0 where they have no numbers.
int first_number(MeshFormat format) {
  switch (format) {
    case MeshFormat::triangle:
    case MeshFormat::msh:
    case MeshFormat::two_dm:
    case MeshFormat::gr3:
    case MeshFormat::inp:
      return 1;
    case MeshFormat::off:
    case MeshFormat::svg:
    case MeshFormat::vtu:
    case MeshFormat::vtk:
      break;
  }
  return 0;
}

}  // namespace

NumbersInWitnesses numbers_of_files(FirstId of_domain, const Mesh& mesh) {
  return {of_domain.value, mesh.first_id.value, mesh.first_id.value, mesh.numbers.of_points, mesh.numbers.of_triangles};
}

NumbersInWitnesses numbers_of_outputs(FirstId of_domain, std::span<const std::filesystem::path> outputs,
                                      std::optional<MeshFormat> of_stream) {
  const int first = first_number(format_of_output(outputs.front(), of_stream));
  return {of_domain.value, first, first};
}

}  // namespace pardel::cli
