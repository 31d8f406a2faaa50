// The predicates: as triangulations call them, and each stage of their exact part alone.
#include "../../parallel/arithmetic/predicates.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "../../parallel/arithmetic/predicate_stages.hpp"
#include "../../properties/domains/generators/random.hpp"
#include "workload.hpp"

namespace pardel::workloads {
namespace {

using engine::exact::Stage;
using Four = std::array<Point, 4>;

/// Four points on a line or on a circle, or nearly. The sequence of `kind`s covers all stages.
Four degenerate(generators::Random& random, bool circle, int kind) {
  const auto whole = [&](std::uint64_t n) { return static_cast<double>(random.next() % n); };
  if (kind == 0) {  // corners of a square, and points of a line, on a fine lattice: differences are doubles
    const double x = whole(1U << 30U), y = whole(1U << 30U), w = 1 + whole(1U << 30U), h = 1 + whole(1U << 30U);
    if (circle) return {{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}};
    return {{{x, y}, {x + w, y + h}, {x + 2 * w, y + 2 * h}, {x + 3 * w, y + 3 * h}}};
  }
  if (kind == 1) {  // unit cells
    const double x = whole(1000), y = whole(1000);
    return {{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
  }
  if (kind == 2) {  // rectangles and points of a diagonal with coordinates of two magnitudes: differences are rounded
    const double x = random.uniform(), y = random.uniform(), u = random.uniform(100, 1000),
                 v = random.uniform(100, 1000);
    if (circle) return {{{x, y}, {u, y}, {u, v}, {x, v}}};
    return {{{x, x}, {y, y}, {u, u}, {v, v}}};
  }
  Four points;
  for (Point& p : points) {  // the nearest doubles to points of a circle, or of a line
    const double t = random.uniform();
    p = circle ? Point{(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)} : Point{t, t / 3 + 0.1};
  }
  if (kind == 4) points[0].x *= 1 + 0x1p-50;  // a little off it
  return points;
}

/// Inputs that this stage decides.
std::vector<Four> decided_by(Stage stage, bool circle) {
  constexpr std::size_t wanted = 1000;
  constexpr int kinds = 5, most_trials = 2'000'000;
  generators::Random random(2004);
  std::vector<Four> found;
  for (int i = 0; i < most_trials && found.size() < wanted; ++i) {
    const Four p = degenerate(random, circle, i % kinds);
    const engine::exact::Decision decision = circle ? engine::exact::decide_incircle(p[0], p[1], p[2], p[3])
                                                    : engine::exact::decide_orient2d(p[0], p[1], p[2]);
    if (decision.stage == stage) found.push_back(p);
  }
  return found;
}

/// Points for which the filter decides.
std::vector<Four> uniform() {
  generators::Random random(2004);
  std::vector<Four> found(1000);
  for (Four& four : found)
    for (Point& p : four) p = {random.uniform(), random.uniform()};
  return found;
}

/// Evaluates a predicate for each input, again and again: `rounds` times in the counted size.
template <class Predicate>
Job evaluating(const Setup& setup, std::vector<Four> inputs, int rounds, const Predicate& predicate) {
  const int repeated = setup.pick(rounds, 40 * rounds);
  const std::uint64_t items = inputs.size() * static_cast<std::uint64_t>(repeated);
  return {.work =
              [=, given = std::move(inputs)] {
                if (given.empty()) return false;
                volatile double last = 0;
                for (int i = 0; i < repeated; ++i)
                  for (const Four& p : given) last = predicate(p);
                return !std::isnan(last);
              },
          .items = items};
}

double orientation(const Four& p) { return engine::orient2d(p[0], p[1], p[2]); }
double circle(const Four& p) { return engine::incircle(p[0], p[1], p[2], p[3]); }

Job orient2d_filter(const Setup& setup) { return evaluating(setup, uniform(), 100, orientation); }
Job incircle_filter(const Setup& setup) { return evaluating(setup, uniform(), 100, circle); }

template <Stage stage>
Job orient2d(const Setup& setup) {
  return evaluating(setup, decided_by(stage, false), 50, orientation);
}
template <Stage stage>
Job incircle(const Setup& setup) {
  return evaluating(setup, decided_by(stage, true), stage == Stage::lattice ? 20 : 3, circle);
}

constexpr Workload list[] = {
    {"orient2d_filter", false, false, orient2d_filter},
    {"orient2d_exact_differences", false, false, orient2d<Stage::exact_differences>},
    {"orient2d_rounded_differences", false, false, orient2d<Stage::rounded_differences>},
    {"orient2d_corrected", false, false, orient2d<Stage::corrected>},
    {"orient2d_expansions", false, false, orient2d<Stage::expansions>},
    {"incircle_filter", false, false, incircle_filter},
    {"incircle_lattice", false, false, incircle<Stage::lattice>},
    {"incircle_exact_differences", false, false, incircle<Stage::exact_differences>},
    {"incircle_rounded_differences", false, false, incircle<Stage::rounded_differences>},
    {"incircle_corrected", false, false, incircle<Stage::corrected>},
    {"incircle_expansions", false, false, incircle<Stage::expansions>},
};

}  // namespace

/// Uniform points, where the filters decide, and corners of lattice cells, where most answers are exactly zero.
Job mixed_predicates(const Setup& setup) {
  const int cases = setup.pick(60'000, 600'000);
  return {.work =
              [cases] {
                generators::Random random(2004);
                const auto coordinate = [&](std::uint64_t cells) {
                  return static_cast<double>(random.next() % cells) / static_cast<double>(cells);
                };
                std::size_t positive = 0;
                for (int i = 0; i < cases; ++i) {
                  const std::uint64_t cells = i % 4 == 0 ? 5 : std::uint64_t{1} << 50U;
                  const Point a{coordinate(cells), coordinate(cells)}, b{coordinate(cells), coordinate(cells)},
                      c{coordinate(cells), coordinate(cells)}, d{coordinate(cells), coordinate(cells)};
                  positive += engine::orient2d(a, b, c) > 0;
                  positive += engine::incircle(a, b, c, d) > 0;
                }
                return positive > 0;
              },
          .items = 2 * static_cast<std::uint64_t>(cases)};
}

std::span<const Workload> of_predicates() { return list; }

}  // namespace pardel::workloads
