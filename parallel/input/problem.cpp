// What a problem is called, and the sentence that tells it.
#include "../../core/shortest.hpp"
#include "../arithmetic/predicates.hpp"
#include "../validate.hpp"

namespace pardel {

using namespace engine;

namespace {

std::string text(Point p) { return "(" + shortest(p.x) + ", " + shortest(p.y) + ")"; }

/// "3, 5, 8", "3 and 5", "3"; long lists are cut.
std::string list(const std::vector<Index>& ids, int base) {
  constexpr std::size_t most = 8;
  std::string result;
  for (std::size_t i = 0; i < ids.size() && i < most; ++i) {
    if (i > 0) result += ids.size() == 2 ? " and " : ", ";
    result += std::to_string(static_cast<long long>(ids[i]) + base);
  }
  return ids.size() > most ? result + ", ..." : result;
}

/// Of a hole or a region in no face: the reason, where it is the coordinates.
std::string outside(const std::string& what, Point where, const char* otherwise) {
  return what + (is_usable(where) ? otherwise : " has a coordinate outside the range that exact arithmetic can use.");
}

}  // namespace

const char* name(ProblemKind kind) {
  switch (kind) {
    case ProblemKind::non_finite_coordinate:
      return "non_finite_coordinate";
    case ProblemKind::coordinate_out_of_range:
      return "coordinate_out_of_range";
    case ProblemKind::wrong_count:
      return "wrong_count";
    case ProblemKind::index_out_of_range:
      return "index_out_of_range";
    case ProblemKind::duplicate_points:
      return "duplicate_points";
    case ProblemKind::zero_length_segment:
      return "zero_length_segment";
    case ProblemKind::duplicate_segments:
      return "duplicate_segments";
    case ProblemKind::crossing_segments:
      return "crossing_segments";
    case ProblemKind::overlapping_segments:
      return "overlapping_segments";
    case ProblemKind::point_on_segment:
      return "point_on_segment";
    case ProblemKind::all_points_collinear:
      return "all_points_collinear";
    case ProblemKind::unclosed_outline:
      return "unclosed_outline";
    case ProblemKind::no_domain:
      return "no_domain";
    case ProblemKind::hole_outside:
      return "hole_outside";
    case ProblemKind::hole_on_segment:
      return "hole_on_segment";
    case ProblemKind::region_outside:
      return "region_outside";
    case ProblemKind::region_on_segment:
      return "region_on_segment";
    case ProblemKind::regions_share_face:
      return "regions_share_face";
    case ProblemKind::bad_region_cap:
      return "bad_region_cap";
  }
  return "unknown";
}

std::string Problem::message(int base) const {
  const std::string id = list(ids, base), at = text(where);
  const auto one = [&](std::size_t i) { return i < ids.size() ? list({ids[i]}, base) : std::string(); };
  switch (kind) {
    case ProblemKind::non_finite_coordinate:
      return "Point " + id + " at " + at + " has a coordinate that is not a finite number.";
    case ProblemKind::coordinate_out_of_range:
      return "Point " + id + " at " + at +
             " has a coordinate outside the range that exact arithmetic can use: zero, or " + "between " +
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
  }
  return name(kind);
}

}  // namespace pardel
