// Tests the generators of random domains and their shrinkers. All other suites rely on these properties.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

#include "../../../parallel/mesher.hpp"
#include "../../../parallel/validate.hpp"
#include "../../domains/generators/goals.hpp"
#include "../../domains/generators/lattice_domain.hpp"
#include "../../domains/generators/mixed_scales.hpp"
#include "../framework/property.hpp"
#include "../framework/rapidcheck_generators.hpp"
#include "../framework/shares.hpp"

namespace pardel::generators {
namespace {

constexpr const char* every_family = "all families, equally likely";

/// A generator without shrinking, because a test of a shrinker must not use the shrinker when the test fails.
auto unshrunk(auto make) {
  return generator(make, [](const auto& value) { return std::vector<std::decay_t<decltype(value)>>(); });
}
auto small_domains() {
  return unshrunk([](Random& random, int size) { return any_domain(random, size / 3); });
}

template <class T>
T& any_of(std::vector<T>& values, Random& random) {
  return values[random.below(values.size())];
}

/// A domain with one random change. The change makes most domains invalid.
LatticeDomain spoiled(Random& random, int size) {
  LatticeDomain d = any_domain(random, size);
  const auto n = static_cast<Index>(d.points.size());
  const auto shift = [&] { return LatticePoint{random.between(-9, 9), random.between(-9, 9)}; };
  const auto move = [&](LatticePoint& p) {
    const LatticePoint by = shift();
    p = {p.x + by.x, p.y + by.y};
  };
  const auto seed_near_a_point = [&] {
    const LatticePoint p = any_of(d.points, random);
    LatticePoint seed = {4 * p.x, 4 * p.y};
    move(seed);
    return seed;
  };
  switch (random.below(12)) {
    case 0:
      move(any_of(d.points, random));
      break;
    case 1:
      d.points.push_back(any_of(d.points, random));
      break;
    case 2:
      d.segments.push_back({static_cast<Index>(random.below(n)), static_cast<Index>(random.below(n))});
      break;
    case 3:
      if (!d.segments.empty()) d.segments.pop_back();
      break;
    case 4:
      if (!d.segments.empty()) d.segments.push_back({d.segments[0].b, d.segments[0].a});
      break;
    case 5:
      d.segments.push_back({0, n});
      break;
    case 6:
      d.holes.push_back(seed_near_a_point());
      break;
    case 7:
      d.regions.push_back({seed_near_a_point(), 1});
      break;
    case 8:
      d.regions.push_back({seed_near_a_point(), 0, random.one_of<double>({0, -1, std::nan("")})});
      break;
    case 9:
      for (LatticePoint& p : d.points) p.y = p.x;
      break;
    case 10:
      if (!d.holes.empty()) move(any_of(d.holes, random));
      break;
    default: {  // a point near the middle of two points; it may lie on a segment
      const LatticePoint a = any_of(d.points, random), b = any_of(d.points, random);
      d.points.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2});
    }
  }
  return d;
}

PARDEL_PROPERTY(Generator, domains_are_valid,
                {.statement = "Every generated domain is valid.",
                 .source = "lattice_domain.hpp",
                 .families = every_family}) {
  const LatticeDomain domain = *domains();
  exhibit.show(to_pslg(domain));
  RC_TAG(std::string(name(domain.family)));
  properties::classify(!domain.holes.empty(), "with holes", 16);
  properties::classify(!domain.regions.empty(), "with regions", 18);
  properties::classify(domain.segments.empty(), "points alone", 2);
  RC_ASSERT(is_valid(domain));
  RC_ASSERT(domain.points.size() >= 3U);
  RC_ASSERT(domain.points.size() <= 70U);
}

PARDEL_PROPERTY(Generator, domains_have_the_trait_of_their_family,
                {.statement = "Every generated domain has the trait of its family.",
                 .source = "lattice_domain.hpp, Family",
                 .families = every_family}) {
  const LatticeDomain domain = *domains();
  exhibit.show(to_pslg(domain));
  RC_TAG(std::string(name(domain.family)));
  RC_ASSERT(has_trait(domain.family, domain));
}

PARDEL_FACT(Generator, draws_every_family_often_enough,
            {.statement = "Each family has a share of at least 5 % of the generated domains (expected: 9.1 %).",
             .source = "lattice_domain.hpp",
             .families = every_family}) {
  std::vector<std::uint64_t> drawn(all_families().size());
  for (std::uint64_t seed = 1; seed <= 5'000; ++seed) {
    Random random(seed);
    ++drawn[static_cast<std::size_t>(any_domain(random, static_cast<int>(seed % 101)).family)];
    ++facts.cases;
  }
  for (const Family family : all_families()) {
    const double percent =
        100.0 * static_cast<double>(drawn[static_cast<std::size_t>(family)]) / static_cast<double>(facts.cases);
    EXPECT_GE(percent, 5) << name(family);
    facts.notes.push_back(std::string(name(family)) + ": " + std::to_string(percent) + " %");
  }
}

