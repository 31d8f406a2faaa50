#include "small_angles.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace pardel::schemes {
namespace {

constexpr double cosine_of_sixty_degrees = 0.5;
/// Numbers are equal if they differ by rounding only.
constexpr double rounding = 1e-10;

/// How far rounding moves a split point near p, at most.
double rounding_at(Point p) { return 0x1p-50 * std::max(std::abs(p.x), std::abs(p.y)); }

/// The point m, which was computed on the segment ab. If it is more than a rounding off the segment, because midpoints
/// of midpoints were rounded again and again, one coordinate is computed anew from the ends.
Point back_on_segment(Point m, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double off = std::abs(dx * (m.y - a.y) - dy * (m.x - a.x));
  if (off <= rounding_at(m) / 8 * std::hypot(dx, dy)) return m;
  if (std::abs(dx) >= std::abs(dy)) return {m.x, std::fma(m.x - a.x, dy / dx, a.y)};
  return {std::fma(m.y - a.y, dx / dy, a.x), m.y};
}

double distance(Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); }

double cosine(Point apex, Point p, Point q) {
  const double dot = (p.x - apex.x) * (q.x - apex.x) + (p.y - apex.y) * (q.y - apex.y);
  return dot / (distance(apex, p) * distance(apex, q));
}

/// The tangent of the least angle that refinement leaves across a corner with this cosine (Miller, Pav and Walkington):
/// that of a triangle whose third corner lies on the next shell, twice as far away.
double least_tangent(double cosine_of_corner) {
  return std::sqrt(1 - cosine_of_corner * cosine_of_corner) / (2 - cosine_of_corner);
}

/// Has the angle at `apex` between p and q at least this tangent, up to rounding? Precondition: it is acute.
bool keeps_tangent(Point apex, Point p, Point q, double tangent) {
  const double px = p.x - apex.x, py = p.y - apex.y, qx = q.x - apex.x, qy = q.y - apex.y;
  const double error = rounding_at(apex) * (std::abs(px) + std::abs(py) + std::abs(qx) + std::abs(qy));
  return std::abs(px * qy - py * qx) >= (1 - rounding) * tangent * (px * qx + py * qy) - error;
}

Index other_end(const std::array<Index, 2>& segment, Index end) { return segment[0] == end ? segment[1] : segment[0]; }

}  // namespace

SmallAngles::SmallAngles(const LinkedMesh& mesh)
    : inputs_(static_cast<Index>(mesh.points.size())), sharp_(mesh.segments.size(), {false, false}) {
  std::map<Index, std::vector<Index>> at;
  for (Index s = 0; s < mesh.segments.size(); ++s)
    for (const Index end : mesh.segments[s]) at[end].push_back(s);
  const auto is_sharp = [&](Index s, Index apex) {
    return std::ranges::any_of(
        at[apex], [&](Index r) { return r != s && cosine_between(mesh, s, r, apex) > cosine_of_sixty_degrees; });
  };
  for (Index s = 0; s < mesh.segments.size(); ++s)
    for (const std::size_t end : {0U, 1U}) sharp_[s][end] = is_sharp(s, mesh.segments[s][end]);
}

double SmallAngles::cosine_between(const LinkedMesh& mesh, Index s, Index r, Index apex) {
  const Point p = mesh.points[other_end(mesh.segments[s], apex)], q = mesh.points[other_end(mesh.segments[r], apex)];
  return cosine(mesh.points[apex], p, q);
}

Point SmallAngles::split_point(const LinkedMesh& mesh, Side side) const {
  const auto [a, b] = ends(mesh, side);
  return split_point(mesh, mesh.faces[side.triangle].segment[side.i], a, b);
}

Point SmallAngles::split_point(const LinkedMesh& mesh, Index s, Index a, Index b) const {
  const auto is_apex = [&](Index v) {
    return (v == mesh.segments[s][0] && sharp_[s][0]) || (v == mesh.segments[s][1] && sharp_[s][1]);
  };
  if (is_apex(a) == is_apex(b)) {
    const Point p = mesh.points[a], q = mesh.points[b];
    const Point middle{p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2};
    return back_on_segment(middle, mesh.points[mesh.segments[s][0]], mesh.points[mesh.segments[s][1]]);
  }
  const Point apex = mesh.points[is_apex(a) ? a : b], end = mesh.points[is_apex(a) ? b : a];
  const double length = distance(apex, end);
  const double share = std::exp2(std::round(std::log2(length / 2))) / length;
  return {apex.x + (end.x - apex.x) * share, apex.y + (end.y - apex.y) * share};
}

bool SmallAngles::justify(const LinkedMesh& mesh, Index t, int k) const {
  const Face& face = mesh.faces[t];
  const int left = (k + 1) % 3, right = (k + 2) % 3;
  const Index p = face.v[left], q = face.v[right];
  const auto explains = [&](Index s, Index r, Index apex) {
    const double between = cosine_between(mesh, s, r, apex);
    return between > cosine_of_sixty_degrees &&
           keeps_tangent(mesh.points[face.v[k]], mesh.points[p], mesh.points[q], least_tangent(between));
  };
  const Index apex = face.v[k], s = face.segment[left], r = face.segment[right];
  if (apex < inputs_ && s != no_segment && r != no_segment && s != r) return explains(s, r, apex);

  const Index of_p = mesh.segment_of[p], of_q = mesh.segment_of[q];
  if (of_p == no_segment || of_q == no_segment || of_p == of_q) return false;
  return std::ranges::any_of(mesh.segments[of_p], [&](Index centre) {
    if (mesh.segments[of_q][0] != centre && mesh.segments[of_q][1] != centre) return false;
    const double to_p = distance(mesh.points[centre], mesh.points[p]);
    const double to_q = distance(mesh.points[centre], mesh.points[q]);
    const double error = rounding * std::max(to_p, to_q) + rounding_at(mesh.points[centre]);
    return std::abs(to_p - to_q) <= error && explains(of_p, of_q, centre);
  });
}

}  // namespace pardel::schemes
