// A test of the user (Goal::user_test): what it is asked, and what the meshes and the reports say about it.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../core/join_pieces.hpp"
#include "../../../core/support/point_order.hpp"
#include "../../../distributed/distributed.hpp"
#include "../../../ref/ruppert.hpp"
#include "../framework/local_ranks.hpp"
#include "../framework/shares.hpp"
#include "meshing.hpp"
#include "refined_channels.hpp"

namespace pardel::properties {
namespace {

using Corners = std::array<Point, 3>;

constexpr const char* test_source = "core/goal.hpp, Goal::user_test";
constexpr const char* test_families =
    "lattice domains of every family, random goals; tests that compare areas, longest edges or shapes with a bound "
    "that depends on the place, or on which corner is the first one";

double longest_edge(const Corners& p) {
  const auto length = [&](int i, int j) { return std::hypot(p[i].x - p[j].x, p[i].y - p[j].y); };
  return std::max({length(0, 1), length(1, 2), length(2, 0)});
}

/// A pure test under which a domain of this extent, around this place, gets up to some thousands of triangles.
UserTest some_test(double extent, Point place) {
  const int kind = *rc::gen::inRange(0, 4);
  const double length = extent / *rc::gen::inRange(4, 24), growth = 0.1 * *rc::gen::inRange(0, 10);
  const auto allowed = [=](const Corners& p) {
    return length + growth * std::hypot(p[0].x - place.x, p[0].y - place.y);
  };
  const auto half_square = [](double side) { return side * side / 2; };
  if (kind == 0) return [=](const Corners& p, double area) { return area > half_square(allowed(p)); };
  if (kind == 1) return [=](const Corners& p, double) { return longest_edge(p) > allowed(p); };
  if (kind == 2)
    return [=](const Corners& p, double area) {
      return area > half_square(length) && area < 0.4 * longest_edge(p) * longest_edge(p);
    };
  return [=](const Corners& p, double area) {
    const bool is_left = std::fmod(std::floor(p[0].x / length), 2) == 0;
    return area > half_square(is_left ? length / 2 : length);
  };
}

Problem some_tested_problem(Exhibit& exhibit) {
  Problem problem = some_problem(exhibit);
  problem.goal.user_test = some_test(extent_of(problem.pslg), problem.pslg.points.front());
  problem.goal.user_test_is_free_of_state = *rc::gen::arbitrary<bool>();
  return problem;
}

std::uint64_t failures(const Certificate& certificate) {
  return certificate.violation_counts[static_cast<std::size_t>(ViolationKind::user_test)];
}

PARDEL_PROPERTY(UserTest, is_true_for_no_triangle_but_those_that_the_report_counts,
                {.statement = "The checker finds the test true for as many triangles as the report says, and each of "
                              "them is exempt, for a reason that is no small input angle. Without limits on vertices "
                              "and edges there are none, and the checker certifies the mesh.",
                 .source = test_source,
                 .families = test_families}) {
  const Problem problem = some_tested_problem(exhibit);
  Options options = some_options();
  const int limit = *rc::gen::inRange(0, 4);
  if (limit == 1) options.max_vertices = problem.pslg.points.size() + *rc::gen::inRange<std::size_t>(1, 60);
  if (limit == 2) options.min_edge = extent_of(problem.pslg) / *rc::gen::inRange(4, 20);
  const Meshed made = meshed(problem, exhibit, options);
  const Certificate certificate = check(problem.pslg, made.mesh, problem.goal, {.max_violations = 1'000'000});
  classify(failures(certificate) > 0, "triangles are left", 10);
  RC_ASSERT(made.report.fail_user_test == failures(certificate));
  std::set<Index> exempt;
  for (const Exemption& e : made.report.exempt)
    if (!justified(e.reason)) exempt.insert(e.triangle);
  for (const Violation& v : certificate.violations)
    if (v.kind == ViolationKind::user_test) RC_ASSERT(exempt.contains(v.ids.front()));
  if (limit == 0 || limit == 3) require_valid(certificate);
}

PARDEL_PROPERTY(UserTest, gets_the_corners_from_the_least_one_with_their_area,
                {.statement = "Whoever asks the test, the mesher or the checker, the corners are counter-clockwise, "
                              "the first one is the least in lexicographic order, and the area is half the cross "
                              "product of the sides there. The checker asks once about each triangle.",
                 .source = test_source,
                 .families = test_families}) {
  Problem problem = some_tested_problem(exhibit);
  problem.goal.user_test_is_free_of_state = false;
  std::uint64_t asked = 0;
  bool is_right = true;
  problem.goal.user_test = [&, test = problem.goal.user_test](const Corners& p, double area) {
    ++asked;
    const double twice = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    is_right = is_right && lexicographically_less(p[0], p[1]) && lexicographically_less(p[0], p[2]) && area >= 0 &&
               area == std::max(0.0, twice / 2);
    return test(p, area);
  };
  const Meshed made = meshed(problem, exhibit, some_options());
  RC_ASSERT(is_right);
  RC_ASSERT(asked > 0U);
  asked = 0;
  require_valid(check(problem.pslg, made.mesh, problem.goal));
  RC_ASSERT(is_right);
  RC_ASSERT(asked == made.mesh.triangles.size());
}

PARDEL_PROPERTY(UserTest, makes_one_mesh_on_any_number_of_threads,
                {.statement = "The mesh is the same on one to four threads, whether the test is declared to be free "
                              "of state or not. If not, only the calling thread asks it.",
                 .source = test_source,
                 .families = test_families}) {
  Problem problem = some_tested_problem(exhibit);
  Options options = some_options();
  options.triangles_per_tile = 4;
  problem.goal.user_test_is_free_of_state = true;
  options.threads = *rc::gen::inRange(1, 5);
  const Digest expected = digest(meshed(problem, exhibit, options).mesh);
  options.threads = *rc::gen::inRange(1, 5);
  RC_ASSERT(digest(meshed(problem, exhibit, options).mesh) == expected);
  problem.goal.user_test_is_free_of_state = false;
  options.threads = 4;
  std::atomic<bool> asked_by_another = false;
  const std::thread::id caller = std::this_thread::get_id();
  problem.goal.user_test = [&, test = problem.goal.user_test](const Corners& p, double area) {
    if (std::this_thread::get_id() != caller) asked_by_another = true;
    return test(p, area);
  };
  RC_ASSERT(digest(meshed(problem, exhibit, options).mesh) == expected);
  RC_ASSERT(!asked_by_another);
}

PARDEL_PROPERTY(UserTest, makes_one_mesh_on_any_number_of_ranks,
                {.statement = "Two to four ranks make the mesh of one process, and all of them report the same number "
                              "of triangles for which the test is true.",
                 .source = test_source,
                 .families = test_families}) {
  Problem problem = some_tested_problem(exhibit);
  problem.goal.user_test_is_free_of_state = true;  // the ranks are threads here
  Options options = some_options();
  options.triangles_per_tile = 10;
  if (*rc::gen::arbitrary<bool>()) options.min_edge = extent_of(problem.pslg) / *rc::gen::inRange(4, 20);
  const ValidPslg domain = std::move(validate(problem.pslg)).value();
  const Meshed alone = value_of(mesh(domain, problem.goal, options));
  std::vector<NumberedMesh> pieces(*rc::gen::inRange<std::size_t>(2, 5));
  std::atomic<bool> is_one_number = true;
  on_ranks(static_cast<int>(pieces.size()), [&](pardel::Ranks& ranks) {
    Result<MeshPiece> piece = mesh(domain, problem.goal, options, ranks);
    if (!piece) return;
    if (piece->report.fail_user_test != alone.report.fail_user_test) is_one_number = false;
    pieces[static_cast<std::size_t>(ranks.rank())] = {std::move(piece->mesh), std::move(piece->number)};
  });
  std::erase_if(pieces, [](const NumberedMesh& piece) { return piece.mesh.points.empty(); });
  const Result<Mesh> joined = join_pieces(pieces);
  RC_ASSERT(joined.ok());
  RC_ASSERT(is_one_number);
  RC_ASSERT(digest(*joined) == digest(alone.mesh));
}

PARDEL_PROPERTY(UserTest, is_met_by_refining_a_mesh_and_then_changes_nothing,
                {.statement = "A mesh is made without the test, and refined with it: the checker certifies the result, "
                              "and refining it again changes nothing.",
                 .source = test_source,
                 .families = test_families}) {
  Problem problem = some_tested_problem(exhibit);
  problem.goal.region_caps = false;  // a Mesh does not store area caps
  Goal without = problem.goal;
  without.user_test = {};
  const Options options = some_options();
  const Meshed coarse = meshed({problem.pslg, without}, exhibit, options);
  const Meshed fine = value_of(refine(coarse.mesh, {}, problem.goal, options));
  classify(fine.report.inserted + fine.report.segment_splits > 0, "the test refines", 50);
  require_valid(check(problem.pslg, fine.mesh, problem.goal));
  const Meshed again = value_of(refine(fine.mesh, {}, problem.goal, options));
  RC_ASSERT(again.report.inserted + again.report.segment_splits == 0U);
  RC_ASSERT(digest(again.mesh) == digest(fine.mesh));
}

PARDEL_PROPERTY(UserTest, is_met_by_the_reference_too,
                {.statement = "Ruppert's algorithm on exact coordinates, with the test, makes a mesh that the checker "
                              "certifies for it.",
                 .source = test_source,
                 .families = "channels; tests on areas and longest edges"}) {
  const Channel channel = some_channel(exhibit);
  const Pslg pslg = to_pslg(channel);
  Goal goal = coarse_goal_of(channel);
  const double length = extent_of(pslg) / *rc::gen::inRange(2, 8);
  goal.user_test = [=](const Corners& p, double area) {
    return area > length * length / 4 || longest_edge(p) > length;
  };
  const Result<Mesh> made = ref::ruppert(pslg, goal);
  RC_ASSERT(made.ok());
  require_valid(check(pslg, *made, goal));
}

}  // namespace
}  // namespace pardel::properties
