#include "divided_background.hpp"

#include <unordered_map>
#include <utility>

#include "../../core/support/answers_of_ranks.hpp"
#include "../../parallel/arithmetic/between_ends.hpp"
#include "../../parallel/conversion/export_mesh.hpp"
#include "../../parallel/sizing/background.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

/// The area of a triangle, for CurveDivision::others_in().
class TriangleArea {
 public:
  explicit TriangleArea(const std::array<Point, 3>& corners) : corners_(corners), bounds_(Box::around(corners[0])) {
    for (const Point p : corners) bounds_.cover(Box::around(p));
  }
  [[nodiscard]] bool may_meet(const Box& box) const {
    return bounds_.intersects_closed(box) && HalfPlane{corners_[0], corners_[1]}.may_meet(box) &&
           HalfPlane{corners_[1], corners_[2]}.may_meet(box) && HalfPlane{corners_[2], corners_[0]}.may_meet(box);
  }
  [[nodiscard]] double resolution() const { return bounds_.extent() / 8; }

 private:
  std::array<Point, 3> corners_;
  Box bounds_;
};

struct TravellingTriangle {
  std::array<Point, 3> corners;
  std::array<std::uint64_t, 3> numbers;
};

}  // namespace

DividedBackground::DividedBackground(const PartOfDomain& part, const CurveDivision& division, Ranks& ranks,
                                     const Threads& threads)
    : division_(division), threads_(threads), inputs_(part.points) {
  add_points_of(part, ranks);
  add_triangles_at_home(part, ranks);
}

/// The points of the part, with their numbers in the input. Other ranks are asked for the numbers of theirs.
void DividedBackground::add_points_of(const PartOfDomain& part, Ranks& ranks) {
  const auto points = part.domain.triangulation.points.span();
  points_.assign(points.begin(), points.end());
  number_.assign(part.number.begin(), part.number.end());
  number_.resize(points_.size());
  std::vector<Name> asked;
  for (const auto& [v, name] : part.named_vertices) asked.push_back(name);
  const std::vector<std::uint64_t> answers = answers_of_ranks<std::uint64_t>(
      asked, 1, ranks, [&](std::size_t i) { return Name::rank_of(asked[i].creator); },
      [&](const std::vector<Name>& names) {
        std::vector<std::uint64_t> numbers;
        for (const Name name : names) {
          if (name.id >= part.number.size()) throw Reader::does_not_match();
          numbers.push_back(part.number[name.id]);
        }
        return numbers;
      });
  for (std::size_t i = 0; i < asked.size(); ++i) number_[part.named_vertices[i].first] = answers[i];
}

/// A vertex that will be inserted lies in a triangle, or so near to one that the margin of CurveGrid::square() covers
/// the distance. So the rank that owns its place gets the triangle.
void DividedBackground::add_triangles_at_home(const PartOfDomain& part, Ranks& ranks) {
  const Triangulation& t = part.domain.triangulation;
  std::vector<std::vector<TravellingTriangle>> leaving(static_cast<std::size_t>(ranks.count()));
  std::unordered_map<std::uint64_t, Index> known;  // vertices by their numbers
  SparseAsk ask(threads_.stop);
  for (const Slot& slot : t.slots) {
    ask();
    if (division_.owner(t.points[least_corner(t, slot)]) != ranks.rank()) continue;
    triangles_.push_back(slot.v);
    const std::array<Point, 3> p{t.points[slot.v[0]], t.points[slot.v[1]], t.points[slot.v[2]]};
    if (division_.certainly_owns(ranks.rank(), Disk::around(p[0], p[1], p[2]))) continue;
    // Triangles that arrive from others may be neighbours of this one.
    for (const VertexId v : slot.v) known.emplace(number_[v], v);
    for (const int rank : division_.others_in(TriangleArea(p), ranks.rank()))
      leaving[rank].push_back({p, {number_[slot.v[0]], number_[slot.v[1]], number_[slot.v[2]]}});
  }
  for (const TravellingTriangle& each : concatenated(exchange_lists(std::move(leaving), ranks))) {
    std::array<Index, 3>& triangle = triangles_.emplace_back();
    for (unsigned i = 0; i < 3; ++i) {
      const auto [at, is_new] = known.emplace(each.numbers[i], static_cast<Index>(points_.size()));
      triangle[i] = at->second;
      if (!is_new) continue;
      points_.push_back(each.corners[i]);
      number_.push_back(each.numbers[i]);
    }
  }
}

void DividedBackground::add_attributes(MeshPiece& piece, const KeptDomain& kept, Ranks& ranks) && {
  Mesh& mesh = piece.mesh;
  const std::size_t k = mesh.attributes_per_point = kept.attributes.per_item();
  const std::vector<double> values = kept.attributes.of(number_, ranks);
  number_ = {};
  const PointData data{points_, k, values, {}};
  const bool is_empty = triangles_.empty();
  const Background background(points_, std::move(triangles_), threads_);

  std::vector<std::uint64_t> numbers;
  std::vector<Point> inserted;
  for (Index v = 0; v < mesh.points.size(); ++v)
    if (piece.number[v] < inputs_)
      numbers.push_back(piece.number[v]);
    else
      inserted.push_back(mesh.points[v]);
  const std::vector<double> given = kept.attributes.of(numbers, ranks);
  const auto owner = [&](std::size_t i) { return division_.owner(inserted[i]); };
  const std::vector<double> interpolated =
      answers_of_ranks<double>(inserted, k, ranks, owner, [&](const std::vector<Point>& places) {
        if (is_empty && !places.empty()) throw Reader::does_not_match();
        return interpolated_attributes(background, places, data, threads_);
      });
  auto next_given = given.begin(), next_interpolated = interpolated.begin();
  mesh.point_attributes.reserve(k * mesh.points.size());
  for (Index v = 0; v < mesh.points.size(); ++v) {
    auto& next = piece.number[v] < inputs_ ? next_given : next_interpolated;
    for (std::size_t a = 0; a < k; ++a) mesh.point_attributes.push_back(*next++);
  }
  add_along_segments(mesh, kept, ranks);
}

/// Replaces the attributes of the vertices inside segments.
void DividedBackground::add_along_segments(Mesh& mesh, const KeptDomain& kept, Ranks& ranks) {
  std::vector<Index> vertices;
  std::vector<std::uint64_t> segments, points;
  for (Index v = 0; v < mesh.points.size(); ++v) {
    const Index origin = mesh.origin[v];
    if (origin == interior_vertex || origin == input_vertex || origin == hull_vertex) continue;
    vertices.push_back(v);
    segments.push_back(segment_of_origin(origin));
  }
  for (const Segment& segment : kept.segments.of(segments, ranks)) points.insert(points.end(), {segment.a, segment.b});
  const std::vector<Point> places = kept.points.of(points, ranks);
  const std::vector<double> values = kept.attributes.of(points, ranks);
  const std::size_t k = kept.attributes.per_item();
  const auto end = [&](std::size_t i) { return SegmentEnd{places[i], std::span(values).subspan(i * k, k)}; };
  for (std::size_t i = 0; i < vertices.size(); ++i)
    interpolate_between(end(2 * i), end(2 * i + 1), mesh.points[vertices[i]],
                        mesh.point_attributes.span().subspan(vertices[i] * k, k));
}

}  // namespace pardel::engine
