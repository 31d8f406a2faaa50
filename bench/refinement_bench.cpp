// Refinement with an area cap, where the order of insertions has little effect; and with only an angle bound, where it
// has much.
#include <benchmark/benchmark.h>

#include <cmath>

#include "../parallel/mesher.hpp"
#include "../properties/domains/domains.hpp"

namespace pardel {
namespace {

void run(benchmark::State& state, const Pslg& pslg, const Goal& goal) {
  std::size_t triangles = 0;
  for (auto _ : state) {
    const Result<Meshed> meshed = mesh(pslg, goal, {.threads = 1});
    if (!meshed) {
      state.SkipWithError(meshed.error().message.c_str());
      return;
    }
    triangles = meshed->mesh.triangles.size();
  }
  state.counters["triangles/s"] =
      benchmark::Counter(static_cast<double>(triangles), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["triangles"] = static_cast<double>(triangles);
}

/// Argument n: the area cap is 10^-n.
Goal capped(const benchmark::State& state) {
  return {.max_area = std::pow(10.0, -static_cast<double>(state.range(0)))};
}

void refine_square(benchmark::State& state) { run(state, domains::square(), capped(state)); }
BENCHMARK(refine_square)->Arg(4)->Arg(5)->Arg(6)->Unit(benchmark::kMillisecond);

void refine_pipe(benchmark::State& state) { run(state, domains::pipe(), capped(state)); }
BENCHMARK(refine_pipe)->Arg(4)->Arg(5)->Arg(6)->Unit(benchmark::kMillisecond);

/// Argument: the minimum angle in tenths of a degree.
void refine_random_points(benchmark::State& state) {
  run(state, domains::random_points(100'000, 1), {.min_angle_deg = static_cast<double>(state.range(0)) / 10});
}
BENCHMARK(refine_random_points)->Arg(207)->Arg(250)->Arg(300)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pardel

BENCHMARK_MAIN();
