// The number of faces of a domain.
#pragma once

#include <cstddef>
#include <vector>

#include "../construction/domain_triangulation.hpp"
#include "../construction/flood.hpp"

namespace pardel::engine {

/// A face is what can be reached from a triangle without crossing a segment. O(n).
[[nodiscard]] inline std::size_t count_faces(const DomainTriangulation& domain) {
  const Triangulation& t = domain.triangulation;
  Array<Index> face(t.slots.size(), no_index);
  std::vector<TriangleId> stack;
  SparseAsk never_stopped(nullptr);
  Index faces = 0;
  for (TriangleId first = 0; first < t.slots.size(); ++first) {
    if (face[first] != no_index) continue;
    stack.push_back(first);
    flood(t, stack, face, faces++, never_stopped);
  }
  return faces;
}

}  // namespace pardel::engine
