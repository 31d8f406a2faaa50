#include "cases.hpp"

#include <cmath>

#include "../../properties/domains/domains.hpp"

namespace pardel::bench {
namespace {

constexpr std::uint64_t seed = 1;
/// Measured: how many triangles Ruppert's algorithm makes of an area cap, as a multiple of the area divided by the cap;
/// and how many it makes per point of a set.
constexpr double triangles_per_cap = 1.55, per_random_point = 3.97, per_clustered_point = 4.9;
constexpr double square_area = 1, pipe_area = 2.486;

Goal with_area(double area, double triangles) {
  Goal goal;
  goal.max_area = triangles_per_cap * area / triangles;
  return goal;
}

/// Lengths for the key: they grow with the distance from the tip of the bit.
SchemeInput graded_key(double triangles) {
  SchemeInput input{domains::key(), {}};
  Point tip = input.pslg.points.front();
  for (const Point p : input.pslg.points)
    if (p.x > tip.x) tip = p;
  // Measured: with these numbers the mesh has 10^5 triangles.
  const double scale = std::sqrt(1e5 / triangles);
  const double least = 8.06e-4 * scale, slope = 1.27e-2 * scale;
  input.goal.size = [=](Point p) { return least + slope * std::hypot(p.x - tip.x, p.y - tip.y); };
  return input;
}

SchemeInput points(const Pslg& pslg, bool refines) {
  SchemeInput input{pslg, {}};
  if (!refines) input.goal.min_angle_deg = 0;
  return input;
}

}  // namespace

std::vector<std::string> scheme_inputs() { return {"square", "pipe", "key", "random", "clustered"}; }

Result<SchemeInput> scheme_input(std::string_view name, double triangles, bool refines) {
  const auto number = [&](double per_point) {
    return static_cast<std::uint64_t>(triangles / (refines ? per_point : 2));
  };
  if (name == "square") return SchemeInput{domains::square(), with_area(square_area, triangles)};
  if (name == "pipe") return SchemeInput{domains::pipe(), with_area(pipe_area, triangles)};
  if (name == "key") return graded_key(triangles);
  if (name == "random") return points(domains::random_points(number(per_random_point), seed), refines);
  if (name == "clustered") return points(domains::clustered_points(number(per_clustered_point), seed), refines);
  return Error{ErrorKind::usage, "There is no input \"" + std::string(name) + "\"."};
}

}  // namespace pardel::bench