PARDEL_PROPERTY(Generator, is_valid_agrees_with_the_mesher,
                {.statement = "is_valid() and the mesher's validate() agree on valid and on invalid domains.",
                 .source = "lattice_domain.hpp, parallel/validate.hpp",
                 .families = "all families, equally likely, each domain with one random change"}) {
  const LatticeDomain domain = *unshrunk(spoiled);
  const Pslg pslg = to_pslg(domain);
  exhibit.show(pslg);
  const std::vector<Problem> problems = find_problems(pslg);
  RC_TAG(std::string(problems.empty() ? "valid" : name(problems.front().kind)));
  RC_ASSERT(is_valid(domain) == problems.empty());
}

PARDEL_PROPERTY(
    Generator, coordinates_are_exact,
    {.statement = "A point with lattice coordinate k has the coordinate (k + offset) / 2^exponent, without rounding. "
                  "Seeds of holes and regions have lattice coordinates in quarters.",
     .source = "lattice_domain.hpp",
     .families = every_family}) {
  const LatticeDomain domain = *domains();
  const Pslg pslg = to_pslg(domain);
  exhibit.show(pslg);
  const auto on_lattice = [&](Point p, LatticePoint wanted, int quarters) {
    const auto back = [&](double x, std::int64_t offset) {
      return static_cast<std::int64_t>(std::ldexp(x, domain.exponent) * quarters) - quarters * offset;
    };
    return back(p.x, domain.offset.x) == wanted.x && back(p.y, domain.offset.y) == wanted.y;
  };
  for (std::size_t i = 0; i < pslg.points.size(); ++i) RC_ASSERT(on_lattice(pslg.points[i], domain.points[i], 1));
  for (std::size_t i = 0; i < pslg.holes.size(); ++i) RC_ASSERT(on_lattice(pslg.holes[i], domain.holes[i], 4));
  for (std::size_t i = 0; i < pslg.regions.size(); ++i)
    RC_ASSERT(on_lattice(pslg.regions[i].seed, domain.regions[i].seed, 4));
}

/// The largest coordinate, divided by the least distance of two points.
double range_of_lengths(const Pslg& pslg) {
  double largest = 0, least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
    const Point p = pslg.points[i];
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    for (std::size_t k = 0; k < i; ++k)
      least = std::min(least, std::hypot(p.x - pslg.points[k].x, p.y - pslg.points[k].y));
  }
  return largest / least;
}

PARDEL_PROPERTY(Generator, mixes_scales_to_valid_domains,
                {.statement = "Every domain that mixes scales is valid, and so are its parts. Where there are two "
                              "components, the domain begins with the points and segments of the first one, followed "
                              "by those of the second one.",
                 .source = "generators/mixed_scales.hpp",
                 .families = every_family}) {
  const Pslg one = to_pslg(*domains()), other = to_pslg(*domains());
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Mixed mixed = mixed_scales(one, other, random, random.chance(4));
  exhibit.show(mixed.pslg);
  for (const Mixture mixture : mixed.what) RC_TAG(std::string(name(mixture)));
  properties::classify(range_of_lengths(mixed.pslg) > 0x1p20, "lengths differ by more than 2^20", 60);
  RC_ASSERT(find_problems(mixed.pslg).empty());
  for (const Pslg& part : mixed.parts) RC_ASSERT(find_problems(part).empty());
  properties::classify(mixed.parts.size() == 2, "two components", 15);
  if (mixed.parts.size() != 2) return;
  const Pslg &first = mixed.parts[0], &second = mixed.parts[1];
  RC_ASSERT(std::ranges::equal(first.points, std::span(mixed.pslg.points).first(first.points.size())));
  RC_ASSERT(std::ranges::equal(second.points,
                               std::span(mixed.pslg.points).subspan(first.points.size(), second.points.size())));
  RC_ASSERT(mixed.pslg.segments.size() == first.segments.size() + second.segments.size());
}

