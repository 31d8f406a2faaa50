#include "mixed_scales.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "../../../core/support/enum_names.hpp"

namespace pardel::generators {
namespace {

constexpr auto mixture_names = enum_names<Mixture>({
    {Mixture::far_points_outside, "far_points_outside"},
    {Mixture::far_points_inside, "far_points_inside"},
    {Mixture::far_points_of_hull, "far_points_of_hull"},
    {Mixture::component_beside, "component_beside"},
    {Mixture::component_in_hole, "component_in_hole"},
    {Mixture::component_in_face, "component_in_face"},
    {Mixture::component_far_off, "component_far_off"},
    {Mixture::tiny_feature, "tiny_feature"},
});

/// Exponents of the largest coordinates that are drawn, and of the lowest bits of coordinates: those of features that
/// are far larger than the shortest edge of the mesher (2^-129), and the lowest that is usable.
constexpr int largest_power = 198, usual_lowest_bit = -110, lowest_usable_bit = -139;
/// Components and features are smaller by up to this power of two.
constexpr int deepest = 60;

/// Calls visit(point) with each place of the domain.
template <class AnyPslg, class Visit>
void for_each_place(AnyPslg& pslg, const Visit& visit) {
  for (auto& p : pslg.points) visit(p);
  for (auto& p : pslg.holes) visit(p);
  for (auto& region : pslg.regions) visit(region.seed);
}

/// The exponent of the lowest bit of a number that is not 0.
int lowest_bit(double x) {
  int exponent = 0;
  const auto digits = static_cast<std::uint64_t>(std::ldexp(std::abs(std::frexp(x, &exponent)), 53));
  return exponent - 53 + std::countr_zero(digits);
}

/// The lowest of all coordinates.
int lowest_bit(const Pslg& pslg) {
  int lowest = std::numeric_limits<int>::max();
  for_each_place(pslg, [&](Point p) {
    for (const double x : {p.x, p.y})
      if (x != 0) lowest = std::min(lowest, lowest_bit(x));
  });
  return lowest;
}

/// The least e for which 2^e is larger than x. Precondition: x > 0.
int power_above(double x) { return std::ilogb(x) + 1; }

double largest_magnitude(const Pslg& pslg) {
  double largest = 0;
  for_each_place(pslg, [&](Point p) { largest = std::max({largest, std::abs(p.x), std::abs(p.y)}); });
  return largest;
}

/// The bounding box of the points.
struct Bounds {
  explicit Bounds(const Pslg& pslg) {
    const auto [left, right] = std::ranges::minmax(pslg.points, {}, &Point::x);
    const auto [below, above] = std::ranges::minmax(pslg.points, {}, &Point::y);
    low = {left.x, below.y};
    extent = std::max(right.x - left.x, above.y - below.y);
  }
  Point low;
  double extent;  ///< the longer side
};

/// x + by, if that is not rounded.
std::optional<double> exact_sum(double x, double by) {
  const double sum = x + by;
  const double of_by = sum - x, of_x = sum - of_by;
  if (of_by != by || of_x != x) return {};
  return sum;
}

/// The domain, moved without rounding; nothing if that is not possible.
std::optional<Pslg> moved(Pslg pslg, Point by) {
  bool is_exact = true;
  for_each_place(pslg, [&](Point& p) {
    const std::optional<double> x = exact_sum(p.x, by.x), y = exact_sum(p.y, by.y);
    is_exact = is_exact && x && y;
    p = {x.value_or(0), y.value_or(0)};
  });
  if (!is_exact) return {};
  return pslg;
}

/// With its lower left corner at the origin.
std::optional<Pslg> at_origin(const Pslg& pslg) {
  const Point low = Bounds(pslg).low;
  return moved(pslg, {-low.x, -low.y});
}

/// Multiplied by 2^power.
Pslg scaled(Pslg pslg, int power) {
  for_each_place(pslg, [&](Point& p) { p = {std::ldexp(p.x, power), std::ldexp(p.y, power)}; });
  for (Region& region : pslg.regions) region.max_area = std::ldexp(region.max_area, 2 * power);
  return pslg;
}

bool is_usable(const Pslg& pslg) {
  return largest_magnitude(pslg) <= 0x1p200 && lowest_bit(pslg) >= lowest_usable_bit - 1;
}

/// Fills up attributes and markers of added points.
void complete(Pslg& pslg) {
  pslg.point_attributes.resize(pslg.points.size() * pslg.attributes_per_point);
  if (!pslg.point_markers.empty()) pslg.point_markers.resize(pslg.points.size());
}

/// The domain with the kinds of data of the points of another one: with as many attributes, which are 0 where it has
/// fewer, and with markers only if the other one has some.
Pslg with_kinds_of(const Pslg& other, const Pslg& domain) {
  Pslg result = domain;
  result.attributes_per_point = other.attributes_per_point;
  result.point_attributes.clear();
  for (std::size_t i = 0; i < domain.points.size(); ++i)
    for (std::size_t a = 0; a < other.attributes_per_point; ++a)
      result.point_attributes.push_back(
          a < domain.attributes_per_point ? domain.point_attributes[i * domain.attributes_per_point + a] : 0);
  result.point_markers.resize(other.point_markers.empty() ? 0 : domain.points.size());
  return result;
}

/// Both domains in one. Precondition: the second one has the same kinds of data of points, or none.
Pslg united(Pslg pslg, const Pslg& added) {
  const auto first = static_cast<Index>(pslg.points.size());
  pslg.points.insert(pslg.points.end(), added.points.begin(), added.points.end());
  pslg.point_attributes.insert(pslg.point_attributes.end(), added.point_attributes.begin(),
                               added.point_attributes.end());
  pslg.point_markers.insert(pslg.point_markers.end(), added.point_markers.begin(), added.point_markers.end());
  for (const Segment& s : added.segments) pslg.segments.push_back({first + s.a, first + s.b, s.marker});
  pslg.has_segment_markers |= added.has_segment_markers;
  pslg.holes.insert(pslg.holes.end(), added.holes.begin(), added.holes.end());
  pslg.regions.insert(pslg.regions.end(), added.regions.begin(), added.regions.end());
  complete(pslg);
  return pslg;
}

Pslg with_points(Pslg pslg, const std::vector<Point>& points) {
  pslg.points.insert(pslg.points.end(), points.begin(), points.end());
  complete(pslg);
  return pslg;
}

/// The distance of the origin from a segment, rounded.
double distance_of_origin(Point a, Point b) {
  const double x = b.x - a.x, y = b.y - a.y;
  const double at = std::clamp(-(a.x * x + a.y * y) / (x * x + y * y), 0.0, 1.0);
  return std::hypot(a.x + at * x, a.y + at * y);
}

/// The distance of the origin from all parts of a domain that are not at the origin, rounded.
double room_at_origin(const Pslg& pslg) {
  double room = std::numeric_limits<double>::infinity();
  for_each_place(pslg, [&](Point p) {
    if (p != Point{}) room = std::min(room, std::hypot(p.x, p.y));
  });
  for (const Segment& s : pslg.segments) room = std::min(room, distance_of_origin(pslg.points[s.a], pslg.points[s.b]));
  return room;
}

/// True if a point or a seed lies at the origin.
bool has_place_at_origin(const Pslg& pslg) {
  bool has = false;
  for_each_place(pslg, [&](Point p) { has = has || p == Point{}; });
  return has;
}

class Mixer {
 public:
  Mixer(const Pslg& domain, const Pslg& other, Random& random, bool allows_tiny)
      : domain_(domain),
        other_(other),
        random_(random),
        lowest_(allows_tiny ? lowest_usable_bit : usual_lowest_bit),
        extent_(Bounds(domain).extent) {}

