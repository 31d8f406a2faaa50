// What the definitions find in the labels of a mesh: origins, markers, the list of constrained edges, regions and
// attributes. `foreign`: the mesh may lack what files lack (CheckOptions::foreign).
#pragma once

#include <set>
#include <vector>

#include "chains.hpp"

namespace pardel::fuzz {

[[nodiscard]] std::set<Index> with_wrong_origin(const ExactMesh& mesh, const Pslg& pslg, const WallsOfMesh& walls);
[[nodiscard]] std::set<Index> with_wrong_marker(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces,
                                                const WallsOfMesh& walls, bool foreign);

/// What is wrong in the list of constrained edges, by position in the list, and what is missing.
struct ListFaults {
  std::set<Index> wrong, wrong_marker;
  Edges missing;
};
[[nodiscard]] ListFaults faults_of_list(const ExactMesh& mesh, const WallsOfMesh& walls, bool foreign);

/// `face`: the faces of the triangles, here and below.
[[nodiscard]] Triangles with_wrong_region(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces,
                                          const std::vector<InputFaces::Face>& face, bool foreign);
[[nodiscard]] Triangles larger_than_caps(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces,
                                         const std::vector<InputFaces::Face>& face);

/// Points of the input with other attributes, and other points with an attribute that is not between the least and the
/// greatest of the input or, if `walls` is given, inside a segment not between those of its ends. Precondition: the
/// arrays have the right lengths.
[[nodiscard]] std::set<Index> with_wrong_attributes(const ExactMesh& mesh, const Pslg& pslg,
                                                    const WallsOfMesh* walls = nullptr);

}  // namespace pardel::fuzz
