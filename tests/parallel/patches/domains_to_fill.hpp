// Domains for the tests of patches.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "../../../parallel/construction/domain_triangulation.hpp"
#include "../../../properties/domains/domains.hpp"

namespace pardel::engine {

inline DomainTriangulation coarse(const Pslg& pslg) {
  Result<DomainTriangulation> domain = triangulate_domain(pslg, false);
  EXPECT_TRUE(domain);
  return std::move(domain).value();
}

inline std::vector<Pslg> domains_to_fill() {
  std::vector<Pslg> all{domains::square(), domains::pipe()};
  for (const char* name : {"key", "star", "cracks", "touching-holes"})
    if (auto domain = domains::generate(name, 0, 1)) all.push_back(std::move(*domain));
  all.front().points.push_back({0.4, 0.6});  // a point without segments
  return all;
}

inline double extent(const Pslg& pslg) {
  double extent = 0;
  for (const Point p : pslg.points) extent = std::max({extent, p.x - pslg.points[0].x, p.y - pslg.points[0].y});
  return extent;
}

}  // namespace pardel::engine