  std::optional<Mixed> mixed(Mixture mixture) {
    std::optional<Mixed> mixed = attempt(mixture);
    if (!mixed || !is_usable(mixed->pslg) || !std::ranges::all_of(mixed->parts, is_usable)) return {};
    mixed->what = {mixture};
    mixed->is_tiny = lowest_bit(mixed->pslg) < usual_lowest_bit;
    return mixed;
  }

  /// Adds far points outside of a domain with segments, if there is room for them.
  void add_far_points(Mixed& mixed) {
    if (!has_room_around(mixed.pslg)) return;
    mixed.pslg = with_points(mixed.pslg, far_points(largest_magnitude(mixed.pslg)));
    mixed.what.push_back(Mixture::far_points_outside);
  }

 private:
  std::optional<Mixed> attempt(Mixture mixture) {
    const bool has_segments = !domain_.segments.empty(), has_component = !other_.segments.empty() && has_segments;
    switch (mixture) {
      case Mixture::far_points_outside:
        if (has_segments && has_room_around(domain_))
          return Mixed{with_points(domain_, far_points(largest_magnitude(domain_))), {}, {domain_}};
        return {};
      case Mixture::far_points_inside:
        return has_segments ? in_outline() : std::nullopt;
      case Mixture::far_points_of_hull:
        return has_segments ? std::nullopt : stretched_hull();
      case Mixture::component_beside:
        return has_component ? beside() : std::nullopt;
      case Mixture::component_in_hole:
        return has_component ? in_hole() : std::nullopt;
      case Mixture::component_in_face:
        return has_component ? in_room(at_origin(other_), true) : std::nullopt;
      case Mixture::component_far_off:
        return has_component ? far_off() : std::nullopt;
      case Mixture::tiny_feature:
        return in_room(feature(), false);
    }
    return {};
  }

