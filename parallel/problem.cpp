#include "problem.hpp"

#include "../core/support/enum_names.hpp"
#include "../core/support/shortest.hpp"
#include "arithmetic/predicates.hpp"

namespace pardel {

using namespace engine;

namespace {

constexpr auto kind_names = enum_names<ProblemKind>({
    {ProblemKind::non_finite_coordinate, "non_finite_coordinate"},
    {ProblemKind::coordinate_out_of_range, "coordinate_out_of_range"},
    {ProblemKind::wrong_count, "wrong_count"},
    {ProblemKind::index_out_of_range, "index_out_of_range"},
    {ProblemKind::duplicate_points, "duplicate_points"},
    {ProblemKind::zero_length_segment, "zero_length_segment"},
    {ProblemKind::duplicate_segments, "duplicate_segments"},
    {ProblemKind::crossing_segments, "crossing_segments"},
    {ProblemKind::overlapping_segments, "overlapping_segments"},
    {ProblemKind::point_on_segment, "point_on_segment"},
    {ProblemKind::all_points_collinear, "all_points_collinear"},
    {ProblemKind::unclosed_outline, "unclosed_outline"},
    {ProblemKind::no_domain, "no_domain"},
    {ProblemKind::hole_outside, "hole_outside"},
    {ProblemKind::hole_on_segment, "hole_on_segment"},
    {ProblemKind::region_outside, "region_outside"},
    {ProblemKind::region_on_segment, "region_on_segment"},
    {ProblemKind::regions_share_face, "regions_share_face"},
    {ProblemKind::bad_region_cap, "bad_region_cap"},
    {ProblemKind::cancelled, "cancelled"},
});

std::string text(Point p) { return "(" + shortest(p.x) + ", " + shortest(p.y) + ")"; }

enum class Thing : std::uint8_t { point, segment, other };

/// What the id at a place in Problem::ids is the index of.
Thing thing(ProblemKind kind, std::size_t place) {
  switch (kind) {
    case ProblemKind::non_finite_coordinate:
    case ProblemKind::coordinate_out_of_range:
    case ProblemKind::duplicate_points:
      return Thing::point;
    case ProblemKind::index_out_of_range:
    case ProblemKind::zero_length_segment:
    case ProblemKind::duplicate_segments:
    case ProblemKind::crossing_segments:
    case ProblemKind::overlapping_segments:
      return Thing::segment;
    case ProblemKind::point_on_segment:
      return place == 0 ? Thing::point : Thing::segment;
    case ProblemKind::hole_on_segment:
    case ProblemKind::region_on_segment:
      return place == 0 ? Thing::other : Thing::segment;
    default:
      return Thing::other;
  }
}

std::uint64_t number(Index id, const NumbersInMessages& numbers, bool is_point) {
  if (is_point && id < numbers.points.size()) return numbers.points[id];
  return std::uint64_t{id} + static_cast<unsigned>(numbers.base);
}

/// The number of the thing, or those of the ends of a segment that has none.
std::vector<std::uint64_t> numbers_at(const Problem& problem, std::size_t place, const NumbersInMessages& numbers) {
  const Index id = problem.ids[place];
  const Thing what = thing(problem.kind, place);
  if (what != Thing::segment || id >= numbers.unnumbered.size()) return {number(id, numbers, what == Thing::point)};
  const Segment& segment = numbers.unnumbered[id];
  return {number(segment.a, numbers, true), number(segment.b, numbers, true)};
}

/// The number at a place, or "3-7" for a segment without a number; nothing if there is no such place.
std::string one(const Problem& problem, std::size_t place, const NumbersInMessages& numbers) {
  if (place >= problem.ids.size()) return {};
  const std::vector<std::uint64_t> found = numbers_at(problem, place, numbers);
  return std::to_string(found[0]) + (found.size() > 1 ? "-" + std::to_string(found[1]) : "");
}

/// All of them as text: "3, 5, 8", "3 and 5" or "3". If there are more than eight, only the first eight.
std::string list(const Problem& problem, const NumbersInMessages& numbers) {
  constexpr std::size_t most = 8;
  const std::size_t n = problem.ids.size();
  std::string result;
  for (std::size_t i = 0; i < n && i < most; ++i)
    result += (i == 0 ? "" : n == 2 ? " and " : ", ") + one(problem, i, numbers);
  return n > most ? result + ", ..." : result;
}

/// The message for a hole or a region that is in no face. If its coordinates are usable, the reason is `otherwise`.
std::string outside(const std::string& what, Point where, const char* otherwise) {
  return what + (is_usable(where) ? otherwise : " has a coordinate outside the range that exact arithmetic can use.");
}

}  // namespace

const char* name(ProblemKind kind) { return kind_names[kind]; }

std::string Problem::message(int base) const { return message(NumbersInMessages{.base = base}); }

std::vector<std::uint64_t> Problem::numbers_of_ids(const NumbersInMessages& numbers) const {
  std::vector<std::uint64_t> all;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::vector<std::uint64_t> found = numbers_at(*this, i, numbers);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

std::string Problem::message(const NumbersInMessages& numbers) const {
  const std::string id = list(*this, numbers), at = text(where);
  const auto one = [&](std::size_t place) { return pardel::one(*this, place, numbers); };
  switch (kind) {
    case ProblemKind::non_finite_coordinate:
      return "Point " + id + " at " + at + " has a coordinate that is not a finite number.";
    case ProblemKind::coordinate_out_of_range:
      return "Point " + id + " at " + at +
             " has a coordinate outside the range that exact arithmetic can use: zero, or between " +
             shortest(smallest_coordinate) + " and " + shortest(largest_coordinate) + " in magnitude.";
    case ProblemKind::wrong_count:
      return "There is not one row of attributes, or not one marker, per point.";
    case ProblemKind::index_out_of_range:
      return "Segment " + id + " names a point that does not exist.";
    case ProblemKind::duplicate_points:
      return "Points " + id + " are both at " + at + ".";
    case ProblemKind::zero_length_segment:
      return "Segment " + id + " at " + at + " has no length.";
    case ProblemKind::duplicate_segments:
      return "Segments " + id + ", from " + at + ", have the same ends.";
    case ProblemKind::crossing_segments:
      return "Segments " + id + " cross at " + at + ".";
    case ProblemKind::overlapping_segments:
      return "Segments " + id + " overlap from " + at + " on.";
    case ProblemKind::point_on_segment:
      return "Point " + one(0) + " at " + at + " lies in the interior of segment " + one(1) + ".";
    case ProblemKind::all_points_collinear:
      return "There are no three points that make a triangle: all lie on one line.";
    case ProblemKind::unclosed_outline:
      return "No outline is closed: the segments, the first of them at " + at + ", enclose nothing.";
    case ProblemKind::no_domain:
      return "Nothing is left to mesh: every face contains a hole (" + id + "), the first at " + at + ".";
    case ProblemKind::hole_outside:
      return outside("Hole " + id + " at " + at, where, " lies outside every closed outline.");
    case ProblemKind::hole_on_segment:
      return "Hole " + one(0) + " at " + at + " lies on " +
             (ids.size() > 1 ? "segment " + one(1) : std::string("the convex hull")) + ".";
    case ProblemKind::region_outside:
      return outside("Region " + id + " at " + at, where, " lies outside the domain.");
    case ProblemKind::region_on_segment:
      return "Region " + one(0) + " at " + at + " lies on " +
             (ids.size() > 1 ? "segment " + one(1) : std::string("the convex hull")) + ".";
    case ProblemKind::regions_share_face:
      return "Regions " + id + " lie in one face, the second at " + at + ".";
    case ProblemKind::bad_region_cap:
      return "Region " + id + " at " + at + " has an area cap that is not a positive number.";
    case ProblemKind::cancelled:
      return "The caller asked to stop the search for problems.";
  }
  return name(kind);
}

std::string messages(const std::vector<Problem>& problems, int base) {
  return messages(problems, NumbersInMessages{.base = base});
}

std::string messages(const std::vector<Problem>& problems, const NumbersInMessages& numbers) {
  std::string lines;
  for (const Problem& problem : problems) lines += (lines.empty() ? "" : "\n") + problem.message(numbers);
  return lines;
}

}  // namespace pardel
