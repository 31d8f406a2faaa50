// Edge lengths from a limit on gradation and from the features of a domain: the engine and the checker compared with
// the definition, and what the meshes then have.
#include "../../../ref/wanted_length.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <set>

#include "../../../core/digest.hpp"
#include "../../../parallel/sizes.hpp"
#include "../framework/shares.hpp"
#include "../refinement/meshing.hpp"
#include "rings.hpp"

namespace pardel::properties {
namespace {

constexpr const char* definition = "docs/sizes.md";
constexpr const char* families = "lattice domains of every family; rings between two polylines with up to 58 vertices";
constexpr double infinity = std::numeric_limits<double>::infinity();

Pslg some_domain(Exhibit& exhibit) {
  if (*rc::gen::inRange(0, 4) != 0) return to_pslg(some_case(exhibit).domain);
  const Ring ring = *generators::generator(random_ring, [](const Ring& r) { return shrinks(r); });
  RC_TAG(std::string("ring"));
  Pslg pslg = to_pslg(ring);
  exhibit.show(pslg);
  return pslg;
}

struct Box {
  Point low{infinity, infinity}, high{-infinity, -infinity};
};
Box box_of(const Pslg& pslg) {
  Box box;
  for (const Point p : pslg.points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}
double extent(const Box& box) { return std::max(box.high.x - box.low.x, box.high.y - box.low.y); }

/// Twice the error of a length whose ends have rounded coordinates, or more.
double rounding_at(const Box& box) {
  return 0x1p-50 * std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
}

double some_fraction() { return *rc::gen::inRange(0, 1001) / 1000.0; }
Point some_point(const Box& box) {
  return {box.low.x + some_fraction() * (box.high.x - box.low.x),
          box.low.y + some_fraction() * (box.high.y - box.low.y)};
}
double distance(Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// A goal with one of the two bounds or both, and with sources.
Goal some_graded_goal(const Box& box) {
  Goal goal{.min_angle_deg = *rc::gen::element(0.0, 20.7, 28.0)};
  const int kind = *rc::gen::inRange(0, 3);
  if (kind != 0) goal.feature_edges = *rc::gen::element(0.5, 1.0, 2.0, 3.0);
  if (kind != 1) goal.grading = *rc::gen::element(0.15, 0.3, 1.0);
  const int sources = goal.grading < infinity ? *rc::gen::inRange(0, 4) : 0;
  const auto length = [&] { return extent(box) * 0.01 * *rc::gen::inRange(4, 40); };
  for (int i = 0; i < sources; ++i) {
    const Point a = some_point(box);
    goal.sources.push_back({a, i % 2 == 0 ? a : some_point(box), length(), length()});
    if (i % 2 == 0) goal.sources.back().at_b = goal.sources.back().at_a;
  }
  return goal;
}

struct GradedDomain {
  Pslg pslg;
  Box box;
  Goal goal;
};
GradedDomain some_graded_domain(Exhibit& exhibit) {
  const Pslg pslg = some_domain(exhibit);
  const Box box = box_of(pslg);
  return {pslg, box, some_graded_goal(box)};
}

std::function<double(Point)> size_of(const Pslg& pslg, const Goal& goal) {
  auto domain = validate(pslg);
  RC_ASSERT(domain.ok());
  Result<std::function<double(Point)>> size = allowed_size(*domain, goal);
  if (!size) RC_FAIL(size.error().message);
  return std::move(*size);
}

constexpr double rounding = 1e-9;

PARDEL_PROPERTY(WantedLength, of_the_engine_is_that_of_the_definition,
                {.statement = "The length that the engine allows at a point is at most that of the definition, and at "
                              "least two thirds of it.",
                 .source = definition,
                 .families = families}) {
  const auto [pslg, box, goal] = some_graded_domain(exhibit);
  const auto size = size_of(pslg, goal);
  const ref::WantedLength wanted(pslg, goal, 24);
  std::vector<Point> places{pslg.points[*rc::gen::inRange<std::size_t>(0, pslg.points.size())]};
  for (int i = 0; i < 6; ++i) places.push_back(some_point(box));
  for (const Point p : places) {
    const double most = wanted.at(p), slack = rounding * most + rounding_at(box);
    RC_ASSERT(size(p) <= most + slack);
    RC_ASSERT(size(p) >= 2.0 / 3 * (most - wanted.error()) - slack);
  }
  classify(wanted.error() < 0.2 * wanted.at(places[0]), "the definition is known to a fifth", 40);
}

PARDEL_PROPERTY(WantedLength, grows_by_at_most_the_limit,
                {.statement = "The lengths that the engine allows at two points differ by at most their distance times "
                              "the limit on gradation, or times the reciprocal of the number of edges across narrow "
                              "places if there is no other limit.",
                 .source = definition,
                 .families = families}) {
  const auto [pslg, box, goal] = some_graded_domain(exhibit);
  const auto size = size_of(pslg, goal);
  const double slope = goal.grading < infinity ? goal.grading : 1 / goal.feature_edges;
  for (int i = 0; i < 10; ++i) {
    const Point p = some_point(box), far = some_point(box);
    const double f = std::ldexp(1.0, -*rc::gen::inRange(0, 12));
    const Point q{p.x + f * (far.x - p.x), p.y + f * (far.y - p.y)};
    if (size(p) == infinity) {
      RC_ASSERT(size(q) == infinity);
      continue;
    }
    RC_ASSERT(std::abs(size(p) - size(q)) <= slope * distance(p, q) + rounding * size(p) + rounding_at(box));
  }
}

PARDEL_PROPERTY(WantedLength, does_not_depend_on_the_numbering,
                {.statement = "The lengths that the engine allows do not depend on the order of points and segments, "
                              "nor on the direction of segments, not even in the last bit.",
                 .source = definition,
                 .families = families}) {
  const auto [pslg, box, goal] = some_graded_domain(exhibit);
  generators::Random random(*rc::gen::arbitrary<std::uint64_t>());
  std::vector<Index> order(pslg.points.size()), place(pslg.points.size());
  std::iota(order.begin(), order.end(), Index{0});
  random.shuffle(order);
  Pslg other = pslg;
  for (Index i = 0; i < order.size(); ++i) {
    other.points[i] = pslg.points[order[i]];
    place[order[i]] = i;
  }
  for (Segment& s : other.segments) {
    s = {place[s.a], place[s.b], s.marker};
    if (random.chance(2)) std::swap(s.a, s.b);
  }
  random.shuffle(other.segments);
  other.point_attributes.clear();
  other.attributes_per_point = 0;
  other.point_markers.clear();
  const auto one = size_of(pslg, goal), two = size_of(other, goal);
  for (int i = 0; i < 10; ++i) {
    const Point p = some_point(box);
    RC_ASSERT(one(p) == two(p));
  }
}

double longest_edge(const Mesh& mesh, const Triangle& t) {
  double longest = 0;
  for (unsigned i = 0; i < 3; ++i)
    longest = std::max(longest, distance(mesh.points[t.v[i]], mesh.points[t.v[(i + 1) % 3]]));
  return longest;
}
Point centroid(const Mesh& mesh, const Triangle& t) {
  const Point a = mesh.points[t.v[0]], b = mesh.points[t.v[1]], c = mesh.points[t.v[2]];
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}

PARDEL_PROPERTY(WantedLength, of_the_checker_is_that_of_the_definition,
                {.statement = "The checker reports every triangle whose longest edge exceeds 1.2 times the length that "
                              "the definition allows at its centroid, and none whose edges the definition allows.",
                 .source = definition,
                 .families = families}) {
  const auto [pslg, box, goal] = some_graded_domain(exhibit);
  const Mesh coarse = value_of(mesh(pslg, {.min_angle_deg = goal.min_angle_deg})).mesh;
  const Certificate certificate = check(pslg, coarse, goal, {.max_violations = coarse.triangles.size()});
  std::set<Index> reported;
  for (const Violation& v : certificate.violations)
    if (v.kind == ViolationKind::size_exceeded) reported.insert(v.ids[0]);
  const ref::WantedLength wanted(pslg, goal, 24);
  bool any = false;
  for (Index t = 0; t < coarse.triangles.size(); ++t) {
    const double most = wanted.at(centroid(coarse, coarse.triangles[t]));
    const double longest = longest_edge(coarse, coarse.triangles[t]), slack = 16 * rounding_at(box);
    if (longest > 1.2 * most + slack) RC_ASSERT(reported.contains(t));
    if (longest <= most - wanted.error() - slack) RC_ASSERT(!reported.contains(t));
    any = any || longest > 1.2 * most + slack;
  }
  classify(any, "a triangle is too large", 40);
}

PARDEL_PROPERTY(WantedLength, is_kept_by_a_certified_mesh_that_threads_do_not_change,
                {.statement = "A mesh for a limit on gradation or for edges across narrow places is certified. It is "
                              "the same on 1, 2 and 4 threads.",
                 .source = definition,
                 .families = families}) {
  const auto [pslg, box, goal] = some_graded_domain(exhibit);
  Problem problem{pslg, goal};
  Options options = some_options();
  const Meshed result = meshed(problem, exhibit, options);
  require_valid(check(problem.pslg, result.mesh, problem.goal));
  for (const int threads : {2, 4}) {
    options.threads = threads;
    RC_ASSERT(digest(meshed(problem, exhibit, options).mesh) == digest(result.mesh));
  }
}

/// The vertices of the mesh that lie on a feature of the domain.
std::vector<Index> vertices_on(const Pslg& pslg, const Mesh& mesh, ref::Feature f) {
  std::vector<Index> found{f.a};
  if (f.b != f.a) found.push_back(f.b);
  for (Index v = 0; v < mesh.points.size(); ++v) {
    const Index segment = segment_of_origin(mesh.origin[v]);
    if (segment >= pslg.segments.size() || f.a == f.b) continue;
    const Segment& s = pslg.segments[segment];
    if ((s.a == f.a && s.b == f.b) || (s.a == f.b && s.b == f.a)) found.push_back(v);
  }
  return found;
}

/// The least number of edges of the mesh from a vertex of `from` to each vertex.
std::vector<Index> edges_from(const std::vector<std::vector<Index>>& next, const std::vector<Index>& from) {
  std::vector<Index> edges(next.size(), no_index);
  std::deque<Index> waiting(from.begin(), from.end());
  for (const Index v : from) edges[v] = 0;
  for (; !waiting.empty(); waiting.pop_front())
    for (const Index w : next[waiting.front()])
      if (edges[w] == no_index) {
        edges[w] = edges[waiting.front()] + 1;
        waiting.push_back(w);
      }
  return edges;
}

PARDEL_PROPERTY(
    WantedLength, gives_the_edges_across_narrow_places,
    {.statement = "In a mesh with K edges per feature size whose lengths grow by at most g, each path of "
                  "edges between two features of which neither touches the other has at least (1 - 2g/3) (2/g) "
                  "ln(1 + g K / 2) edges.",
     .source = "properties/THEORY.md, WantedLength",
     .families = families}) {
  const Pslg pslg = some_domain(exhibit);
  const double edges = *rc::gen::element(2.0, 3.0, 5.0);
  Problem problem{pslg, {.min_angle_deg = 20.7, .feature_edges = edges}};
  if (*rc::gen::arbitrary<bool>()) problem.goal.grading = 0.1;
  const Mesh made = meshed(problem, exhibit).mesh;
  std::vector<std::vector<Index>> next(made.points.size());
  for (const Triangle& t : made.triangles)
    for (unsigned i = 0; i < 3; ++i) {
      next[t.v[i]].push_back(t.v[(i + 1) % 3]);
      next[t.v[(i + 1) % 3]].push_back(t.v[i]);
    }
  const double growth = std::min(problem.goal.grading, 1 / edges);
  const double least = (1 - 2 * growth / 3) * (2 / growth) * std::log(1 + growth * edges / 2);
  const std::vector<ref::Feature> features = ref::features_of(pslg);
  std::vector<std::vector<ref::Feature>> near;
  for (const ref::Feature& f : features) near.push_back(ref::touching(pslg, f));
  const auto touches = [&](std::size_t i, std::size_t j) {
    return std::ranges::any_of(near[i], [&](const ref::Feature& n) {
      return (n.a == features[j].a && n.b == features[j].b) || (n.a == features[j].b && n.b == features[j].a);
    });
  };
  Index fewest = no_index;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const std::vector<Index> away = edges_from(next, vertices_on(pslg, made, features[i]));
    for (std::size_t j = 0; j < i; ++j)
      if (!touches(i, j) && !touches(j, i))
        for (const Index v : vertices_on(pslg, made, features[j])) fewest = std::min(fewest, away[v]);
  }
  RC_ASSERT(fewest >= least);
  classify(fewest < 2 * least + 1, "a path has fewer than twice as many edges", 30);
}

}  // namespace
}  // namespace pardel::properties
