// Random segments that cross, overlap and touch, inside a square outline.
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

#include "../../../core/pslg.hpp"
#include "../shapes.hpp"

namespace pardel::engine {

inline void showValue(const Pslg& pslg, std::ostream& out) {  // RapidCheck calls it
  for (const Point& p : pslg.points) out << "(" << p.x << ", " << p.y << ") ";
  for (const Segment& s : pslg.segments) out << s.a << "-" << s.b << " ";
}

}  // namespace pardel::engine

namespace pardel::testing {

/// Distinct points with integer coordinates from 1 to `size`, distinct segments between them, and the square from (0,
/// 0) to (size + 1, size + 1), whose corners come last. All coordinates are multiplied by `unit`.
inline rc::Gen<Pslg> lattice_mess(int size, double unit = 1) {
  const auto point = rc::gen::pair(rc::gen::inRange(1, size + 1), rc::gen::inRange(1, size + 1));
  const auto ends = rc::gen::pair(rc::gen::inRange<Index>(0, 1000), rc::gen::inRange<Index>(0, 1000));
  return rc::gen::apply(
      [=](const std::vector<std::pair<int, int>>& points, const std::vector<std::pair<Index, Index>>& segments) {
        Pslg pslg;
        std::set<std::pair<int, int>> known;
        for (const auto& p : points)
          if (known.insert(p).second) pslg.points.push_back({p.first * unit, p.second * unit});
        std::set<std::pair<Index, Index>> joined;
        const auto n = static_cast<Index>(pslg.points.size());
        for (const auto& [i, j] : segments) {
          if (n < 2 || i % n == j % n || !joined.insert(std::minmax(i % n, j % n)).second) continue;
          pslg.segments.push_back({i % n, j % n, static_cast<int>(joined.size())});
        }
        add_square(pslg, (size + 1) * unit, {0, 0});
        return pslg;
      },
      rc::gen::container<std::vector<std::pair<int, int>>>(point),
      rc::gen::container<std::vector<std::pair<Index, Index>>>(ends));
}

/// Two kinds of lattices: coordinates that are exact, which make many degeneracies, and coordinates that are rounded.
inline rc::Gen<Pslg> mess() {
  return rc::gen::oneOf(lattice_mess(5), lattice_mess(12, 0.1), lattice_mess(1000, 1.0 / 3),
                        lattice_mess(1000000, 1e-7));
}

}  // namespace pardel::testing
