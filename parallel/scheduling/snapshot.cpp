#include "snapshot.hpp"

#include "compact.hpp"

namespace pardel::engine {

Triangulation snapshot(const Triangulation& t, const NumberLedger& vertices, const NumberLedger& triangles,
                       int threads) {
  Triangulation copy = t;
  close_ranks(copy, vertices, triangles, threads);
  return copy;
}

}  // namespace pardel::engine
