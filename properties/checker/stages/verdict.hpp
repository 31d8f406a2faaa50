// The beginning and the end of a certificate.
#pragma once

#include <string>
#include <vector>

#include "../../../core/mesh.hpp"
#include "../certificate.hpp"
#include "findings.hpp"

namespace pardel::checker {

/// A certificate with the goal, and nothing measured.
[[nodiscard]] Certificate empty_certificate(const Pslg& pslg, const Goal& goal);

/// The kinds of labels that a mesh has.
struct LabelsOfMesh {
  bool regions, attributes, markers, edges;
};
[[nodiscard]] LabelsOfMesh labels_of(const Mesh& mesh);

/// Certificate::not_checked of a foreign mesh: labels that only one of the two has, and labels that each domain implies
/// and the mesh lacks.
[[nodiscard]] std::vector<std::string> not_checked(const Pslg& pslg, const LabelsOfMesh& mesh);

/// Sets the violations, and the verdict that follows from them.
void set_verdict(Certificate& certificate, Findings found);

}  // namespace pardel::checker