PARDEL_PROPERTY(Generator, cases_have_small_meshes,
                {.statement = "The mesh of a random domain with a random goal has at most 4,000 triangles.",
                 .source = "goals.hpp",
                 .families = every_family}) {
  const Case c = *cases();
  const Pslg pslg = to_pslg(c.domain);
  exhibit.show(pslg);
  const Result<Meshed> meshed = mesh(pslg, to_goal(c.goal, c.domain), {.max_vertices = 10'000});
  RC_ASSERT(meshed.ok());
  const std::size_t triangles = meshed->mesh.triangles.size();
  RC_TAG(std::string(triangles < 30      ? "< 30"
                     : triangles < 300   ? "30 to 299"
                     : triangles < 1'000 ? "300 to 999"
                                         : ">= 1,000"));
  RC_ASSERT(triangles <= 4'000U);
}

PARDEL_PROPERTY(Shrinker, shrinks_are_valid,
                {.statement = "Every shrunk domain is valid.",
                 .source = "lattice_domain.hpp",
                 .families = every_family}) {
  const LatticeDomain domain = *small_domains();
  exhibit.show(to_pslg(domain));
  for (const LatticeDomain& simpler : shrinks(domain)) {
    exhibit.show(to_pslg(simpler));
    RC_ASSERT(is_valid(simpler));
  }
}

PARDEL_PROPERTY(Shrinker, shrinks_have_a_smaller_weight,
                {.statement = "Every shrunk domain has a smaller weight() than the original. So shrinking ends.",
                 .source = "lattice_domain.hpp",
                 .families = every_family}) {
  const LatticeDomain domain = *small_domains();
  exhibit.show(to_pslg(domain));
  for (const LatticeDomain& simpler : shrinks(domain)) {
    RC_ASSERT(simpler != domain);
    RC_ASSERT(weight(simpler) < weight(domain));
  }
}

/// Shrinks like RapidCheck: continues with the first simpler domain for which `holds` is true, until there is none.
LatticeDomain shrunk(LatticeDomain domain, const std::function<bool(const LatticeDomain&)>& holds) {
  for (bool ended = false; !ended;) {
    std::vector<LatticeDomain> simpler = shrinks(domain);
    const auto next = std::ranges::find_if(simpler, holds);
    ended = next == simpler.end();
    if (!ended) domain = std::move(*next);
  }
  return domain;
}

PARDEL_PROPERTY(Shrinker, ends_with_one_triangle,
                {.statement = "If no trait has to be kept, every domain shrinks to one triangle.",
                 .source = "lattice_domain.hpp",
                 .families = every_family}) {
  const LatticeDomain domain = *small_domains();
  exhibit.show(to_pslg(domain));
  const LatticeDomain least = shrunk(domain, [](const LatticeDomain&) { return true; });
  exhibit.show(to_pslg(least));
  RC_ASSERT(least.points.size() == 3U);
  RC_ASSERT(least.holes.empty() && least.regions.empty());
  RC_ASSERT(weight(least).oddities == 0U);
}

PARDEL_PROPERTY(Shrinker, finds_a_small_domain_with_a_hole,
                {.statement = "If a hole has to be kept, a domain shrinks to one hole and at most ten points.",
                 .source = "lattice_domain.hpp",
                 .families = "nested and touching holes"}) {
  const Family family = *rc::gen::element(Family::nested_holes, Family::touching_holes);
  const LatticeDomain domain =
      *unshrunk([family](Random& random, int size) { return generate(family, random, size / 6); });
  exhibit.show(to_pslg(domain));
  const LatticeDomain least = shrunk(domain, [](const LatticeDomain& d) { return !d.holes.empty(); });
  exhibit.show(to_pslg(least));
  RC_ASSERT(least.holes.size() == 1U);
  RC_ASSERT(least.points.size() <= 10U);
}

PARDEL_PROPERTY(Shrinker, finds_a_domain_with_exactly_the_required_number_of_points,
                {.statement = "If k points have to be kept, a domain shrinks to exactly k points.",
                 .source = "lattice_domain.hpp",
                 .families = every_family}) {
  const LatticeDomain domain = *small_domains();
  exhibit.show(to_pslg(domain));
  const std::size_t k = *rc::gen::inRange<std::size_t>(3, domain.points.size() + 1);
  const LatticeDomain least = shrunk(domain, [k](const LatticeDomain& d) { return d.points.size() >= k; });
  exhibit.show(to_pslg(least));
  RC_ASSERT(least.points.size() == k);
}

PARDEL_PROPERTY(Shrinker, finds_a_small_domain_with_the_trait,
                {.statement = "If the trait of its family has to be kept, a domain shrinks to at most 16 points.",
                 .source = "lattice_domain.hpp",
                 .families = every_family}) {
  const LatticeDomain domain = *small_domains();
  exhibit.show(to_pslg(domain));
  const LatticeDomain least = shrunk(domain, [&](const LatticeDomain& d) { return has_trait(domain.family, d); });
  exhibit.show(to_pslg(least));
  RC_TAG(std::string(name(domain.family)));
  RC_ASSERT(least.points.size() <= 16U);
}

PARDEL_PROPERTY(
    Shrinker, goals_shrink_to_the_default,
    {.statement = "Shrinking a goal sets one number at a time to its default. It ends when all numbers have "
                  "their defaults.",
     .source = "goals.hpp",
     .families = every_family}) {
  const Case c = *unshrunk([](Random& random, int size) { return any_case(random, size / 3); });
  exhibit.show(to_pslg(c.domain));
  LatticeGoal goal = c.goal;
  for (int steps = 0; goal != LatticeGoal{}; ++steps) {
    RC_ASSERT(steps < 4);
    const std::vector<LatticeGoal> simpler = shrinks(goal);
    RC_ASSERT(!simpler.empty());
    RC_ASSERT(std::ranges::find(simpler, goal) == simpler.end());
    goal = simpler.front();
  }
  RC_ASSERT(shrinks(goal).empty());
  const std::vector<Case> simpler = shrinks(c);
  RC_ASSERT(std::ranges::find(simpler, c) == simpler.end());
}

}  // namespace
}  // namespace pardel::generators
