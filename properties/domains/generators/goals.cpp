#include "goals.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace pardel::generators {
namespace {

double area_of_bounding_box(const LatticeDomain& domain) {
  const auto [left, right] = std::ranges::minmax(domain.points, {}, &LatticePoint::x);
  const auto [low, high] = std::ranges::minmax(domain.points, {}, &LatticePoint::y);
  return static_cast<double>(right.x - left.x) * static_cast<double>(high.y - low.y);
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const LatticeGoal& goal) {
  return out << "angles >= " << goal.min_angle_deg << ", areas <= " << goal.max_area
             << (goal.region_caps ? "" : ", area caps of regions ignored") << (goal.conforming ? ", conforming" : "");
}

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.domain << "; " << c.goal; }

Goal to_goal(const LatticeGoal& goal, const LatticeDomain& domain) {
  return {.min_angle_deg = goal.min_angle_deg,
          .max_area = std::ldexp(goal.max_area, -2 * domain.exponent),
          .region_caps = goal.region_caps,
          .conforming = goal.conforming};
}

LatticeGoal any_goal(const LatticeDomain& domain, Random& random) {
  LatticeGoal goal;
  goal.min_angle_deg = random.one_of<double>({0, 10, 20.7, 25, 28});
  if (random.chance(3)) goal.max_area = area_of_bounding_box(domain) / random.between(2, 150);
  goal.region_caps = !random.chance(4);
  goal.conforming = random.chance(3);
  return goal;
}

Case any_case(Random& random, int size) {
  Case c;
  c.domain = any_domain(random, size);
  c.goal = any_goal(c.domain, random);
  return c;
}

std::vector<LatticeGoal> shrinks(const LatticeGoal& goal) {
  const LatticeGoal usual;
  std::vector<LatticeGoal> simpler;
  const auto with_usual = [&](auto LatticeGoal::*number) {
    if (goal.*number == usual.*number) return;
    simpler.push_back(goal);
    simpler.back().*number = usual.*number;
  };
  with_usual(&LatticeGoal::max_area);
  with_usual(&LatticeGoal::conforming);
  with_usual(&LatticeGoal::min_angle_deg);
  with_usual(&LatticeGoal::region_caps);
  return simpler;
}

std::vector<Case> shrinks(const Case& c) {
  std::vector<Case> simpler;
  for (LatticeDomain& domain : shrinks(c.domain)) simpler.push_back({std::move(domain), c.goal});
  for (const LatticeGoal& goal : shrinks(c.goal)) simpler.push_back({c.domain, goal});
  return simpler;
}

}  // namespace pardel::generators
