#include "decorations.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "../../../core/support/enum_names.hpp"

namespace pardel::generators {
namespace {

constexpr auto decoration_names = enum_names<Decoration>({
    {Decoration::own_markers, "own_markers"},
    {Decoration::negative_markers, "negative_markers"},
    {Decoration::huge_markers, "huge_markers"},
    {Decoration::segment_markers, "segment_markers"},
    {Decoration::one_attribute, "one_attribute"},
    {Decoration::three_attributes, "three_attributes"},
    {Decoration::region_attributes, "region_attributes"},
    {Decoration::numbers_from_one, "numbers_from_one"},
});
static_assert(decoration_names.size() == Decorations{}.on.size());

/// Gives data to the parts of one domain.
class Decorator {
 public:
  Decorator(Pslg& pslg, const Decorations& decorations) : pslg_(pslg), decorations_(decorations) {}

  void decorate() {
    mark_points();
    mark_segments();
    add_attributes();
    if (decorations_.has(Decoration::region_attributes))
      for (Region& region : pslg_.regions)
        region.attribute = random_at(region.seed).one_of<double>({0, -1, 0.5, 1e300});
    if (decorations_.has(Decoration::numbers_from_one)) pslg_.first_id = {1};
  }

 private:
  /// The random numbers of a place.
  [[nodiscard]] Random random_at(Point p) const {
    Random of_x(decorations_.seed ^ std::bit_cast<std::uint64_t>(p.x));
    return Random(of_x.next() ^ std::bit_cast<std::uint64_t>(p.y));
  }

  [[nodiscard]] bool has_unusual_markers() const {
    return decorations_.has(Decoration::negative_markers) || decorations_.has(Decoration::huge_markers);
  }
  /// One of the markers that are switched on, or the usual one.
  [[nodiscard]] int marker(Random& random, int usual) const {
    using Limits = std::numeric_limits<int>;
    if (decorations_.has(Decoration::negative_markers) && random.chance(3)) return -random.between(1, 3);
    if (decorations_.has(Decoration::huge_markers) && random.chance(4))
      return random.one_of<int>({Limits::min(), Limits::max()});
    return usual;
  }

  void mark_points() {
    if (!decorations_.has(Decoration::own_markers) && !has_unusual_markers()) return;
    pslg_.point_markers.resize(pslg_.points.size());
    for (std::size_t i = 0; i < pslg_.points.size(); ++i) {
      Random random = random_at(pslg_.points[i]);
      int& own = pslg_.point_markers[i];
      if (decorations_.has(Decoration::own_markers)) own = random.one_of<int>({0, 0, 0, 1, 2, 5});
      own = marker(random, own);
    }
  }

  void mark_segments() {
    if (!decorations_.has(Decoration::segment_markers) && !has_unusual_markers()) return;
    pslg_.has_segment_markers |= !pslg_.segments.empty();
    for (Segment& s : pslg_.segments) {
      const Point a = pslg_.points[s.a], b = pslg_.points[s.b];
      Random random = random_at({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2});
      if (decorations_.has(Decoration::segment_markers)) s.marker = random.between(0, 3);
      s.marker = marker(random, s.marker);
    }
  }

  void add_attributes() {
    const bool one = decorations_.has(Decoration::one_attribute),
               three = decorations_.has(Decoration::three_attributes);
    if (!one && !three) return;
    pslg_.attributes_per_point = (one ? 1 : 0) + (three ? 3 : 0);
    pslg_.point_attributes.clear();
    for (const Point p : pslg_.points) {
      Random random = random_at(p);
      if (one) pslg_.point_attributes.push_back(random.uniform(-1, 1));
      if (!three) continue;
      pslg_.point_attributes.push_back(random.chance(2) ? -0.0 : 1);
      pslg_.point_attributes.push_back(std::ldexp(random.uniform(-1, 1), random.between(-60, 60)));
      pslg_.point_attributes.push_back(random.uniform());
    }
  }

  Pslg& pslg_;
  const Decorations& decorations_;
};

}  // namespace

const char* name(Decoration decoration) { return decoration_names[decoration]; }

Pslg decorated(Pslg pslg, const Decorations& decorations) {
  Decorator(pslg, decorations).decorate();
  return pslg;
}

}  // namespace pardel::generators
