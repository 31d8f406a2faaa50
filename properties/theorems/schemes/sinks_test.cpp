// Sink insertion (Edelsbrunner and Guoy).
#include "../../../ref/schemes/sinks.hpp"

#include "../../../ref/definitions.hpp"
#include "../../domains/domains.hpp"
#include "same_triangles.hpp"
#include "some_problem.hpp"

namespace pardel::properties {
namespace {

using schemes::Independence;
using schemes::LinkedMesh;

constexpr const char* sink_insertion_paper = "Edelsbrunner, Guoy 2001, section 3";

ref::Number squared_radius_of(const LinkedMesh& mesh, Index t) {
  return CGAL::squared_radius(ref::exact(mesh.corner(t, 0)), ref::exact(mesh.corner(t, 1)),
                              ref::exact(mesh.corner(t, 2)));
}

bool contains_its_centre(const LinkedMesh& mesh, Index t) {
  const ref::ExactPoint a = ref::exact(mesh.corner(t, 0)), b = ref::exact(mesh.corner(t, 1)),
                        c = ref::exact(mesh.corner(t, 2));
  return !ref::Kernel::Triangle_2(a, b, c).has_on_unbounded_side(CGAL::circumcenter(a, b, c));
}

/// A triangulation, refined a little.
LinkedMesh some_mesh(const SchemeCase& c) {
  schemes::Start start = some_start(c);
  schemes::refine_sequentially(start.mesh, start.bounds, c.pslg.points.size() + *rc::gen::inRange<std::size_t>(0, 20));
  schemes::compact(start.mesh);
  return start.mesh;
}

/// The triangles that contain their circumcentres, each with the insertion of its centre.
std::vector<schemes::Insertion> sinks_of(const LinkedMesh& mesh) {
  std::vector<schemes::Insertion> found;
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    if (schemes::flow(mesh, t)) continue;
    const Point centre = schemes::circumcentre(mesh, t);
    found.push_back({t, centre, {}, schemes::cavity_of(mesh, centre, {t})});
  }
  return found;
}

PARDEL_PROPERTY(Sinks, every_run_is_certified,
                {.statement = "Rounds of independent sinks end with a mesh that the checker certifies.",
                 .source = sink_insertion_paper,
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const schemes::Outcome outcome =
      required(schemes::sinks(c.problem(), *rc::gen::element(Independence::closures, Independence::exact)));
  certify(outcome.mesh, c, exhibit);
}

PARDEL_PROPERTY(Sinks, radii_do_not_decrease_along_a_walk,
                {.statement = "In a constrained Delaunay mesh, the circumradius of the triangle to which a triangle "
                              "flows is at least as large as its own. Equal radii mean equal centres.",
                 .source = sink_insertion_paper,
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const LinkedMesh mesh = some_mesh(c);
  std::size_t longest = 0;
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    const std::vector<Index> walk = schemes::walk_to_sink(mesh, t);
    longest = std::max(longest, walk.size());
    for (std::size_t k = 1; k < walk.size(); ++k)
      RC_ASSERT(squared_radius_of(mesh, walk[k - 1]) <= squared_radius_of(mesh, walk[k]));
  }
  classify(longest > 1, "a walk of at least one step", 70);
  classify(longest > 3, "a walk of more than two steps", 5);
}

PARDEL_PROPERTY(Sinks, a_walk_ends_in_a_sink_or_at_a_segment,
                {.statement = "The last triangle of a walk contains its circumcentre, or a segment separates them. "
                              "No walk crosses a segment.",
                 .source = sink_insertion_paper,
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const LinkedMesh mesh = some_mesh(c);
  bool at_a_segment = false, in_a_sink = false;
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    const std::vector<Index> walk = schemes::walk_to_sink(mesh, t);
    for (std::size_t k = 1; k < walk.size(); ++k)
      RC_ASSERT(!schemes::is_constrained(mesh, schemes::flow(mesh, walk[k - 1]).value()));
    const Index last = walk.back();
    const auto side = schemes::flow(mesh, last);
    RC_ASSERT(contains_its_centre(mesh, last) == !side.has_value());
    if (side) RC_ASSERT(schemes::is_constrained(mesh, *side));
    at_a_segment = at_a_segment || side;
    in_a_sink = in_a_sink || !side;
  }
  classify(at_a_segment, "a segment stops a walk", 50);
  classify(in_a_sink, "a walk ends in a sink", 50);
}

PARDEL_PROPERTY(Sinks, a_new_vertex_is_as_far_from_all_others_as_the_sink_is_large,
                {.statement = "The centre of a sink is at least as far from every vertex that it sees as the bad "
                              "triangle's own circumradius, so sinks make no shorter edges than circumcentres do.",
                 .source = sink_insertion_paper,
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const LinkedMesh mesh = some_mesh(c);
  bool moved = false;
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    const std::vector<Index> walk = schemes::walk_to_sink(mesh, t);
    if (schemes::flow(mesh, walk.back())) continue;
    moved = moved || walk.size() > 1;
    const ref::ExactPoint centre =
        CGAL::circumcenter(ref::exact(mesh.corner(walk.back(), 0)), ref::exact(mesh.corner(walk.back(), 1)),
                           ref::exact(mesh.corner(walk.back(), 2)));
    for (const Index other :
         schemes::cavity_of(mesh, schemes::circumcentre(mesh, walk.back()), {walk.back()}).triangles)
      for (int i = 0; i < 3; ++i)
        RC_ASSERT(CGAL::squared_distance(centre, ref::exact(mesh.corner(other, i))) >= squared_radius_of(mesh, t));
  }
  classify(moved, "a sink other than the triangle itself", 40);
}

PARDEL_PROPERTY(Sinks, the_centre_of_the_sink_is_inserted,
                {.statement = "For a bad triangle, the centre of the sink at the end of its walk is inserted, or a "
                              "segment is split.",
                 .source = sink_insertion_paper,
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const schemes::Start start = some_start(c);
  bool moved = false;
  for (Index t = 0; t < start.mesh.faces.size(); ++t) {
    std::uint64_t read = 0;
    const auto insertion = schemes::sink_insertion(start.mesh, t, start.bounds, read);
    if (!insertion || insertion->splits_segment()) continue;
    const std::vector<Index> walk = schemes::walk_to_sink(start.mesh, t);
    RC_ASSERT(insertion->point == schemes::circumcentre(start.mesh, walk.back()));
    RC_ASSERT(read == walk.size());
    moved = moved || walk.size() > 1;
  }
  classify(moved, "a sink other than the triangle itself", 4);
}

PARDEL_PROPERTY(Sinks, the_mesh_does_not_depend_on_workers,
                {.statement = "Any number of workers makes the same mesh.",
                 .source = "ref/schemes/rounds/in_rounds.hpp",
                 .families = scheme_families}) {
  SchemeCase c = some_scheme_case(exhibit);
  const schemes::Outcome many = required(schemes::sinks(c.problem()));
  c.workers = 1;
  RC_ASSERT(placed_triangles(required(schemes::sinks(c.problem())).mesh) == placed_triangles(many.mesh));
}

PARDEL_FACT(Sinks, a_right_triangle_is_a_sink,
            {.statement = "The two right triangles of a square have one circumcentre, on their common side. Both walks "
                          "end where they begin.",
             .source = sink_insertion_paper,
             .families = "stored witness: the square"}) {
  const Pslg square = domains::square();
  const auto start = schemes::start_of({square, Goal{.min_angle_deg = 0}});
  ASSERT_TRUE(start);
  for (const Index t : {Index{0}, Index{1}}) {
    ASSERT_FALSE(schemes::flow(start->mesh, t).has_value());
    EXPECT_EQ(schemes::walk_to_sink(start->mesh, t), std::vector<Index>{t});
  }
  facts.cases = 1;
}

PARDEL_FACT(Sinks, sinks_may_be_arbitrarily_close,
            {.statement = "Two triangles that are nearly right have a common longest side. Both are sinks, and their "
                          "centres are closer than 1/500 of their circumradii: sinks alone are not apart.",
             .source = sink_insertion_paper,
             .families = "stored witness: a kite"}) {
  constexpr double beyond = 0x1p-12;
  Pslg kite;
  kite.points = {{-beyond, -beyond}, {1, 0}, {1 + beyond, 1 + beyond}, {0, 1}};
  const auto start = schemes::start_of({kite, Goal{.min_angle_deg = 0}});
  ASSERT_TRUE(start);
  const std::vector<schemes::Insertion> sinks = sinks_of(start->mesh);
  ASSERT_EQ(sinks.size(), 2U);
  const Point p = sinks[0].point, q = sinks[1].point;
  EXPECT_LT(std::hypot(p.x - q.x, p.y - q.y) * 500, std::sqrt(0.5));
  EXPECT_FALSE(schemes::are_independent(start->mesh, sinks[0], sinks[1], Independence::closures));
  EXPECT_FALSE(schemes::are_independent(start->mesh, sinks[0], sinks[1], Independence::exact));
  facts.cases = 1;
}

PARDEL_FACT(Sinks, different_sinks_may_share_a_triangle,
            {.statement = "Cavities of the centres of different sinks share triangles, also in meshes of random "
                          "points. So a set of sinks has to be chosen like a set of circumcentres.",
             .source = sink_insertion_paper,
             .families = "100 sets of 30 random points"}) {
  std::uint64_t pairs = 0, sharing = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed, ++facts.cases) {
    const Pslg points = domains::random_points(30, seed);
    const auto start = schemes::start_of({points, Goal{.min_angle_deg = 0}});
    ASSERT_TRUE(start);
    const std::vector<schemes::Insertion> sinks = sinks_of(start->mesh);
    for (std::size_t p = 0; p < sinks.size(); ++p)
      for (std::size_t q = 0; q < p; ++q) {
        ++pairs;
        const auto in_p = [&](Index t) { return std::ranges::count(sinks[p].cavity.triangles, t) > 0; };
        sharing += std::ranges::any_of(sinks[q].cavity.triangles, in_p) ? 1 : 0;
      }
  }
  EXPECT_GT(sharing * 50, pairs);
  facts.notes.push_back(std::to_string(sharing) + " of " + std::to_string(pairs) + " pairs of sinks share a triangle");
}

}  // namespace
}  // namespace pardel::properties
