// Delaunay triangulation without refinement: random points, and the two slowest kinds of input.
#include <benchmark/benchmark.h>

#include "../parallel/mesher.hpp"
#include "../properties/domains/domains.hpp"

namespace pardel {
namespace {

void run(benchmark::State& state, const Pslg& pslg) {
  std::size_t triangles = 0;
  for (auto _ : state) {
    const Result<Meshed> meshed = triangulate(pslg, true, {.threads = 1});
    if (!meshed) {
      state.SkipWithError(meshed.error().message.c_str());
      return;
    }
    triangles = meshed->mesh.triangles.size();
  }
  state.counters["points/s"] =
      benchmark::Counter(static_cast<double>(pslg.points.size()), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["triangles"] = static_cast<double>(triangles);
}

void triangulate_random_points(benchmark::State& state) {
  run(state, domains::random_points(static_cast<std::uint64_t>(state.range(0)), 1));
}
BENCHMARK(triangulate_random_points)->RangeMultiplier(10)->Range(1'000, 1'000'000)->Unit(benchmark::kMillisecond);

/// Points that are dense around a point, along a line, and in clusters: the cells of a lattice would be very uneven.
void triangulate_uneven_points(benchmark::State& state, const char* domain) {
  run(state, *domains::generate(domain, static_cast<std::uint64_t>(state.range(0)), 1));
}
BENCHMARK_CAPTURE(triangulate_uneven_points, kuzmin, "kuzmin")->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(triangulate_uneven_points, line, "line")->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(triangulate_uneven_points, clusters, "clusters")->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// The four corners of each cell are cocircular, so the filter of the in-circle test never decides.
void triangulate_lattice_points(benchmark::State& state) {
  run(state, domains::grid_points(static_cast<int>(state.range(0))));
}
BENCHMARK(triangulate_lattice_points)->Arg(31)->Arg(316)->Unit(benchmark::kMillisecond);

/// The lattice points of the previous benchmark, with all lattice edges and one diagonal per cell as constraints.
void triangulate_constrained_grid(benchmark::State& state) {
  run(state, domains::grid(static_cast<int>(state.range(0))));
}
BENCHMARK(triangulate_constrained_grid)->Arg(31)->Arg(316)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pardel

BENCHMARK_MAIN();
