// A part of a mesh on its way to a mesher and back: what verification accepts and refuses, and what gluing makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../../off_the_shelf/own_mesher.hpp"
#include "../../off_the_shelf/subdomains/glue.hpp"
#include "../../off_the_shelf/subdomains/half_edges.hpp"
#include "../../off_the_shelf/subdomains/verify.hpp"
#include "../../parallel/arithmetic/predicates.hpp"
#include "../../properties/comparison/all_arrays.hpp"
#include "some_part.hpp"

namespace pardel::engine {
namespace {

using Verified = Result<VerifiedSubdomain, Breach>;

constexpr const char* source = "docs/off-the-shelf.md, what is verified";
constexpr const char* families = "parts of meshes of lattice domains of every family, cut off by lines or at random";

/// The subdomain as it is.
RefinedSubdomain unchanged(const Subdomain& subdomain) {
  RefinedSubdomain answer;
  answer.points = subdomain.points;
  answer.triangles = subdomain.triangles;
  return answer;
}

Verified verified(const Part& part, RefinedSubdomain answer) {
  return verify(part.subdomain, std::move(answer), part.lines, Floor(part.subdomain.min_edge));
}

/// A part with the answer of pardel's own refiner.
struct Answered {
  std::unique_ptr<WorkedDomain> worked;
  Part part;
  RefinedSubdomain answer;
};
Answered some_answer(properties::Exhibit& exhibit) {
  Answered result{some_worked_domain(exhibit), {}, {}};
  result.part = result.worked->part(some_triangles(result.worked->domain().triangulation));
  result.answer = own_mesher()->refine(result.part.subdomain);
  return result;
}

/// Fails unless the answer is refused for this reason.
void require_breach(const Verified& verified, BreachKind kind) {
  if (verified.ok()) RC_FAIL(std::string("accepted, not ") + name(kind));
  RC_LOG() << verified.error().what << '\n';
  RC_ASSERT(std::string(name(verified.error().kind)) == name(kind));
}

/// A random element.
template <class T>
Index some_index(const std::vector<T>& list) {
  return *rc::gen::inRange<Index>(0, static_cast<Index>(list.size()));
}

/// The index of a random edge for which is_wanted() is true; the case does not count if there is none.
template <class Wanted>
Index some_edge(const Subdomain& subdomain, const Wanted& is_wanted) {
  std::vector<Index> found;
  for (Index i = 0; i < subdomain.edges.size(); ++i)
    if (is_wanted(subdomain.edges[i])) found.push_back(i);
  RC_PRE(!found.empty());
  return found[some_index(found)];
}

/// Splits an edge of the triangles at p: the new point takes the place of one end in a copy of each triangle.
void split_edge(RefinedSubdomain& answer, Index a, Index b, Point p, Index edge) {
  const auto point = static_cast<Index>(answer.points.size());
  answer.points.push_back(p);
  answer.edge_of_new_point.push_back(edge);
  const std::size_t count = answer.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    const auto has = [&](Index v) { return std::ranges::find(answer.triangles[t], v) != answer.triangles[t].end(); };
    if (!has(a) || !has(b)) continue;
    auto other = answer.triangles[t];
    std::ranges::replace(other, a, point);
    std::ranges::replace(answer.triangles[t], b, point);
    answer.triangles.push_back(other);
  }
}

Point middle(Point a, Point b) { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; }

/// Inserts a point into a triangle.
void split_triangle(RefinedSubdomain& answer, Index triangle, Point p) {
  const auto point = static_cast<Index>(answer.points.size());
  answer.points.push_back(p);
  answer.edge_of_new_point.push_back(no_index);
  const auto v = answer.triangles[triangle];
  answer.triangles[triangle] = {v[0], v[1], point};
  answer.triangles.push_back({v[1], v[2], point});
  answer.triangles.push_back({v[2], v[0], point});
}

Point centroid(const RefinedSubdomain& answer, Index triangle) {
  const auto& v = answer.triangles[triangle];
  const Point a = answer.points[v[0]], b = answer.points[v[1]], c = answer.points[v[2]];
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}

PARDEL_PROPERTY(Part, that_nothing_was_done_to_is_accepted,
                {.statement = "The triangles of a subdomain, unchanged, keep the contract.",
                 .source = source,
                 .families = families}) {
  const auto worked = some_worked_domain(exhibit);
  const Part part = worked->part(some_triangles(worked->domain().triangulation));
  const Verified result = verified(part, unchanged(part.subdomain));
  if (!result) RC_FAIL(result.error().what);
}

PARDEL_PROPERTY(Part, lists_each_edge_of_its_border_and_each_segment_inside_once,
                {.statement = "The edges of a subdomain are the sides with a triangle on the left only, and the "
                              "constrained edges inside; the part lies to their left.",
                 .source = "off_the_shelf/subdomain_mesher.hpp",
                 .families = families}) {
  const auto worked = some_worked_domain(exhibit);
  const Triangulation& t = worked->domain().triangulation;
  const std::vector<TriangleId> chosen = some_triangles(t);
  const Part part = worked->part(chosen);
  std::vector<std::pair<VertexId, VertexId>> expected, found;
  for (const TriangleId id : chosen)
    for (unsigned side = 0; side < 3; ++side) {
      const EdgeRef outer = t.slots[id].n[side];
      const bool inside = !outer.none() && std::ranges::binary_search(chosen, outer.triangle());
      if (!inside || (outer.constrained() && id < outer.triangle()))
        expected.emplace_back(t.slots[id].from(side), t.slots[id].to(side));
    }
  for (const SubdomainEdge& e : part.subdomain.edges) found.emplace_back(part.vertices[e.a], part.vertices[e.b]);
  std::ranges::sort(expected);
  std::ranges::sort(found);
  RC_ASSERT(found == expected);
  for (std::size_t i = 0; i < part.seams.size(); ++i) {
    RC_ASSERT(part.subdomain.edges[i].inside ==
              (!part.seams[i].outer.none() && std::ranges::binary_search(chosen, part.seams[i].outer.triangle())));
    RC_ASSERT(!part.subdomain.edges[i].may_be_split || part.seams[i].segment != no_index);
  }
}

PARDEL_PROPERTY(Part, refined_by_the_own_refiner_is_accepted,
                {.statement = "pardel's own refiner keeps the contract for every part of every mesh.",
                 .source = source,
                 .families = families}) {
  const Answered answered = some_answer(exhibit);
  const Verified result = verified(answered.part, answered.answer);
  if (!result) RC_FAIL(result.error().what);
}

PARDEL_PROPERTY(Part, refined_in_a_cell_has_no_new_point_outside,
                {.statement = "pardel's own refiner inserts points in a given cell only.",
                 .source = source,
                 .families = families}) {
  const auto worked = some_worked_domain(exhibit);
  Part part = worked->part(some_triangles(worked->domain().triangulation));
  const Point centre = part.subdomain.points[some_index(part.subdomain.points)];
  const double half = properties::extent_of(worked->pslg()) / *rc::gen::inRange(2, 20);
  part.subdomain.cell = SubdomainCell{{centre.x - half, centre.y - half}, {centre.x + half, centre.y + half}};
  RefinedSubdomain answer = own_mesher()->refine(part.subdomain);
  for (std::size_t i = part.subdomain.points.size(); i < answer.points.size(); ++i)
    RC_ASSERT(part.subdomain.cell->contains(answer.points[i]));
  const Verified result = verified(part, std::move(answer));
  if (!result) RC_FAIL(result.error().what);
}

PARDEL_PROPERTY(Part, with_a_frozen_border_keeps_all_its_edges,
                {.statement = "If no segment may be split, pardel's own refiner splits no edge.",
                 .source = source,
                 .families = families}) {
  const auto worked = some_worked_domain(exhibit);
  const Part part = worked->part(some_triangles(worked->domain().triangulation), false);
  RefinedSubdomain answer = own_mesher()->refine(part.subdomain);
  RC_ASSERT(std::ranges::all_of(answer.edge_of_new_point, [](Index edge) { return edge == no_index; }));
  const Verified result = verified(part, std::move(answer));
  if (!result) RC_FAIL(result.error().what);
}

PARDEL_PROPERTY(Part, with_a_moved_point_is_refused,
                {.statement = "An answer with another coordinate of a point of the subdomain, even by one bit, is "
                              "refused.",
                 .source = source,
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  double& x = answered.answer.points[some_index(answered.part.subdomain.points)].x;
  x = *rc::gen::arbitrary<bool>() ? std::nextafter(x, INFINITY) : x == 0 ? -x : std::nextafter(x, 0);
  require_breach(verified(answered.part, std::move(answered.answer)), BreachKind::moved_point);
}

PARDEL_PROPERTY(Part, with_a_missing_point_is_refused,
                {.statement = "An answer without one of the points of the subdomain is refused.",
                 .source = source,
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  answered.answer.points.resize(some_index(answered.part.subdomain.points));
  require_breach(verified(answered.part, std::move(answered.answer)), BreachKind::moved_point);
}

PARDEL_PROPERTY(Part, with_an_unusable_point_is_refused,
                {.statement = "An answer with a coordinate for which the predicates are not exact is refused.",
                 .source = source,
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  const double bad = *rc::gen::element(NAN, INFINITY, -INFINITY, 0x1p201, 0x1p-141);
  const Index triangle = some_index(answered.answer.triangles);
  split_triangle(answered.answer, triangle, {centroid(answered.answer, triangle).x, bad});
  require_breach(verified(answered.part, std::move(answered.answer)), BreachKind::unusable_point);
}

PARDEL_PROPERTY(Part, with_too_many_points_is_refused,
                {.statement = "An answer with one new point more than allowed is refused, and with as many it is not.",
                 .source = source,
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  const std::size_t made = answered.answer.edge_of_new_point.size();
  RC_PRE(made > 0);
  answered.part.subdomain.most_new_points = made;
  RC_ASSERT(verified(answered.part, answered.answer).ok());
  answered.part.subdomain.most_new_points = made - 1;
  require_breach(verified(answered.part, std::move(answered.answer)), BreachKind::too_many_points);
}

PARDEL_PROPERTY(Part, with_wrong_indices_is_refused,
                {.statement = "An answer that names a point or an edge that does not exist is refused.",
                 .source = source,
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  RefinedSubdomain& answer = answered.answer;
  const Index triangle = some_index(answer.triangles);
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      answer.triangles[triangle][2] = static_cast<Index>(answer.points.size());
      break;
    case 1:
      split_triangle(answer, triangle, centroid(answer, triangle));
      answer.edge_of_new_point.back() = static_cast<Index>(answered.part.subdomain.edges.size());
      break;
    default:
      answer.edge_of_new_point.push_back(no_index);
  }
  require_breach(verified(answered.part, std::move(answer)), BreachKind::wrong_index);
}

PARDEL_PROPERTY(Part, with_an_unused_point_is_refused,
                {.statement = "An answer with a point that is no corner is refused.",
                 .source = source,
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  answered.answer.points.push_back(centroid(answered.answer, 0));
  answered.answer.edge_of_new_point.push_back(no_index);
  require_breach(verified(answered.part, std::move(answered.answer)), BreachKind::unused_point);
}

PARDEL_PROPERTY(Part, with_a_turned_triangle_is_refused,
                {.statement = "An answer with one clockwise or flat triangle is refused.",
                 .source = source,
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  auto& triangle = answered.answer.triangles[some_index(answered.answer.triangles)];
  std::swap(triangle[0], triangle[1]);
  require_breach(verified(answered.part, std::move(answered.answer)), BreachKind::wrong_orientation);
}

PARDEL_PROPERTY(Part, with_a_triangle_twice_is_refused,
                {.statement = "An answer in which a triangle occurs twice is refused.",
                 .source = source,
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  auto triangle = answered.answer.triangles[some_index(answered.answer.triangles)];
  std::rotate(triangle.begin(), triangle.begin() + *rc::gen::inRange(0, 3), triangle.end());
  answered.answer.triangles.push_back(triangle);
  require_breach(verified(answered.part, std::move(answered.answer)), BreachKind::overlap);
}

/// A point that is this part of the way from the middle of an edge to another point.
Point beside(Point a, Point b, Point towards, double part) {
  const Point m = middle(a, b);
  return {m.x + part * (towards.x - m.x), m.y + part * (towards.y - m.y)};
}
bool is_left(Point a, Point b, Point p) { return orient2d(a, b, p) > 0; }

/// The triangles of a part across an edge that need not stay: (a, b, c) and (b, a, d).
struct Quadrilateral {
  std::size_t left, right;
  Index a, b, c, d;
};
std::vector<Quadrilateral> quadrilaterals(const Subdomain& subdomain, const RefinedSubdomain& answer) {
  std::vector<Quadrilateral> found;
  const HalfEdges sides(answer.triangles, answer.points.size());
  for (std::size_t t = 0; t < answer.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& v = answer.triangles[t];
      const Index a = v[k], b = v[(k + 1) % 3], back = sides.find(b, a);
      const bool stays = std::ranges::any_of(
          subdomain.edges, [&](const SubdomainEdge& e) { return (e.a == a && e.b == b) || (e.a == b && e.b == a); });
      if (back == no_index || stays || b < a) continue;
      found.push_back({t, back / 3, a, b, v[(k + 2) % 3], answer.triangles[back / 3][back % 3]});
    }
  return found;
}

PARDEL_PROPERTY(Part, with_close_points_is_refused_even_without_an_edge_between_them,
                {.statement = "Two new points just beside an edge, one on each side, are refused, although all edges "
                              "of the answer are long: after flips, one is not.",
                 .source = source,
                 .families = families}) {
  const auto worked = some_worked_domain(exhibit);
  const Part part = worked->part(some_triangles(worked->domain().triangulation));
  RefinedSubdomain answer = unchanged(part.subdomain);
  const auto all = quadrilaterals(part.subdomain, answer);
  RC_PRE(!all.empty());
  const Quadrilateral q = all[some_index(all)];
  const Point a = answer.points[q.a], b = answer.points[q.b];
  const double close = *rc::gen::element(0x1p-44, 0x1p-46, 0x1p-48);
  const Point left = beside(a, b, answer.points[q.c], close), right = beside(a, b, answer.points[q.d], close);
  RC_PRE(is_left(a, b, left) && is_left(b, a, right));
  split_triangle(answer, static_cast<Index>(q.left), left);
  split_triangle(answer, static_cast<Index>(q.right), right);
  require_breach(verified(part, std::move(answer)), BreachKind::too_short_edge);
}

PARDEL_PROPERTY(Part, with_a_point_close_to_an_edge_that_stays_is_refused,
                {.statement = "A new point just beside an edge that must stay is refused, although it is far from "
                              "all other points.",
                 .source = source,
                 .families = families}) {
  const auto worked = some_worked_domain(exhibit);
  const Part part = worked->part(some_triangles(worked->domain().triangulation));
  RefinedSubdomain answer = unchanged(part.subdomain);
  const SubdomainEdge& e = part.subdomain.edges[some_index(part.subdomain.edges)];
  const Index side = HalfEdges(answer.triangles, answer.points.size()).find(e.a, e.b);
  const Point a = answer.points[e.a], b = answer.points[e.b],
              apex = answer.points[answer.triangles[side / 3][side % 3]];
  const Point p = beside(a, b, apex, *rc::gen::element(0x1p-44, 0x1p-46, 0x1p-48));
  RC_PRE(is_left(a, b, p));
  split_triangle(answer, side / 3, p);
  require_breach(verified(part, std::move(answer)), BreachKind::too_near_edge);
}

PARDEL_PROPERTY(Part, with_other_triangles_becomes_constrained_delaunay,
                {.statement = "An answer whose triangulation is another one of the same points becomes the constrained "
                              "Delaunay triangulation, and its neighbours fit each other.",
                 .source = "off_the_shelf/subdomains/verify.hpp",
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  RefinedSubdomain& answer = answered.answer;
  int flips = 0;
  for (int i = *rc::gen::inRange(1, 8); i > 0; --i) {
    const auto all = quadrilaterals(answered.part.subdomain, answer);
    RC_PRE(!all.empty());
    const Quadrilateral q = all[some_index(all)];
    const auto at = [&](Index v) { return answer.points[v]; };
    if (!is_left(at(q.d), at(q.b), at(q.c)) || !is_left(at(q.a), at(q.d), at(q.c))) continue;
    // Pieces of split segments must stay, too.
    const auto is_on_edge = [&](Index v) {
      return v >= answered.part.subdomain.points.size() &&
             answer.edge_of_new_point[v - answered.part.subdomain.points.size()] != no_index;
    };
    if (is_on_edge(q.a) || is_on_edge(q.b)) continue;
    answer.triangles[q.left] = {q.d, q.b, q.c};
    answer.triangles[q.right] = {q.a, q.d, q.c};
    ++flips;
  }
  RC_TAG(flips > 0 ? "other triangles" : "the same triangles");
  const Verified result = verified(answered.part, std::move(answer));
  if (!result) RC_FAIL(result.error().what);
  const VerifiedSubdomain& made = *result;
  for (Index side = 0; side < made.across.size(); ++side) {
    const auto& v = made.triangles[side / 3];
    RC_ASSERT(is_left(made.points[v[0]], made.points[v[1]], made.points[v[2]]));
    const Index across = made.across[side];
    if (across == no_index) continue;
    const auto& w = made.triangles[across / 3];
    RC_ASSERT(made.across[across] == side);
    RC_ASSERT(made.on_edge[across] == made.on_edge[side]);
    RC_ASSERT(v[(side + 1) % 3] == w[(across % 3 + 2) % 3] && v[(side % 3 + 2) % 3] == w[(across + 1) % 3]);
    if (made.on_edge[side] == no_index)
      RC_ASSERT(!(incircle(made.points[v[0]], made.points[v[1]], made.points[v[2]], made.points[w[across % 3]]) > 0));
  }
}

TEST(Part, with_more_triangles_than_its_points_can_have_is_refused_at_once) {
  Subdomain subdomain;
  subdomain.points = {{0, 0}, {1, 0}, {0, 1}};
  subdomain.triangles = {{0, 1, 2}};
  subdomain.edges = {{0, 1}, {1, 2}, {2, 0}};
  RefinedSubdomain answer = unchanged(subdomain);
  answer.triangles.assign(7, {0, 1, 2});
  const Verified result = verify(subdomain, std::move(answer), std::vector<EndPoints>(3), Floor(0));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, BreachKind::overlap);
  EXPECT_EQ(result.error().what, "7 triangles, more than 3 points can have");
}

PARDEL_PROPERTY(Part, with_a_missing_triangle_is_refused,
                {.statement = "An answer that lacks a triangle is refused: an edge is lost or open, or a point unused.",
                 .source = source,
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  auto& triangles = answered.answer.triangles;
  triangles.erase(triangles.begin() + some_index(triangles));
  const Verified result = verified(answered.part, std::move(answered.answer));
  RC_ASSERT(!result.ok());
  const BreachKind kind = result.error().kind;
  RC_TAG(std::string(name(kind)));
  RC_ASSERT(kind == BreachKind::lost_edge || kind == BreachKind::open_edge || kind == BreachKind::unused_point);
}

PARDEL_PROPERTY(
    Part, with_a_split_frozen_edge_is_refused,
    {.statement = "An answer in which a frozen edge is split is refused, whether the mesher says so or not.",
     .source = source,
     .families = families}) {
  const auto worked = some_worked_domain(exhibit);
  const Part part = worked->part(some_triangles(worked->domain().triangulation), false);
  const Index edge = some_edge(part.subdomain, [](const SubdomainEdge& e) { return !e.may_be_split; });
  const SubdomainEdge& e = part.subdomain.edges[edge];
  const Point a = part.subdomain.points[e.a], b = part.subdomain.points[e.b];
  // Halves of coordinates on a lattice are exact.
  const Point p = middle(a, b);
  const bool admits = *rc::gen::arbitrary<bool>();
  RefinedSubdomain answer = unchanged(part.subdomain);
  split_edge(answer, e.a, e.b, p, admits ? edge : no_index);
  require_breach(verified(part, std::move(answer)), admits ? BreachKind::split_frozen_edge : BreachKind::lost_edge);
}

PARDEL_PROPERTY(Part, with_split_segments_is_accepted,
                {.statement = "An answer in which a segment that may be split is split at a point of it is accepted.",
                 .source = source,
                 .families = families}) {
  const auto worked = some_worked_domain(exhibit);
  const Part part = worked->part(some_triangles(worked->domain().triangulation));
  const Index edge = some_edge(part.subdomain, [](const SubdomainEdge& e) { return e.may_be_split; });
  const SubdomainEdge& e = part.subdomain.edges[edge];
  RefinedSubdomain answer = unchanged(part.subdomain);
  split_edge(answer, e.a, e.b, middle(part.subdomain.points[e.a], part.subdomain.points[e.b]), edge);
  const Verified result = verified(part, std::move(answer));
  if (!result) RC_FAIL(result.error().what);
}

PARDEL_PROPERTY(
    Part, with_a_point_beside_its_edge_is_refused,
    {.statement = "A point that is said to split an edge, but lies beside it or beyond its ends, is refused.",
     .source = source,
     .families = families}) {
  const auto worked = some_worked_domain(exhibit);
  const Part part = worked->part(some_triangles(worked->domain().triangulation));
  const Index edge = some_edge(part.subdomain, [](const SubdomainEdge& e) { return e.may_be_split; });
  const SubdomainEdge& e = part.subdomain.edges[edge];
  const Point a = part.subdomain.points[e.a], b = part.subdomain.points[e.b];
  const double off = *rc::gen::element(1e-6, 1e-3, 0.1), along = *rc::gen::element(-0.5, 0.5, 1.5);
  const double beside = along == 0.5 ? off : 0;
  const Point p{a.x + along * (b.x - a.x) - beside * (b.y - a.y), a.y + along * (b.y - a.y) + beside * (b.x - a.x)};
  RefinedSubdomain answer = unchanged(part.subdomain);
  split_edge(answer, e.a, e.b, p, edge);
  require_breach(verified(part, std::move(answer)), BreachKind::off_segment);
}

PARDEL_PROPERTY(Part, with_a_point_outside_the_cell_is_refused,
                {.statement = "A new point outside the cell of the task is refused.",
                 .source = source,
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  const std::size_t old = answered.part.subdomain.points.size();
  RC_PRE(answered.answer.points.size() > old);
  // Verification moves points of edges onto their lines.
  const std::vector<Point> points = verified(answered.part, answered.answer)->points;
  const Point p = points[*rc::gen::inRange(old, points.size())];
  // Everything but the place of this point: the cell is half-open.
  answered.part.subdomain.cell = *rc::gen::arbitrary<bool>()
                                     ? SubdomainCell{{-INFINITY, -INFINITY}, {p.x, INFINITY}}
                                     : SubdomainCell{{-INFINITY, std::nextafter(p.y, INFINITY)}, {INFINITY, INFINITY}};
  require_breach(verified(answered.part, std::move(answered.answer)), BreachKind::outside_cell);
}

PARDEL_PROPERTY(Part, with_an_edge_below_the_floor_is_refused,
                {.statement = "An answer with a new edge shorter than the floor is refused.",
                 .source = source,
                 .families = families}) {
  Answered answered = some_answer(exhibit);
  const std::size_t old = answered.part.subdomain.points.size();
  RC_PRE(answered.answer.points.size() > old);
  double shortest = INFINITY;
  for (const auto& v : answered.answer.triangles)
    for (int i = 0; i < 3; ++i)
      if (const Index a = v[i], b = v[(i + 1) % 3]; std::max(a, b) >= old)
        shortest = std::min(shortest, std::hypot(answered.answer.points[a].x - answered.answer.points[b].x,
                                                 answered.answer.points[a].y - answered.answer.points[b].y));
  answered.part.subdomain.min_edge = shortest * 0.999;
  RC_ASSERT(verified(answered.part, answered.answer).ok());
  answered.part.subdomain.min_edge = shortest * 1.001;
  require_breach(verified(answered.part, std::move(answered.answer)), BreachKind::too_short_edge);
}

PARDEL_PROPERTY(Gluing, of_unchanged_parts_changes_nothing,
                {.statement = "A mesh whose parts were taken out and glued in again, unchanged, is the same mesh with "
                              "all its data.",
                 .source = "off_the_shelf/subdomains/glue.hpp",
                 .families = families}) {
  const auto worked = some_worked_domain(exhibit);
  const Mesh before = worked->exported();
  const Part part = worked->part(some_triangles(worked->domain().triangulation));
  std::vector<Replacement> replacements;
  replacements.push_back({part, *verified(part, unchanged(part.subdomain))});
  glue(worked->mesh(), replacements, Threads(1));
  const std::string differs = properties::difference(before, worked->exported());
  if (!differs.empty()) RC_FAIL(differs);
}

PARDEL_PROPERTY(Gluing, of_refined_parts_makes_a_mesh_of_the_domain,
                {.statement = "After gluing refined parts side by side the mesh conforms to the domain and is "
                              "constrained Delaunay, on any number of threads.",
                 .source = "off_the_shelf/subdomains/glue.hpp",
                 .families = families}) {
  const auto worked = some_worked_domain(exhibit);
  const Triangulation& t = worked->domain().triangulation;
  // Two parts that do not overlap: the triangles on one side of a line, and some of the others.
  const std::vector<TriangleId> first = some_triangles(t);
  std::vector<TriangleId> second;
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    if (!std::ranges::binary_search(first, id)) second.push_back(id);
  std::vector<Replacement> replacements;
  for (const std::vector<TriangleId>& triangles : {first, second}) {
    if (triangles.empty()) continue;
    Part part = worked->part(triangles);
    RefinedSubdomain answer = own_mesher()->refine(part.subdomain);
    Verified result = verified(part, std::move(answer));
    if (!result) RC_FAIL(result.error().what);
    replacements.push_back({std::move(part), std::move(*result)});
  }
  glue(worked->mesh(), replacements, Threads(*rc::gen::inRange(1, 4)));
  const Mesh mesh = worked->exported();
  exhibit.show(worked->pslg(), mesh);
  properties::require_valid(check(worked->pslg(), mesh, {.min_angle_deg = 0}));
}

}  // namespace
}  // namespace pardel::engine
