// The program whose instructions bench/gate counts: gate_work WORKLOAD [EXTRA]. Each workload is fixed. Only its own
// work is counted, not the preparation of its input. EXTRA is a number of instructions to waste; the gate's own test
// uses it.
#include <unistd.h>
#include <valgrind/callgrind.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "../core/formats.hpp"
#include "../parallel/arithmetic/predicates.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/domains/domains.hpp"
#include "../properties/domains/generators/random.hpp"

namespace pardel {
namespace {

/// A workload prepares its input, and returns the work: a function that is false if the work fails.
using Work = std::function<bool()>;

const Options one_thread{.threads = 1};

/// Uniform points, where the filters decide, and corners of lattice cells, where most answers are exactly zero.
Work predicates() {
  return [] {
    generators::Random random(2004);
    const auto coordinate = [&](std::uint64_t cells) {
      return static_cast<double>(random.next() % cells) / static_cast<double>(cells);
    };
    std::size_t positive = 0;
    for (int i = 0; i < 60'000; ++i) {
      const std::uint64_t cells = i % 4 == 0 ? 5 : std::uint64_t{1} << 50U;
      const Point a{coordinate(cells), coordinate(cells)}, b{coordinate(cells), coordinate(cells)},
          c{coordinate(cells), coordinate(cells)}, d{coordinate(cells), coordinate(cells)};
      positive += engine::orient2d(a, b, c) > 0;
      positive += engine::incircle(a, b, c, d) > 0;
    }
    return positive > 0;
  };
}

Work meshing(const Pslg& pslg, const Goal& goal, const Options& options = one_thread) {
  return [=] { return mesh(pslg, goal, options).ok(); };
}

Work checking() {
  const Pslg pslg = domains::pipe();
  const Goal goal{.max_area = 1.54e-4};
  return [=, made = mesh(pslg, goal, one_thread)] { return made.ok() && check(pslg, made->mesh, goal).valid; };
}

/// Writes a mesh as text and as VTU, and reads both.
Work files() {
  return [made = mesh(domains::pipe(), {.max_area = 1.54e-4}, one_thread)] {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("pardel-gate-" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    const bool done = made.ok() && write_triangle_files(made->mesh, {}, folder / "m", {}).ok() &&
                      write_vtu(made->mesh, folder / "m.vtu").ok() && read_mesh(folder / "m.node").ok() &&
                      read_mesh(folder / "m.vtu").ok();
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
    return done;
  };
}

std::map<std::string_view, std::function<Work()>> workloads() {
  return {
      {"predicates", predicates},
      {"triangulation", [] { return meshing(domains::kuzmin_points(20'000, 1), {.min_angle_deg = 0}); }},
      {"refinement", [] { return meshing(domains::pipe(), {.max_area = 1.54e-4}); }},
      {"angles", [] { return meshing(domains::random_points(3000, 1), {.min_angle_deg = 30}); }},
      {"graded", [] { return meshing(domains::key(), {.grading = 0.25, .feature_edges = 6}); }},
      {"fill", [] { return meshing(domains::pipe(), {.max_area = 1e-5}, {.interior = Interior::fill, .threads = 1}); }},
      {"check", checking},
      {"files", files},
  };
}

/// Wastes about so many instructions.
[[gnu::noinline]] void planted_slowdown(std::uint64_t instructions) {
  constexpr std::uint64_t instructions_per_step = 4;
  [[maybe_unused]] volatile std::uint64_t count = 0;
  for (std::uint64_t i = 0; i < instructions / instructions_per_step; ++i) count = i;
}

int run(int argc, char** argv) {
  const auto all = workloads();
  const auto found = argc >= 2 ? all.find(argv[1]) : all.end();
  if (found == all.end()) {
    for (const auto& [name, prepare] : all) std::printf("%s\n", std::string(name).c_str());
    return argc == 1 ? 0 : 2;
  }
  const Work work = found->second();
  CALLGRIND_TOGGLE_COLLECT;
  const bool done = work();
  if (argc > 2) planted_slowdown(std::strtoull(argv[2], nullptr, 10));
  CALLGRIND_TOGGLE_COLLECT;
  return done ? 0 : 1;
}

}  // namespace
}  // namespace pardel

int main(int argc, char** argv) { return pardel::run(argc, argv); }
