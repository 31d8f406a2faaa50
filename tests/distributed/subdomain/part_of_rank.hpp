// What one rank holds of a triangulation, for tests.
#pragma once

#include <algorithm>

#include "../../../distributed/subdomain/rings.hpp"

namespace pardel::engine {

/// The triangles with a corner that the rank owns. All vertices and triangles have names that all ranks understand.
class PartOfRank {
 public:
  PartOfRank(const Triangulation& whole, int rank, const Rings::Owner& owner)
      : t(whole),
        vertices_(static_cast<Index>(t.points.size()), no_index),
        triangles_(static_cast<Index>(t.slots.size()), no_index),
        held(t, vertices_, triangles_, Name::rank(rank), {vertices_.end(), triangles_.end()}) {
    for (TriangleId id = 0; id < whole.slots.size(); ++id)
      if (std::ranges::none_of(whole.slots[id].v, [&](VertexId v) { return owner(v) == rank; })) held.drop(id);
  }

  Triangulation t;

 private:
  IndexAllocator vertices_, triangles_;

 public:
  Subdomain held;
};

}  // namespace pardel::engine
