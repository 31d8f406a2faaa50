// Domains whose points, segments and regions carry data, and goals and options of which many are set at once.
#include "decorated.hpp"

#include <string>
#include <utility>
#include <vector>

#include "../../../parallel/repair.hpp"
#include "../../domains/dealt_domain.hpp"
#include "../framework/mesh_of_ranks.hpp"
#include "../framework/shares.hpp"
#include "repeated_points.hpp"

namespace pardel::properties {
namespace {

constexpr const char* decorated_families =
    "lattice domains of every family; markers, attributes, bounds on sizes and options on at random and by pairs";

PARDEL_PROPERTY(Decorated, meshes_are_certified_and_every_triangle_that_misses_a_bound_is_listed,
                {.statement = "Whatever data a domain carries, and whichever bounds and options are set at once, the "
                              "mesh conforms to the domain with all its data and is (constrained) Delaunay. Each "
                              "triangle that misses a bound is listed in the report, and no segment that is to be "
                              "kept is split.",
                 .source = "properties/THEORY.md, refinement",
                 .families = decorated_families}) {
  const DecoratedProblem drawn = some_decorated_problem(exhibit);
  const Meshed result = meshed(drawn.problem, exhibit, drawn.options);
  require_certified(drawn, result);
  require_kept_segments(drawn, result);
  classify(drawn.wishes.on.count() >= 2, "two bounds or options at once", 60);
  classify(drawn.problem.pslg.attributes_per_point >= 2, "several attributes", 27);
  classify(!drawn.problem.pslg.point_markers.empty(), "points with markers", 40);
}

PARDEL_PROPERTY(Decorated, meshes_do_not_depend_on_threads_or_ranks,
                {.statement = "With data and with bounds and options of all kinds at once, two and three threads give "
                              "the mesh of one thread, and one to four ranks give it, too, also if none of them has "
                              "read the whole domain: with the same markers, attributes and origins.",
                 .source = "properties/THEORY_OF_RANKS.md, Ranks",
                 .families = decorated_families}) {
  const DecoratedProblem drawn = some_decorated_problem(exhibit);
  const auto& [pslg, goal] = drawn.problem;
  Options options = drawn.options;
  const Mesh one = meshed(drawn.problem, exhibit, options).mesh;
  options.threads = *rc::gen::element(2, 3);
  RC_ASSERT(value_of(mesh(pslg, goal, options)).mesh == one);

  options.threads = 1;
  const int count = *rc::gen::inRange(1, 5);
  const bool is_dealt = can_divide_points(goal, options) && *rc::gen::arbitrary<bool>();
  classify(is_dealt && count > 1, "no rank has the whole domain", 3);
  const ValidPslg domain = std::move(validate(pslg, {.convex_hull = goal.convex_hull})).value();
  const std::string difference = difference_on_ranks(one, count, [&, &pslg = pslg, &goal = goal](pardel::Ranks& ranks) {
    return is_dealt ? mesh(domains::equal_part(pslg, ranks), goal, options, ranks) : mesh(domain, goal, options, ranks);
  });
  RC_ASSERT(difference == "");
}

/// The mesh without its data.
Mesh bare(Mesh mesh) {
  mesh.point_markers.clear();
  mesh.point_attributes.clear();
  mesh.attributes_per_point = 0;
  mesh.region_attributes.clear();
  for (ConstrainedEdge& e : mesh.constrained_edges) e.marker = 0;
  return mesh;
}

PARDEL_PROPERTY(Decorated, meshes_have_the_triangles_of_the_domain_without_data,
                {.statement = "Markers and attributes change no triangle, as long as no marker is kept.",
                 .source = "properties/THEORY.md, refinement",
                 .families = decorated_families}) {
  DecoratedProblem drawn = some_decorated_problem(exhibit);
  drawn.options.kept_markers.clear();
  const Mesh with_data = meshed(drawn.problem, exhibit, drawn.options).mesh;
  Pslg& pslg = drawn.problem.pslg;
  pslg.point_markers.clear();
  pslg.point_attributes.clear();
  pslg.attributes_per_point = 0;
  for (Segment& s : pslg.segments) s.marker = 0;
  for (Region& region : pslg.regions) region.attribute = 0;
  RC_ASSERT(bare(value_of(mesh(pslg, drawn.problem.goal, drawn.options)).mesh) == bare(with_data));
}

PARDEL_PROPERTY(Decorated, domains_are_repaired_to_themselves_if_points_and_segments_are_repeated,
                {.statement = "Repeat points with other markers and attributes, let segments end at the copies, and "
                              "repeat segments with other markers. Repair gives the domain without the copies: the "
                              "data of the first of equal points stay, and the first marker of equal segments that is "
                              "not 0.",
                 .source = "parallel/repair.hpp",
                 .families = "lattice domains of every family, with decorations; up to five copies"}) {
  const Pslg pslg = to_pslg(some_case(exhibit).domain);
  const Repetitions drawn = some_repetitions(pslg);
  exhibit.show(drawn.with_copies);
  const Result<Repaired> repaired = repair(drawn.with_copies, {.snap = 0});
  if (!repaired) RC_FAIL(repaired.error().message);
  RC_ASSERT(repaired->domain.pslg() == drawn.repaired);
}

/// Makes one of many mistakes. Most of them make the domain invalid.
void spoil(Pslg& pslg) {
  const auto n = static_cast<Index>(pslg.points.size());
  const Point p = pslg.points[some_point(pslg)], q = pslg.points[some_point(pslg)];
  const Point middle{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2};
  const auto some_index = [&](Index most) { return *rc::gen::inRange<Index>(0, most + 1); };
  switch (*rc::gen::inRange(0, 8)) {
    case 0:
      pslg.holes.push_back(p);
      break;
    case 1:
      pslg.regions.push_back({p, 3});
      break;
    case 2:
      pslg.holes.push_back(middle);
      break;
    case 3:
      pslg.regions.push_back({middle, -1, *rc::gen::element(0.0, 1.0, -1.0)});
      break;
    case 4:
      add_copy(pslg, some_index(n - 1));
      break;
    case 5:
      pslg.segments.push_back({some_index(n), some_index(n), -1});
      break;
    case 6:
      if (!pslg.segments.empty()) pslg.segments.push_back(*rc::gen::elementOf(pslg.segments));
      break;
    default:
      if (!pslg.segments.empty()) pslg.segments.pop_back();
  }
}

PARDEL_PROPERTY(Decorated, domains_with_problems_have_the_same_problems_on_ranks,
                {.statement = "Make one to three mistakes in a domain: seeds at points or on segments, repeated points "
                              "and segments, missing ends, open outlines. One process, and one to four ranks that have "
                              "read parts of the domain, report the same problems in the same words, or make the same "
                              "mesh.",
                 .source = "distributed/distributed.hpp",
                 .families = "lattice domains of every family, with decorations; one to three mistakes"}) {
  Pslg pslg = to_pslg(some_case(exhibit).domain);
  for (int mistakes = *rc::gen::inRange(1, 4); mistakes > 0; --mistakes) spoil(pslg);
  exhibit.show(pslg);
  const Goal goal{.min_angle_deg = 20};
  const Options options{.threads = 1};
  const Result<Meshed> whole = mesh(pslg, goal, options);
  const int count = *rc::gen::inRange(1, 5);
  classify(!whole, "with problems", 70);
  if (whole) {
    const auto make = [&](pardel::Ranks& ranks) {
      return mesh(domains::equal_part(pslg, ranks), goal, options, ranks);
    };
    RC_ASSERT(difference_on_ranks(whole->mesh, count, make) == "");
    return;
  }
  std::vector<std::string> messages(count);
  on_ranks(count, [&](pardel::Ranks& ranks) {
    const Result<MeshPiece> piece = mesh(domains::equal_part(pslg, ranks), goal, options, ranks);
    messages[ranks.rank()] = piece ? "a mesh" : piece.error().message;
  });
  for (const std::string& message : messages) RC_ASSERT(message == whole.error().message);
}

}  // namespace
}  // namespace pardel::properties
