#include "locator.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "../core/support/name_of_triangle.hpp"
#include "../core/support/shortest.hpp"
#include "location/search_tree.hpp"
#include "location/visit_by_tile.hpp"
#include "location/weights.hpp"
#include "sizing/guarded.hpp"
#include "threads/parallel_arrays.hpp"

namespace pardel {

using namespace engine;

namespace {

bool is_turned(const Mesh& mesh, const Triangle& t) {
  return orient2d(mesh.points[t.v[0]], mesh.points[t.v[1]], mesh.points[t.v[2]]) < 0;
}

/// What is wrong with a triangle, or nothing.
std::string fault_of(const Mesh& mesh, const Triangle& triangle) {
  for (const Index v : triangle.v) {
    if (v >= mesh.points.size()) return "has a corner that is not a point of the mesh";
    if (!is_usable(mesh.points[v]))
      return "has a corner at " + shortest(mesh.points[v]) +
             ", which is out of range: magnitudes from 2^-140 to 2^200 and zero are usable";
  }
  return is_turned(mesh, triangle) ? "is clockwise; points are located in counter-clockwise triangles" : "";
}

bool is_faulty(const Mesh& mesh, const Triangle& triangle) {
  return std::ranges::any_of(triangle.v,
                             [&](Index v) { return v >= mesh.points.size() || !is_usable(mesh.points[v]); }) ||
         is_turned(mesh, triangle);
}

Status check_triangles(const Mesh& mesh, const Threads& threads) {
  const Array<Index> faulty =
      indices_where(threads, mesh.triangles.size(), [&](std::size_t t) { return is_faulty(mesh, mesh.triangles[t]); });
  if (faulty.empty()) return Done{};
  return Error{ErrorKind::invalid_input,
               name_of_triangle(mesh, faulty[0], " of the mesh") + " " + fault_of(mesh, mesh.triangles[faulty[0]])};
}

/// work(threads), where a request of the caller to stop becomes an error.
template <class Work>
Status stoppable(const LocatorOptions& options, const Work& work) try {
  StopSignal stop(StopSignal::unless(options.go_on));
  stop.ask();  // in a short loop, other threads may do all the work, and do not ask
  return work(Threads(thread_count(options.threads), &stop));
} catch (const Stopped& stopped) {
  return stopped.error;
} catch (...) {
  return error_of_exception();
}

/// Calls visit(i) for all points, on all threads.
template <class Visit>
void visit_all(const Threads& threads, std::span<const Point> points, const Box& bounds, const Visit& visit) {
  constexpr std::size_t most_in_part = 1U << 17, parts_per_thread = 4;
  const std::size_t wanted = std::max(parts_per_thread * static_cast<std::size_t>(threads.count),
                                      (points.size() + most_in_part - 1) / most_in_part);
  parallel_for(threads, std::min(points.size(), wanted), [&](std::size_t part, int) {
    const std::size_t parts = std::min(points.size(), wanted);
    const std::size_t first = points.size() * part / parts, end = points.size() * (part + 1) / parts;
    SparseAsk ask(threads.stop);
    visit_by_tile(points.subspan(first, end - first), bounds, [&](std::size_t i) {
      ask();
      visit(first + i);
    });
  });
}

}  // namespace

Result<Locator> Locator::over(const Mesh& mesh, const LocatorOptions& options) {
  std::shared_ptr<const SearchTree> tree;
  const Status made = stoppable(options, [&](const Threads& threads) -> Status {
    if (Status status = check_triangles(mesh, threads); !status) return status;
    tree = std::make_shared<const SearchTree>(LocatedTriangles{mesh.points.span(), mesh.triangles.span()}, threads);
    return Done{};
  });
  if (!made) return made.error();
  return Locator(std::move(tree));
}

Index Locator::triangle_at(Point p) const { return tree_->first_around(p); }

Status Locator::triangles_at(std::span<const Point> points, std::span<Index> result,
                             const LocatorOptions& options) const {
  return stoppable(options, [&](const Threads& threads) -> Status {
    visit_all(threads, points, tree_->bounds(), [&](std::size_t i) { result[i] = tree_->first_around(points[i]); });
    return Done{};
  });
}

std::array<double, 3> Locator::weights_at(Index triangle, Point p) const {
  return weights_in(tree_->all().corners(triangle), {snapped(p.x), snapped(p.y)});
}

Status Locator::interpolate(std::span<const double> values, std::size_t columns, std::span<const Point> points,
                            std::span<double> result, double outside, const LocatorOptions& options) const {
  const auto interpolate_at = [&](Point p, std::span<double> row) {
    const Index t = tree_->first_around(p);
    if (t == no_index) {
      std::ranges::fill(row, outside);
      return;
    }
    const std::array<double, 3> weights = weights_at(t, p);
    const auto& v = tree_->all().triangles[t].v;
    for (std::size_t k = 0; k < columns; ++k)
      row[k] = blend(weights, {values[v[0] * columns + k], values[v[1] * columns + k], values[v[2] * columns + k]});
  };
  return stoppable(options, [&](const Threads& threads) -> Status {
    visit_all(threads, points, tree_->bounds(),
              [&](std::size_t i) { interpolate_at(points[i], result.subspan(i * columns, columns)); });
    return Done{};
  });
}

}  // namespace pardel
