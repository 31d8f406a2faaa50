#include "lattice_domain.hpp"

namespace pardel::generators {

LatticeDomain generate(Family family, Random& random, int size) {
  LatticeDomain domain;
  domain.family = family;
  const int side = random.between(8, 64);
  domain.points = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  for (Index i = 0; i < 4; ++i) domain.segments.push_back({i, (i + 1) % 4});
  for (int x = 1; x < side && x < size; x += random.between(1, 5))
    domain.points.push_back({x, random.between(1, side - 1)});
  return domain;
}

LatticeDomain any_domain(Random& random, int size) { return generate(random.one_of(all_families()), random, size); }

bool is_valid(const LatticeDomain& /*domain*/) { return true; }
bool has_trait(Family /*family*/, const LatticeDomain& /*domain*/) { return true; }
std::vector<LatticeDomain> shrinks(const LatticeDomain& /*domain*/) { return {}; }

}  // namespace pardel::generators
