// Triangulation, insertion of single points, refinement, and interiors of equilateral triangles.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "../../parallel/construction/bowyer_watson.hpp"
#include "../../parallel/construction/delaunay.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/domains/domains.hpp"
#include "../../properties/domains/generators/random.hpp"
#include "meshing.hpp"
#include "workload.hpp"

namespace pardel::workloads {
namespace {

/// Triangulates the points without refining them.
Job triangulating(const Setup& setup, const Pslg& pslg) { return meshing(setup, pslg, {.min_angle_deg = 0}); }

Job triangulation(const Setup& setup) {
  return triangulating(setup, domains::kuzmin_points(setup.pick(20'000U, 200'000U), 1));
}
Job triangulation_uniform(const Setup& setup) {
  return triangulating(setup, domains::random_points(setup.pick(20'000U, 200'000U), 1));
}
Job triangulation_line(const Setup& setup) {
  return triangulating(setup, domains::line_points(setup.pick(10'000U, 200'000U), 1));
}
Job triangulation_grid(const Setup& setup) { return triangulating(setup, domains::grid_points(setup.pick(100, 450))); }

/// Inserts points one after another into a triangulation of uniform points. Each lies near the last one, on a row of
/// a lattice that runs to and fro.
Job insertion(const Setup& setup) {
  struct State {
    engine::Triangulation before, t;
    std::uint64_t first = 0;
  };
  const auto state = std::make_shared<State>();
  const int side = setup.pick(120, 700);
  const Pslg old = domains::random_points(setup.pick(20'000U, 400'000U), 1);
  Result<engine::Delaunay> made = engine::delaunay(old.points);
  if (!made) return {.work = [] { return false; }};
  state->before = std::move(made.value().triangulation);
  state->first = state->before.points.size();
  generators::Random random(2004);
  for (int row = 0; row < side; ++row)
    for (int i = 0; i < side; ++i) {
      const int column = row % 2 == 0 ? i : side - 1 - i;
      const double x = column + random.uniform(), y = row + random.uniform();
      state->before.points.push_back({0.1 + 0.8 * x / side, 0.1 + 0.8 * y / side});
    }
  const auto added = static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side);
  const std::uint64_t slots = state->before.slots.size();
  state->before.slots.resize(slots + 2 * added);
  state->t = state->before;
  return {.work =
              [state, added, slots] {
                engine::Triangulation& t = state->t;
                engine::BowyerWatson worker(t);
                engine::TriangleId near = 0;
                while (t.slots[near].is_ghost()) ++near;
                worker.start(engine::Box{}, near);
                for (std::uint64_t i = 0; i < added; ++i) {
                  const auto vertex = static_cast<engine::VertexId>(state->first + i);
                  const auto fresh = static_cast<engine::TriangleId>(slots + 2 * i);
                  if (worker.insert(vertex, fresh) != engine::Inserted::yes) return false;
                }
                return true;
              },
          .items = added};
}

Job refinement(const Setup& setup) {
  return meshing(setup, domains::pipe(), {.max_area = setup.pick(1.54e-4, 6.8e-6)});
}
Job refinement_square(const Setup& setup) {
  return meshing(setup, domains::square(), {.max_area = setup.pick(6e-5, 2.7e-6)});
}
Job refinement_key(const Setup& setup) {
  return meshing(setup, domains::key(), {.min_angle_deg = 30, .max_area = setup.pick(1e-3, 1.5e-5)});
}
/// The bound on lengths grows with the distance from the centre, by the same factor everywhere.
Job refinement_radial(const Setup& setup) {
  const double ratio = setup.pick(0.1, 0.03);
  return meshing(setup, domains::radial(4), {.min_angle_deg = 25, .size = [ratio](Point p) {
                                               return ratio * std::max(0.95e-4, std::sqrt(p.x * p.x + p.y * p.y));
                                             }});
}
Job angles(const Setup& setup) {
  return meshing(setup, domains::random_points(setup.pick(3000U, 60'000U), 1), {.min_angle_deg = 30});
}
Job graded(const Setup& setup) {
  return meshing(setup, domains::key(), {.grading = setup.pick(0.25, 0.1), .feature_edges = setup.pick(6.0, 20.0)});
}
Job fill(const Setup& setup) {
  return meshing(setup, domains::pipe(), {.max_area = setup.pick(1e-5, 1e-6)}, Interior::fill);
}

constexpr Workload list[] = {
    {"triangulation", true, true, triangulation},
    {"refinement", true, true, refinement},
    {"angles", true, true, angles},
    {"graded", true, true, graded},
    {"fill", true, true, fill},
    {"triangulation_uniform", false, true, triangulation_uniform},
    {"triangulation_line", false, true, triangulation_line},
    {"triangulation_grid", false, true, triangulation_grid},
    {"insertion", false, false, insertion},
    {"refinement_square", false, true, refinement_square},
    {"refinement_key", false, true, refinement_key},
    {"refinement_radial", false, true, refinement_radial},
};

}  // namespace

Job meshing(const Setup& setup, const Pslg& pslg, const Goal& goal, Interior interior) {
  const auto made = std::make_shared<std::optional<Result<Meshed>>>();
  return {.work =
              [=, threads = setup.threads] {
                made->emplace(pardel::mesh(pslg, goal, {.interior = interior, .threads = threads}));
                return (*made)->ok();
              },
          .mesh = [made]() -> const Mesh& { return (**made)->mesh; }};
}

std::span<const Workload> of_meshes() { return list; }

}  // namespace pardel::workloads