  static constexpr int farther = 10;  ///< far points are at least 2^10 times as far away as the domain reaches
  static bool has_room_around(const Pslg& pslg) {
    return power_above(largest_magnitude(pslg)) + farther <= largest_power;
  }
  /// One to three points. At least one coordinate of each is far larger than `magnitude`. Precondition: there is room.
  std::vector<Point> far_points(double magnitude) {
    const int least = power_above(magnitude) + farther;
    std::vector<Point> points;
    for (int left = random_.between(1, 3); left > 0; --left) {
      const double far = far_coordinate(least);
      const Point near = random_.one_of(domain_.points);
      Point p{far, random_.one_of<double>({0, near.y, far, far_coordinate(least)})};
      if (random_.chance(2)) std::swap(p.x, p.y);
      if (std::ranges::find(points, p) == points.end()) points.push_back(p);
    }
    return points;
  }
  double far_coordinate(int least) {
    const int most = random_.chance(3) ? largest_power : std::min(least + 40, largest_power);
    const double x = std::ldexp(random_.between(4, 7), random_.between(least, most) - 2);
    return random_.chance(2) ? x : -x;
  }

  /// A huge square around the domain, and points without segments in it.
  std::optional<Mixed> in_outline() {
    const int least = power_above(largest_magnitude(domain_)) + 4;
    const int power = random_.between(least, std::min(largest_power, least + (random_.chance(4) ? 200 : 60)));
    Mixed mixed{with_square(power), {}, {with_square(least)}};
    mixed.enlarges = true;
    std::vector<Point> points;
    for (int left = random_.between(0, 3); left > 0 && power > least; --left) {
      // Between a quarter and a half of a square that is at least as large as the least one.
      const int within = random_.between(least, power);
      const auto coordinate = [&] {
        return std::ldexp(random_.between(4, 7) * (random_.chance(2) ? 1 : -1), within - 4);
      };
      const double x = coordinate();
      const Point p{x, random_.chance(3) ? 0 : coordinate()};
      if (std::ranges::find(points, p) == points.end()) points.push_back(p);
    }
    mixed.pslg = with_points(mixed.pslg, points);
    return mixed;
  }
  [[nodiscard]] Pslg with_square(int power) const {
    const double s = std::ldexp(1, power);
    Pslg square;
    square.points = {{-s, -s}, {s, -s}, {s, s}, {-s, s}};
    square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    return united(domain_, square);
  }

