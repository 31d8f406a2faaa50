#include "snapshot.hpp"

#include "close_ranks.hpp"

namespace pardel {

Triangulation snapshot(const Triangulation& t, const NumberLedger& vertices, const NumberLedger& triangles,
                       int threads) {
  Triangulation copy = t;
  close_ranks(copy, vertices, triangles, threads);
  return copy;
}

}  // namespace pardel
