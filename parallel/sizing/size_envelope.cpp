#include "size_envelope.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/distance.hpp"
#include "../decomposition/hilbert_order.hpp"

namespace pardel::engine {

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

void SizeEnvelope::Node::cover(const Node& other) {
  box.cover(other.box);
  least = std::min(least, other.least);
  slope = std::min(slope, other.slope);
}

SizeEnvelope::SizeEnvelope(std::span<const GrowingSize> sources, const Box& box, const Threads& threads) {
  if (sources.empty()) return;
  std::vector<Point> places;
  for (const GrowingSize& source : sources) places.push_back(source.source.a);
  const Array<Index> order = hilbert_order(places, threads);
  leaves_ = std::bit_ceil((sources.size() + sources_per_leaf - 1) / sources_per_leaf);
  nodes_.resize(2 * leaves_);
  sources_.reserve(sources.size());
  // No value in the box exceeds the least length by more than the growth over twice the side.
  constexpr double slope_to_spare = 1.001, roundings = 64 * 0x1p-53;
  for (const Index i : order) {
    const auto& [source, slope] = sources[i];
    const double least = std::min(source.at_a, source.at_b);
    nodes_[leaves_ + sources_.size() / sources_per_leaf].cover({Box::around(source.a, source.b), least, slope});
    sources_.emplace_back(sources[i]);
    steepness_.slope = std::max(steepness_.slope, slope_to_spare * slope);
  }
  for (std::size_t node = leaves_; node-- > 1;) {
    nodes_[node].cover(nodes_[2 * node]);
    nodes_[node].cover(nodes_[2 * node + 1]);
  }
  steepness_.blur = roundings * (nodes_[1].least + 4 * box.extent() * steepness_.slope);
}

void SizeEnvelope::search_leaf(std::size_t leaf, Point p, double& best, Index& found) const {
  const std::size_t end = std::min(sources_.size(), (leaf + 1) * sources_per_leaf);
  for (std::size_t i = leaf * sources_per_leaf; i < end; ++i)
    if (const double length = sources_[i].at(p); length < best) {
      best = length;
      found = static_cast<Index>(i);
    }
}

/// Searches a part of the sources, nearer parts first. In another order, each of many sources on the way to p may be
/// less than those before it.
void SizeEnvelope::search(std::size_t node, Point p, double& best, Index& found) const {
  struct Waiting {
    std::size_t node;
    double squared_distance;
  };
  std::array<Waiting, 64> waiting;  // each level of the tree leaves one part behind
  std::size_t count = 0;
  for (;;) {
    while (node < leaves_) {
      Waiting near{2 * node, nodes_[2 * node].squared_distance(p)},
          far{2 * node + 1, nodes_[2 * node + 1].squared_distance(p)};
      if (far.squared_distance < near.squared_distance) std::swap(near, far);
      waiting[count++] = far;
      node = near.node;
      if (!nodes_[node].may_be_less(near.squared_distance, best)) break;
    }
    if (node >= leaves_) search_leaf(node - leaves_, p, best, found);
    do {
      if (count == 0) return;
      node = waiting[--count].node;
    } while (!nodes_[node].may_be_less(waiting[count].squared_distance, best));
  }
}

double SizeEnvelope::at(Point p, Index& hint) const {
  if (sources_.empty()) return INFINITY;
  if (hint >= sources_.size()) hint = 0;
  double best = INFINITY;
  std::size_t node = leaves_ + hint / sources_per_leaf;
  search_leaf(node - leaves_, p, best, hint);
  // The other parts, from the nearest ones to the hint to the largest ones.
  for (; node > 1; node /= 2)
    if (const std::size_t sibling = node ^ 1U; nodes_[sibling].may_be_less(p, best)) search(sibling, p, best, hint);
  return best;
}

}  // namespace pardel::engine
