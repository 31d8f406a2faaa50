// The time of a predicate: for points where the filter can decide, for lattices, and where only exact arithmetic can
// decide.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../parallel/arithmetic/predicates.hpp"
#include "../properties/domains/generators/random.hpp"

namespace pardel {
namespace {

using Four = std::array<Point, 4>;

class Random : public generators::Random {
 public:
  Random() : generators::Random(2004) {}
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
  int below(int n) { return static_cast<int>(uniform() * n); }
};

Four cell(double x0, double x1, double y0, double y1) { return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}; }

Four uniform(Random& random) {
  Four points;
  for (Point& p : points) p = {random.uniform(), random.uniform()};
  return points;
}
Four unit_cell(Random& random) {
  const int x = random.below(1000), y = random.below(1000);
  return cell(x, x + 1, y, y + 1);
}
Four large_square(Random& random) {
  const int x = random.below(100'000'000), y = random.below(100'000'000), side = 1 + random.below(100'000'000);
  return cell(x, x + side, y, y + side);
}
Four cell_of_tenths(Random& random) {
  const int x = random.below(1000), y = random.below(1000);
  return cell(x * 0.1, (x + 1) * 0.1, y * 0.1, (y + 1) * 0.1);
}
Four rectangle(Random& random) { return cell(random.uniform(), random.uniform(), random.uniform(), random.uniform()); }
Four on_a_circle(Random& random) {
  Four points;
  for (Point& p : points) {
    const double angle = 6.28 * random.uniform();
    p = {std::cos(angle), std::sin(angle)};
  }
  return points;
}
Four on_a_line(Random& random) {
  Four points;
  for (Point& p : points) p.x = p.y = random.uniform();
  return points;
}

constexpr std::size_t cases = 4096;

template <class Predicate>
void measure(benchmark::State& state, Four (*generate)(Random&), const Predicate& predicate) {
  Random random;
  std::vector<Four> inputs(cases);
  for (Four& four : inputs) four = generate(random);
  for (auto _ : state)
    for (const Four& four : inputs) benchmark::DoNotOptimize(predicate(four));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * cases));
}
void orient2d_of(benchmark::State& state, Four (*generate)(Random&)) {
  measure(state, generate, [](const Four& p) { return engine::orient2d(p[0], p[1], p[2]); });
}
void incircle_of(benchmark::State& state, Four (*generate)(Random&)) {
  measure(state, generate, [](const Four& p) { return engine::incircle(p[0], p[1], p[2], p[3]); });
}

BENCHMARK_CAPTURE(orient2d_of, uniform, uniform);
BENCHMARK_CAPTURE(orient2d_of, on_a_line, on_a_line);
BENCHMARK_CAPTURE(incircle_of, uniform, uniform);
BENCHMARK_CAPTURE(incircle_of, unit_cell, unit_cell);
BENCHMARK_CAPTURE(incircle_of, large_square, large_square);
BENCHMARK_CAPTURE(incircle_of, cell_of_tenths, cell_of_tenths);
BENCHMARK_CAPTURE(incircle_of, rectangle, rectangle);
BENCHMARK_CAPTURE(incircle_of, on_a_circle, on_a_circle);

}  // namespace
}  // namespace pardel

BENCHMARK_MAIN();
