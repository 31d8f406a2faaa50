#include "rounds.hpp"

#include <algorithm>

#include "../triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

/// The factor of the radii from one round to the next. Without it, a place that comes again would be cleared in vain.
constexpr double growth = 1.01;
/// Rounds without a new minimum, after which edges become shorter. A few stuck places come and go by chance.
constexpr std::size_t few = 16;
constexpr std::uint32_t most_idle = 4, most_idle_with_few = 6;
constexpr std::uint32_t most_rounds = 64;
/// A refinement without patches would make about 0.8 vertices for each laid triangle, and a vertex takes several times
/// as long in a round. So the rounds may make so many vertices for each laid triangle, and some thousands more.
constexpr double most_vertices_per_laid = 1.5, more_vertices = 300'000;

}  // namespace

bool Rounds::go_on(const Triangulation& t, std::span<const TriangleId> stuck, std::uint64_t laid) {
  vertices_ += t.points.size();
  const double allowed = most_vertices_per_laid * static_cast<double>(laid) + more_vertices;
  if (++failed_ == most_rounds || static_cast<double>(vertices_) > allowed) return false;
  idle_ = stuck.size() < fewest_ ? 0 : idle_ + 1;
  fewest_ = std::min(fewest_, stuck.size());
  const std::uint32_t patience = fewest_ <= few ? most_idle_with_few : most_idle;
  if (idle_ < patience)
    clear(t, stuck);
  else
    shorten_edges();
  return true;
}

void Rounds::clear(const Triangulation& t, std::span<const TriangleId> stuck) {
  for (const TriangleId id : stuck) {
    const std::size_t region = t.region.empty() ? no_index : t.region[id];
    const double edge = edges_[std::min(region, edges_.size() - 1)];
    clearings_.push_back({Shape(t, t.slots[id]).centroid(), radius_ * edge});
  }
  radius_ *= growth;
}

void Rounds::shorten_edges() {
  for (double& edge : edges_) edge *= shortening_;
  shortening_ *= shortening_;
  clearings_.clear();
  radius_ = first_radius;
  idle_ = 0;
  fewest_ = SIZE_MAX;
}

}  // namespace pardel::engine
