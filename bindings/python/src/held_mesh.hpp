// A mesh that a Python object holds, with what is computed from it once.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <pardel/core/mesh.hpp>
#include <pardel/parallel/locator.hpp>
#include <span>
#include <utility>

#include "../../../core/support/mesh_edges.hpp"

namespace pardel::python {

/// True if all corners of triangles and all ends of constrained edges are points of the mesh.
[[nodiscard]] bool has_indices_in_range(const Mesh& mesh);

/// The mesh never changes, so NumPy arrays may be views on it.
class HeldMesh {
 public:
  /// domain: that of the mesh, or null if the mesh has none or if it is not known.
  explicit HeldMesh(Mesh mesh, std::shared_ptr<const Pslg> domain = {});
  HeldMesh(const HeldMesh&) = delete;
  HeldMesh& operator=(const HeldMesh&) = delete;

  /// Any content, as for check().
  [[nodiscard]] const Mesh& any() const { return mesh_; }
  /// Throws a Failure (invalid_input) unless all indices of points are in range.
  [[nodiscard]] const Mesh& usable() const;
  [[nodiscard]] const std::shared_ptr<const Pslg>& domain() const { return domain_; }

  /// All edges of the mesh. Computed by the first call; without the interpreter lock. Thread-safe, as markers().
  [[nodiscard]] std::span<const MarkedEdge> edges();
  /// One marker per point.
  [[nodiscard]] std::span<const int> markers();
  /// Made by the first call. Call it without the interpreter lock. Throws a Failure if the mesh cannot be used.
  /// Thread-safe.
  [[nodiscard]] const Locator& locator(const LocatorOptions& options);

 private:
  Mesh mesh_;
  std::shared_ptr<const Pslg> domain_;
  bool is_usable_;
  std::once_flag edges_once_, markers_once_;
  EdgeTable edges_;
  Array<int> inferred_markers_;
  std::span<const int> markers_;
  std::mutex locator_once_;  // not a once_flag: a call may end early, and the next one begins anew
  std::optional<Locator> locator_;
};

}  // namespace pardel::python
