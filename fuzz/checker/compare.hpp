// Compares the findings of the checker with those of the definitions.
#pragma once

#include <optional>

#include "chains.hpp"
#include "findings.hpp"

namespace pardel::fuzz {

/// A mesh that the checker has judged, with what it found.
struct Judged {
  const ExactMesh& mesh;
  const Pslg& pslg;
  const InputFaces& faces;
  const Goal& goal;
  const CheckOptions& options;
  const Certificate& certificate;
  const Findings& found;
  bool has_labels;  ///< the arrays of labels have the right lengths
};

/// The certificate of the checker. Fails if it contradicts itself. Precondition: no violations are left out of its list
/// (CheckOptions::max_violations).
Certificate judge(const Pslg& pslg, const Mesh& mesh, const Goal& goal, const CheckOptions& options);

/// Fails if the checker and the definitions differ in any rule. Returns the certificate. Precondition: the Pslg is
/// valid.
Certificate compare(const Pslg& pslg, const Mesh& mesh, const Goal& goal, const CheckOptions& options);

/// The part of compare() on what lies where in the domain. Returns the chains of the mesh, if it is clear which edges
/// they consist of, and if they meet in input points only. Precondition: the mesh is conformal.
std::optional<Chains> compare_domain(const Judged& judged);

}  // namespace pardel::fuzz
