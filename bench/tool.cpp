#include "tool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "../properties/checker/check.hpp"
#include "../properties/domains/domains.hpp"

namespace pardel::bench {

Pslg make_domain(const Task& task) {
  // The size of this domain is its number of cells along a side.
  const bool is_grid = task.domain == "grid-points";
  const std::uint64_t n =
      is_grid && task.points > 0 ? static_cast<std::uint64_t>(std::sqrt(task.points)) - 1 : task.points;
  Result<Pslg> made = domains::generate(task.domain, n, task.seed);
  return made ? std::move(*made) : Pslg{};
}

bool is_point_set(const Task& task) {
  constexpr std::array sets = {"points", "kuzmin", "line", "clusters", "grid-points"};
  return std::ranges::find(sets, task.domain) != sets.end();
}

double domain_area(const Task& task) {
  if (task.domain == "points") return 1;
  const Pslg pslg = make_domain(task);
  // The boundary of every domain used here consists of disjoint closed chains, whose segments are in order. The outer
  // chain has the largest area; all others are holes.
  double largest = 0, sum = 0, chain = 0;
  for (std::size_t i = 0; i < pslg.segments.size(); ++i) {
    const Point a = pslg.points[pslg.segments[i].a], b = pslg.points[pslg.segments[i].b];
    chain += (a.x * b.y - b.x * a.y) / 2;
    const bool ends = i + 1 == pslg.segments.size() || pslg.segments[i + 1].a != pslg.segments[i].b;
    if (!ends) continue;
    largest = std::max(largest, std::abs(chain));
    sum += std::abs(chain);
    chain = 0;
  }
  return 2 * largest - sum;
}

bool is_graded(const Task& task) { return task.domain == "radial"; }

Grading grading(const Task& task) {
  // Measured on five decades: the mean area of a triangle, divided by the square of the wanted edge length.
  constexpr double mean_area = 0.2156;
  const double inner = 0.95 * std::pow(10, -static_cast<double>(task.points));
  // The integral of 1 / max(inner, r)^2 over a square with sides of length 2: over the inner disk, over the ring up to
  // the radius 1, and over the corners of the square.
  const double integral = std::numbers::pi - 2 * std::numbers::pi * std::log(inner) + 0.69;
  return {std::sqrt(integral / (mean_area * static_cast<double>(task.triangles))), inner};
}

void set_size(Task& task) {
  if (is_graded(task) && task.points == 0) task.points = 4;
  if (task.triangles == 0) return;
  if (is_graded(task)) {
    const Grading size = grading(task);
    task.goal.size = size;
    task.goal.size_slope = size.ratio;
  } else
    task.goal.max_area = triangles_per_cap * domain_area(task) / static_cast<double>(task.triangles);
}

Shapes shapes(const Mesh& mesh) {
  Shapes all{.least = 1};
  const auto squared = [](Point p, Point q) { return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y); };
  for (const Triangle& t : mesh.triangles) {
    const Point a = mesh.points[t.v[0]], b = mesh.points[t.v[1]], c = mesh.points[t.v[2]];
    const double twice_area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    const double shape = 2 * std::numbers::sqrt3 * twice_area / (squared(a, b) + squared(b, c) + squared(c, a));
    all.mean += shape;
    all.least = std::min(all.least, shape);
    all.good += shape > 0.9 ? 1 : 0;
  }
  const double n = std::max<double>(1, static_cast<double>(mesh.triangles.size()));
  all.mean /= n;
  all.good /= n;
  return all;
}

namespace {

std::string verdict(const Task& task, const Mesh& mesh, bool foreign) {
  if (!task.check) return "not checked";
  Goal goal = task.goal;
  if (task.delaunay_only) {
    goal = Goal{};
    goal.min_angle_deg = 0;
  }
  const Certificate certificate = check(make_domain(task), mesh, goal, {.max_violations = 1, .foreign = foreign});
  if (certificate.valid) return "valid";
  std::string text;
  for (std::size_t kind = 0; kind < certificate.violation_counts.size(); ++kind) {
    if (certificate.violation_counts[kind] == 0) continue;
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {}", certificate.violation_counts[kind], name(static_cast<ViolationKind>(kind)));
  }
  return text;
}

}  // namespace

void judge(const Task& task, const Mesh& mesh, bool foreign, Run& run) {
  run.vertices = mesh.points.size();
  run.triangles = mesh.triangles.size();
  run.shapes = shapes(mesh);
  run.set_verdict(verdict(task, mesh, foreign));
}

}  // namespace pardel::bench
