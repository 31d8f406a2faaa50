#include "size_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/distance.hpp"

namespace pardel::engine {
namespace {

/// Values that differ by rounding_margin only count as equal when sources are left out.
constexpr double rounding_margin = 0x1p-40;

}  // namespace

PreparedSize::PreparedSize(const GrowingSize& growing) : slope_(growing.slope) {
  SizeSource source = growing.source;
  // The direction of a source must not change its values, not even in the last bit.
  if (lexicographically_less(source.b, source.a)) {
    std::swap(source.a, source.b);
    std::swap(source.at_a, source.at_b);
  }
  a_ = source.a;
  length_ = source.at_a;
  const double extent = distance(source.a, source.b);
  if (!(extent > 0)) {
    length_ = std::min(source.at_a, source.at_b);
    return;
  }
  const double change = (source.at_b - source.at_a) / extent;
  if (std::abs(change) >= slope_) {
    // Lengths grow faster along the source than away from its shorter end, so this end alone counts.
    if (change < 0) a_ = source.b, length_ = source.at_b;
    return;
  }
  ux_ = (source.b.x - source.a.x) / extent;
  uy_ = (source.b.y - source.a.y) / extent;
  extent_ = extent;
  change_ = change;
  offset_ = change / std::sqrt((slope_ - change) * (slope_ + change));
}

double PreparedSize::at(Point p) const {
  const double dx = p.x - a_.x, dy = p.y - a_.y;
  const double along = dx * ux_ + dy * uy_;
  // From the ends of the source, no difference of large numbers is formed: a point has u = 0, so `beside` is not used.
  const double beside = std::abs(dy * ux_ - dx * uy_);
  const double best = std::clamp(along - offset_ * beside, 0.0, extent_);
  const double x = dx - best * ux_, y = dy - best * uy_;
  return length_ + change_ * best + slope_ * std::sqrt(x * x + y * y);
}

SizeEnvelope::SizeEnvelope(std::span<const GrowingSize> sources, const Box& box, const Threads& threads)
    : low_{box.min_x, box.min_y}, side_(box.extent()) {
  if (sources.empty()) return;
  sources_.reserve(sources.size());
  std::vector<Candidate> all;
  all.reserve(sources.size());
  for (const GrowingSize& source : sources) {
    all.push_back({0, static_cast<std::uint32_t>(sources_.size())});
    sources_.emplace_back(source);
  }
  // No value in the box exceeds the least length by more than the growth over twice the side.
  constexpr double slope_to_spare = 1.001, roundings = 64 * 0x1p-53;
  double least = INFINITY;
  for (const GrowingSize& source : sources) {
    steepness_.slope = std::max(steepness_.slope, slope_to_spare * source.slope);
    least = std::min({least, source.source.at_a, source.source.at_b});
  }
  steepness_.blur = roundings * (least + 4 * side_ * steepness_.slope);
  SparseAsk ask(threads.stop);
  nodes_.push_back({0, inner});
  const double half = side_ / 2;
  build(0, {low_.x + half, low_.y + half}, half, all, 0, ask);
}

/// Fills the node, whose square has this centre and half of a side, with the sources of `from` that can be the least.
void SizeEnvelope::build(std::uint32_t node, Point centre, double half, std::span<const Candidate> from, int depth,
                         SparseAsk& ask) {
  constexpr std::size_t few = 4;
  constexpr int deepest = 48;
  const double radius = half * std::numbers::sqrt2;
  std::vector<Candidate> kept;
  kept.reserve(from.size());
  double most = INFINITY;  // no least value in the node is more
  for (const Candidate& candidate : from) {
    ask();
    const PreparedSize& source = sources_[candidate.source];
    const double value = source.at(centre),
                 reach = source.slope() * radius * (1 + rounding_margin) + value * rounding_margin;
    most = std::min(most, value + reach);
    kept.push_back({value - reach, candidate.source});
  }
  std::erase_if(kept, [&](const Candidate& candidate) { return candidate.least > most; });
  // In a square much smaller than the wanted length there is hardly a triangle, so a long list does no harm.
  if (kept.size() <= few || depth == deepest || 4 * half <= most) {
    std::ranges::sort(kept, {}, [](const Candidate& candidate) { return candidate.least; });
    nodes_[node] = {static_cast<std::uint32_t>(candidates_.size()), static_cast<std::uint32_t>(kept.size())};
    candidates_.insert(candidates_.end(), kept.begin(), kept.end());
    return;
  }
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node] = {children, inner};
  nodes_.resize(nodes_.size() + 4);
  const double quarter = half / 2;
  for (std::uint32_t i = 0; i < 4; ++i)
    build(children + i, {centre.x + (i % 2 == 0 ? -quarter : quarter), centre.y + (i < 2 ? -quarter : quarter)},
          quarter, kept, depth + 1, ask);
}

double SizeEnvelope::at(Point p) const {
  double best = INFINITY;
  if (sources_.empty()) return best;
  const bool covered = p.x >= low_.x && p.y >= low_.y && p.x <= low_.x + side_ && p.y <= low_.y + side_;
  if (!covered) {
    for (const PreparedSize& source : sources_) best = std::min(best, source.at(p));
    return best;
  }
  double half = side_ / 2;
  Point centre{low_.x + half, low_.y + half};
  const Node* node = nodes_.data();
  while (node->count == inner) {
    half /= 2;
    const bool right = p.x >= centre.x, top = p.y >= centre.y;
    node = &nodes_[node->first + (right ? 1 : 0) + (top ? 2 : 0)];
    centre = {centre.x + (right ? half : -half), centre.y + (top ? half : -half)};
  }
  const Candidate* candidate = candidates_.data() + node->first;
  for (const Candidate* const end = candidate + node->count; candidate < end && candidate->least <= best; ++candidate)
    best = std::min(best, sources_[candidate->source].at(p));
  return best;
}

}  // namespace pardel::engine
