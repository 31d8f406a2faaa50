// The search for a cavity, one triangle at a time, so that a worker can take a lock on each triangle before it reads
// it.
//
// Source: D. Nave, N. Chrisochoides, L. P. Chew, "Guaranteed-quality parallel Delaunay refinement for restricted
// polyhedral domains", SCG 2002 (cavity expansion).
#pragma once

#include <vector>

#include "../mesh/linked_mesh.hpp"

namespace pardel::schemes {

/// Visits the triangles of C(p), those across its unconstrained sides, which are tested, and those beyond its
/// constrained sides, which are only held because their pointers are written. Its cavity is cavity_of(p, starts),
/// entry for entry, if the visited triangles do not change in the meantime.
class Expansion {
 public:
  Expansion() = default;
  Expansion(Point p, std::vector<Index> starts) : p_(p), starts_(std::move(starts)) {}

  /// The triangle to be visited next; no_index if the cavity is complete.
  [[nodiscard]] Index next(const LinkedMesh& mesh);
  /// Does next() belong to the cavity? It is read for the answer.
  [[nodiscard]] bool joins(const LinkedMesh& mesh, Index next) const;
  /// Visits next().
  void visit(const LinkedMesh& mesh, Index next);

  [[nodiscard]] Point point() const { return p_; }
  [[nodiscard]] const std::vector<Index>& starts() const { return starts_; }
  /// The cavity with its boundary. Precondition: it is complete.
  [[nodiscard]] Cavity cavity(const LinkedMesh& mesh) const;

 private:
  [[nodiscard]] Side cursor() const { return {triangles_[at_ / 3], static_cast<int>(at_ % 3)}; }

  Point p_;
  std::vector<Index> starts_;
  std::vector<Index> triangles_;  ///< of the cavity; the starts first
  std::vector<Index> rejected_;   ///< tested, and not of the cavity
  std::vector<Index> beyond_;     ///< a constrained side, and not tested
  std::size_t at_ = 0;            ///< side at_ % 3 of triangle at_ / 3 is looked across next
};

}  // namespace pardel::schemes
