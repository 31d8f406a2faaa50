// Many small meshes: what a call of the library costs before the size of the mesh counts.
#include <cmath>
#include <memory>
#include <vector>

#include "../../parallel/mesher.hpp"
#include "../../properties/checker/statistics.hpp"
#include "../../properties/domains/domains.hpp"
#include "workload.hpp"

namespace pardel::workloads {
namespace {

struct Task {
  Pslg domain;
  Goal goal;
};

/// Twelve domains: outlines, holes, cracks, regions, combs, spikes, points, a coast.
std::vector<Pslg> twelve_domains() {
  return {domains::square(),      domains::pipe(),           domains::key(),        domains::random_points(40, 1),
          domains::survey(40, 1), domains::coast(96, 1),     domains::star(12, 10), domains::comb(16, 0.01),
          domains::grid(4),       domains::touching_holes(), domains::cracks(),     domains::regions()};
}

/// The domains with bounds for about `triangles` triangles; more where the domain itself needs more.
std::vector<Task> tasks_of(const std::vector<double>& triangles) {
  std::vector<Task> tasks;
  for (const Pslg& domain : twelve_domains()) {
    const Result<Meshed> coarse = mesh(domain, {.min_angle_deg = 0}, {.threads = 1});
    if (!coarse) return {};
    for (const double n : triangles)
      tasks.push_back({domain, {.min_angle_deg = 30, .max_area = statistics(coarse->mesh).area / (0.55 * n)}});
  }
  return tasks;
}

Job small(const Setup& setup) {
  const double most = setup.pick(400.0, 10'000.0);
  const auto tasks = std::make_shared<const std::vector<Task>>(tasks_of({100, most}));
  return {.work =
              [tasks] {
                for (const Task& task : *tasks)
                  if (!mesh(task.domain, task.goal, {.interior = Interior::automatic, .threads = 1})) return false;
                return !tasks->empty();
              },
          .items = tasks->size() * static_cast<std::uint64_t>(most) / 2};
}

constexpr Workload list[] = {{"small", true, false, small}};

}  // namespace

std::span<const Workload> of_small_meshes() { return list; }

}  // namespace pardel::workloads