  /// Far points all around, which become the corners of the hull.
  std::optional<Mixed> stretched_hull() {
    const int least = power_above(largest_magnitude(domain_)) + 4;
    const int power = random_.between(least, std::min(largest_power, least + 60));
    const auto far = [](int e) {
      const double s = std::ldexp(1, e - 3);
      return std::vector<Point>{{-5 * s, -4 * s}, {6 * s, -5 * s}, {s, 7 * s}};
    };
    // The only face is the hull.
    Pslg uncapped = domain_;
    for (Region& region : uncapped.regions) region.max_area = std::numeric_limits<double>::infinity();
    Mixed mixed{with_points(uncapped, far(power)), {}, {with_points(uncapped, far(least))}};
    mixed.enlarges = true;
    return mixed;
  }

  /// The largest power of two by which the part, which lies around the origin, fits into a quarter of the room.
  static int fitting_power(const Pslg& part, double room) {
    return power_above(room) - 3 - power_above(largest_magnitude(part));
  }
  /// A smaller power, down to the deepest one.
  int power_below(const Pslg& part, int fitting) {
    const int least = std::max(fitting - deepest, lowest_ - lowest_bit(part));
    return least >= fitting ? fitting : random_.between(least, fitting);
  }

  /// The domain, with the origin beside it, and there the other one.
  std::optional<Mixed> beside() {
    const Bounds bounds(domain_);
    const double gap = std::ldexp(1, power_above(extent_) - random_.between(0, 3));
    const std::optional<Pslg> place = moved(domain_, {gap - bounds.low.x, gap - bounds.low.y}),
                              part = at_origin(other_);
    // Seeds of holes may lie outside.
    if (!place || !part || has_place_at_origin(*place)) return {};
    return with_component(*place, *part, std::min(gap, room_at_origin(*place)));
  }

  /// The other one in a hole. The seed of the hole moves aside.
  std::optional<Mixed> in_hole() {
    if (domain_.holes.empty()) return {};
    const std::size_t hole = random_.below(domain_.holes.size());
    const Point seed = domain_.holes[hole];
    Pslg without = domain_;
    without.holes.erase(without.holes.begin() + static_cast<std::ptrdiff_t>(hole));
    std::optional<Pslg> place = moved(without, {-seed.x, -seed.y});
    const std::optional<Pslg> part = at_origin(other_);
    if (!place || !part || has_place_at_origin(*place)) return {};
    const double room = std::ldexp(1, std::ilogb(room_at_origin(*place)));
    place->holes.push_back({room / 2, 0});
    return with_component(*place, *part, room / 2);
  }

  /// The part, scaled, at the origin, where there is room. Nothing of the domain reaches into its faces.
  std::optional<Mixed> with_component(const Pslg& place, const Pslg& part, double room) {
    const int power = power_below(part, fitting_power(part, room));
    Mixed mixed{united(place, scaled(part, power)), {}, {place, scaled(part, power)}};
    enlarge(mixed, power);
    return mixed;
  }

  /// Scales everything so that the part has its own scale, in one of two cases.
  void enlarge(Mixed& mixed, int power) {
    if (power >= 0 || !random_.chance(2)) return;
    mixed.pslg = scaled(std::move(mixed.pslg), -power);
    for (Pslg& each : mixed.parts) each = scaled(std::move(each), -power);
    mixed.enlarges = true;
  }

  /// The part, scaled, at a place of the domain around which there is room; this place becomes the origin.
  std::optional<Mixed> in_room(const std::optional<Pslg>& part, bool may_enlarge) {
    if (!part) return {};
    const std::optional<Point> where = place_with_room();
    if (!where) return {};
    const std::optional<Pslg> place = moved(domain_, {-where->x, -where->y});
    if (!place) return {};
    const int fitting = fitting_power(*part, room_at_origin(*place));
    const int power = power_below(*part, fitting);
    Mixed mixed{united(*place, scaled(*part, power)), {}, {united(*place, scaled(*part, fitting))}};
    if (may_enlarge)
      enlarge(mixed, power);
    else
      move_back(mixed, *where);
    return mixed;
  }

