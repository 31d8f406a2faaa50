#include "snapshot.hpp"

#include "compact.hpp"

namespace pardel::engine {

Triangulation snapshot(const Triangulation& t, const IndexAllocator& vertices, const IndexAllocator& triangles,
                       int threads) {
  Triangulation copy = t;
  close_ranks(copy, vertices, triangles, threads);
  return copy;
}

}  // namespace pardel::engine