  /// Moves the domain back to its own place, in one of two cases, if coordinates still resolve the feature.
  void move_back(Mixed& mixed, Point to) {
    if (!random_.chance(2)) return;
    std::optional<Pslg> back = moved(mixed.pslg, to);
    if (!back || lowest_bit(mixed.pslg) < power_above(largest_magnitude(*back)) - 34) return;
    mixed.pslg = std::move(*back);
  }

  /// The roomiest of some places; nothing if there is little room around each of them.
  std::optional<Point> place_with_room() {
    const double step = std::ldexp(1, power_above(extent_) - 4);
    double most = step / 8;
    std::optional<Point> best;
    for (int i = 0; i < 24; ++i) {
      const Point from = random_.one_of(domain_.points);
      const Point p{from.x + random_.between(-8, 8) * step, from.y + random_.between(-8, 8) * step};
      const std::optional<Pslg> around = moved(domain_, {-p.x, -p.y});
      if (!around || has_place_at_origin(*around)) continue;
      const double room = room_at_origin(*around);
      if (!(room > most)) continue;
      most = room;
      best = p;
    }
    return best;
  }

  /// Around the origin, in small whole numbers.
  Pslg feature() {
    Pslg part;
    switch (domain_.segments.empty() ? 0 : random_.below(4)) {
      case 0:
        part.points = {{0, 0}, {1, 0}};
        break;
      case 1:
        part.points = {{-3, 1}, {4, 2}};
        part.segments = {{0, 1}};
        break;
      case 2:
        part.points = {{0, 0}, {5, 1}, {2, 4}};
        part.segments = {{0, 1}, {1, 2}, {2, 0}};
        break;
      default:
        part.points = {{-1, -1}, {2, -1}, {2, 1}, {-1, 1}};
        part.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    }
    return part;
  }

  /// Both domains, one of them near the origin, the other one as far off as its features allow.
  std::optional<Mixed> far_off() {
    const std::optional<Pslg> near = at_origin(domain_), part = at_origin(other_);
    if (!near || !part) return {};
    const int above = power_above(std::max(largest_magnitude(*near), largest_magnitude(*part)));
    const int most = std::min(lowest_bit(*part) + 34, largest_power);
    if (most < above + 3) return {};
    const double far = std::ldexp(1, random_.between(above + 3, most));
    const std::optional<Pslg> moved_part = moved(*part, {far, random_.chance(2) ? far : 0});
    if (!moved_part) return {};
    Mixed mixed{united(*near, *moved_part), {}, {*near, *moved_part}};
    mixed.enlarges = Bounds(*part).extent > extent_;
    return mixed;
  }

  const Pslg& domain_;
  const Pslg& other_;
  Random& random_;
  int lowest_;
  double extent_;
};

Mixed unchanged(const Pslg& domain) { return {domain, {}, {domain}}; }

}  // namespace

const std::vector<Mixture>& all_mixtures() {
  static const std::vector<Mixture> mixtures = [] {
    std::vector<Mixture> all;
    for (std::size_t i = 0; i < mixture_names.size(); ++i) all.push_back(static_cast<Mixture>(i));
    return all;
  }();
  return mixtures;
}

const char* name(Mixture mixture) { return mixture_names[mixture]; }

Mixed mixed_scales(const Pslg& domain, const Pslg& other, Random& random, bool allows_tiny,
                   const std::vector<Mixture>& mixtures) {
  const Pslg alike = with_kinds_of(domain, other);
  Mixer mixer(domain, alike, random, allows_tiny);
  std::vector<Mixture> order = mixtures;
  random.shuffle(order);
  const bool may_add_far_points =
      !domain.segments.empty() && std::ranges::find(mixtures, Mixture::far_points_outside) != mixtures.end();
  for (const Mixture mixture : order)
    if (std::optional<Mixed> mixed = mixer.mixed(mixture)) {
      if (mixture != Mixture::far_points_outside && may_add_far_points && random.chance(4))
        mixer.add_far_points(*mixed);
      return *mixed;
    }
  return unchanged(domain);
}

}  // namespace pardel::generators
