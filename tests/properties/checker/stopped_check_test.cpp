// The checker asks often whether it may go on, and ends at the first word. The tests count questions, not seconds.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

#include "../../../parallel/mesher.hpp"
#include "../../../properties/checker/check.hpp"
#include "../../../properties/checker/stages/faces_of_triangles.hpp"
#include "../../../properties/checker/stages/stages.hpp"
#include "../../../properties/domains/domains.hpp"

namespace pardel::checker {
namespace {

constexpr std::size_t most_steps_between_questions = 1024;

struct Case {
  Pslg pslg;
  Goal goal;
  Mesh mesh;
};

/// A comb has many segments, and its mesh has many boundary edges.
const Case& comb() {
  static const Case sample = [] {
    Case made{domains::comb(8000, 1e-4), {.min_angle_deg = 0}, {}};
    made.mesh = triangulate(made.pslg)->mesh;
    return made;
  }();
  return sample;
}

Scan scan_of(const Subject& subject, StopSignal* stop = nullptr) {
  return scan(subject.mesh.points.span(), subject.mesh.triangles.span(), bounds_of(subject), stop);
}

/// Runs stages on one thread, and stops them at question number `last`. Returns the number of questions.
std::size_t questions(const std::function<void(Findings&)>& stages,
                      std::size_t last = std::numeric_limits<std::size_t>::max()) {
  std::size_t asked = 0;
  StopSignal stop(StopSignal::unless([&] { return ++asked < last; }), std::chrono::seconds(0));
  Findings found(10, &stop);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  bool stopped = false;
  try {
    stages(found);
  } catch (const Stopped&) {
    stopped = true;
  }
  omp_set_num_threads(threads);
  EXPECT_EQ(stopped, asked == last);
  return asked;
}

/// Expects that the stages ask at least once in 1024 steps, and that they can be stopped at every question. `expected`
/// is the exact number of questions: each loop counts, so a loop that no longer asks lowers it.
void expect_stoppable(const std::function<void(Findings&)>& stages, std::size_t steps, std::size_t expected) {
  const std::size_t asked = questions(stages);
  EXPECT_GE(asked, steps / most_steps_between_questions);
  EXPECT_EQ(asked, expected);
  for (const std::size_t last : {std::size_t{1}, asked / 3, asked / 2, asked - 1, asked})
    EXPECT_EQ(questions(stages, last), last) << "no question after the answer that stops the check";
}

TEST(Checker, asks_once_in_1024_steps_in_the_topology_of_a_mesh) {
  const Pslg& pslg = comb().pslg;
  const Goal& goal = comb().goal;
  const Mesh& mesh = comb().mesh;
  const CheckOptions options;
  const Subject subject{pslg, mesh, goal, options};
  const std::size_t triangles = mesh.triangles.size(), edges = mesh.constrained_edges.size();
  const Scan scanned = scan_of(subject);
  expect_stoppable([&](Findings& found) { (void)scan_of(subject, found.stop()); }, triangles, 616);
  expect_stoppable([&](Findings& found) { (void)check_input(pslg, found); }, pslg.points.size() + pslg.segments.size(),
                   63);
  expect_stoppable([&](Findings& found) { (void)check_sanity(subject, scanned, found); }, edges, 32);
  const auto topology = [&](bool neighbours_usable, Findings& found) {
    Scan scan = scanned;
    (void)check_topology(subject, neighbours_usable, scan, found);
  };
  expect_stoppable([&](Findings& found) { topology(true, found); }, 4 * edges, 254);
  // Without usable neighbours, the half-edges are sorted.
  expect_stoppable([&](Findings& found) { topology(false, found); }, 20 * triangles, 2899);
}

TEST(Checker, asks_once_in_1024_steps_in_the_stages_that_use_the_domain) {
  const Pslg& pslg = comb().pslg;
  const Goal& goal = comb().goal;
  const Mesh& mesh = comb().mesh;
  const CheckOptions options;
  const Subject subject{pslg, mesh, goal, options};
  const std::size_t triangles = mesh.triangles.size(), points = mesh.points.size(),
                    edges = mesh.constrained_edges.size();
  Findings none(10);
  Scan scanned = scan_of(subject);
  const Adjacency adjacency = check_topology(subject, true, scanned, none);
  expect_stoppable([&](Findings& found) { const Domain domain(pslg, false, found.stop()); },
                   4 * pslg.segments.size() + 3 * pslg.points.size(), 657);
  const Domain domain(pslg, false);
  const InputVertices inputs = check_input_vertices(subject, domain, adjacency, none);
  expect_stoppable([&](Findings& found) { (void)check_segments(subject, domain, adjacency, inputs, scanned, found); },
                   2 * edges, 32653);
  const Chains chains = check_segments(subject, domain, adjacency, inputs, scanned, none);
  expect_stoppable([&](Findings& found) { (void)check_coverage(subject, domain, adjacency, chains, found); },
                   triangles + 8 * edges, 5262);
  expect_stoppable([&](Findings& found) { (void)paint_faces(domain, adjacency, chains, found.stop()); }, triangles, 32);
  expect_stoppable([&](Findings& found) { check_labels(subject, domain, adjacency, chains, inputs, found); },
                   2 * points + 2 * edges, 4445);
  expect_stoppable([&](Findings& found) { check_delaunay(subject, adjacency, chains, scanned, found); },
                   scanned.open.size(), 8);

  // The first goal has no bounds, so it leaves nothing to decide. These bounds are missed by many triangles.
  const Goal strict{.min_angle_deg = 20, .size = [](Point) { return 0.5; }};
  const Subject bounded{pslg, mesh, strict, options};
  const Scan open = scan_of(bounded);
  std::vector<Justified> justified;
  expect_stoppable(
      [&](Findings& found) { check_goal(bounded, domain, adjacency, chains, inputs, {}, open, found, justified); },
      open.open.size() + triangles, 64);
}

TEST(Checker, asks_once_in_1024_steps_where_a_file_has_another_order_and_no_constrained_edges) {
  const auto& [pslg, goal, mesh] = comb();
  Mesh file = mesh;
  file.constrained_edges.clear();
  file.origin.clear();
  std::swap(file.points[0], file.points[1]);
  for (Triangle& triangle : file.triangles)
    for (Index& v : triangle.v) v = v == 0 ? 1 : v == 1 ? 0 : v;
  const CheckOptions options{.foreign = true};
  const Subject subject{pslg, file, goal, options};
  Findings none(10);
  Scan scanned = scan_of(subject);
  const Adjacency adjacency = check_topology(subject, true, scanned, none);
  const Domain domain(pslg, false);
  expect_stoppable([&](Findings& found) { (void)check_input_vertices(subject, domain, adjacency, found); },
                   3 * file.points.size(), 640);
  const InputVertices inputs = check_input_vertices(subject, domain, adjacency, none);
  expect_stoppable([&](Findings& found) { (void)check_segments(subject, domain, adjacency, inputs, scanned, found); },
                   file.triangles.size() + pslg.segments.size(), 33495);
}

/// The numbers of questions of all stages on a small mesh. Each loop asks at its begin.
std::vector<std::size_t> questions_of_stages(const Pslg& pslg, const Goal& goal, bool foreign) {
  Mesh mesh = pardel::mesh(pslg, goal, {.threads = 1})->mesh;
  if (foreign) {
    mesh.constrained_edges.clear();
    mesh.origin.clear();
    mesh.triangles.push_back(mesh.triangles[0]);  // edges with three triangles
    if (!mesh.region.empty()) mesh.region.push_back(mesh.region[0]);
  }
  const CheckOptions options{.foreign = foreign};
  const Subject subject{pslg, mesh, goal, options};
  Findings none(10);
  Scan scanned = scan_of(subject);
  const Scan unused = scanned;
  const Adjacency adjacency = check_topology(subject, !foreign, scanned, none);
  const Domain domain(pslg, goal.convex_hull);
  const InputVertices inputs = check_input_vertices(subject, domain, adjacency, none);
  const Chains chains = check_segments(subject, domain, adjacency, inputs, scanned, none);
  const std::vector<Index> faces = paint_faces(domain, adjacency, chains, none.stop());
  std::vector<Justified> justified;
  return {questions([&](Findings& found) { (void)scan_of(subject, found.stop()); }),
          questions([&](Findings& found) { (void)check_input(pslg, found); }),
          questions([&](Findings& found) { (void)check_sanity(subject, unused, found); }),
          questions([&](Findings& found) {
            Scan scan = unused;
            (void)check_topology(subject, !foreign, scan, found);
          }),
          questions([&](Findings& found) { const Domain again(pslg, goal.convex_hull, found.stop()); }),
          questions([&](Findings& found) { (void)check_input_vertices(subject, domain, adjacency, found); }),
          questions([&](Findings& found) { (void)check_segments(subject, domain, adjacency, inputs, scanned, found); }),
          questions([&](Findings& found) { (void)check_coverage(subject, domain, adjacency, chains, found); }),
          questions([&](Findings& found) { (void)paint_faces(domain, adjacency, chains, found.stop()); }),
          questions([&](Findings& found) { check_labels(subject, domain, adjacency, chains, inputs, found); }),
          questions([&](Findings& found) { check_regions(subject, domain, faces, found); }),
          questions([&](Findings& found) { check_delaunay(subject, adjacency, chains, scanned, found); }),
          questions([&](Findings& found) {
            check_goal(subject, domain, adjacency, chains, inputs, faces, scanned, found, justified);
          })};
}

/// A polygon of so many sides around a hole that lies on the right of its lowest corner. No walk down from there counts
/// the loops, so the components, fans and loops of the mesh are counted one by one.
Pslg polygon_with_a_hole_that_leans(int sides) {
  Pslg pslg;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    pslg.points.push_back({std::cos(angle), std::sin(angle)});
  }
  pslg.points.insert(pslg.points.end(), {{0, 0}, {0.1, 0.05}, {0.1, 0.2}});
  const auto n = static_cast<Index>(sides);
  for (Index i = 0; i < n; ++i) pslg.segments.push_back({i, (i + 1) % n});
  for (const auto& [from, to] : {std::pair{n, n + 1}, {n + 1, n + 2}, {n + 2, n}}) pslg.segments.push_back({from, to});
  pslg.holes = {{0.08, 0.09}};
  return pslg;
}

TEST(Checker, asks_at_the_begin_of_each_loop) {
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(questions_of_stages(domains::comb(3, 0.05), {}, false), (Counts{3, 1, 1, 6, 2, 2, 20, 14, 1, 5, 0, 0, 0}));
  EXPECT_EQ(questions_of_stages(domains::comb(3, 0.05), {.grading = 0.5, .feature_edges = 1}, true),
            (Counts{4, 1, 0, 22, 2, 2, 21, 15, 1, 4, 0, 0, 2}));
  EXPECT_EQ(questions_of_stages(domains::regions(), {.max_area = 0.1, .region_caps = true}, false),
            (Counts{3, 1, 2, 6, 2, 2, 15, 16, 1, 6, 1, 1, 1}));
  EXPECT_EQ(questions_of_stages(domains::regions(), {.max_area = 0.1, .grading = 0.25}, true),
            (Counts{3, 1, 1, 13, 2, 2, 16, 12, 1, 2, 1, 1, 2}));
  EXPECT_EQ(questions_of_stages(domains::cracks(), {.convex_hull = true}, true),
            (Counts{3, 1, 0, 14, 5, 2, 18, 12, 1, 2, 0, 0, 0}));
  EXPECT_EQ(questions_of_stages(domains::touching_holes(), {}, false),
            (Counts{3, 1, 1, 6, 2, 2, 22, 14, 1, 5, 0, 0, 0}));
}

TEST(Checker, asks_once_in_1024_steps_of_each_stage) {
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(questions_of_stages(domains::comb(1100, 1e-4), {.min_angle_deg = 0}, false),
            (Counts{72, 9, 5, 38, 80, 10, 4485, 622, 5, 523, 0, 2, 0}));
  EXPECT_EQ(questions_of_stages(domains::comb(1100, 1e-4), {.min_angle_deg = 0}, true),
            (Counts{75, 9, 0, 341, 80, 10, 4581, 506, 5, 353, 0, 2, 0}));
  EXPECT_EQ(questions_of_stages(polygon_with_a_hole_that_leans(5000), {.min_angle_deg = 0}, false),
            (Counts{81, 10, 5, 50, 94, 10, 5089, 474, 5, 248, 0, 0, 0}));
}

/// A square with a hole that has these corners, counter-clockwise, and that contains (5, 5.5).
Pslg square_with_hole(const std::vector<Point>& hole, bool hole_first) {
  Pslg pslg;
  const auto add_loop = [&](const std::vector<Point>& corners) {
    const auto first = static_cast<Index>(pslg.points.size()), n = static_cast<Index>(corners.size());
    for (Index i = 0; i < n; ++i) {
      pslg.points.push_back(corners[i]);
      pslg.segments.push_back({first + i, first + (i + 1) % n, 0});
    }
  };
  if (hole_first) add_loop(hole);
  add_loop({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  if (!hole_first) add_loop(hole);
  pslg.holes = {{5, 5.5}};
  return pslg;
}

// A walk down from a hole finds that the loops of the hole and of the square belong to one component. Without it, the
// checker visits all triangles, and asks once more.
TEST(Checker, joins_a_hole_to_the_outline_wherever_the_vertices_of_its_loop_begin) {
  const std::vector<std::vector<Point>> holes{
      {{4, 4}, {6, 6}, {4, 6}},
      {{6, 4}, {6, 6}, {4, 6}},
      {{5, 4}, {6, 6}, {4, 6}},
      {{6, 4}, {5, 6}, {4, 5}},
      {{4, 4}, {6, 4}, {6, 6}, {4, 6}},
      {{6, 4}, {5, 6}, {9, 6}, {9, 8}, {3, 8}, {3, 5}},  // a part of the hole lies above its lowest vertex
  };
  for (std::vector<Point> hole : holes)
    for (std::size_t turn = 0; turn < hole.size(); ++turn) {
      std::rotate(hole.begin(), hole.begin() + 1, hole.end());
      for (const bool hole_first : {false, true}) {
        const auto counts = questions_of_stages(square_with_hole(hole, hole_first), {.min_angle_deg = 0}, false);
        EXPECT_EQ(counts[3], 6U) << "from (" << hole[0].x << ", " << hole[0].y << ")";
      }
    }
}

TEST(Checker, examines_no_triangle_after_the_word) {
  const Pslg pslg = domains::square();
  const Mesh mesh = pardel::mesh(pslg, {.max_area = 3e-4}, {.threads = 1})->mesh;
  ASSERT_GT(mesh.triangles.size(), 4000U);
  std::size_t examined = 0;
  const Goal goal{.size = [&](Point) {
    ++examined;
    return 1.0;
  }};
  const CheckOptions options;
  const Subject subject{pslg, mesh, goal, options};
  Findings none(10);
  Scan scanned = scan_of(subject);
  const Adjacency adjacency = check_topology(subject, true, scanned, none);
  const Domain domain(pslg, false);
  const InputVertices inputs = check_input_vertices(subject, domain, adjacency, none);
  const Chains chains = check_segments(subject, domain, adjacency, inputs, scanned, none);
  std::vector<Justified> justified;
  const auto stage = [&](Findings& found) {
    check_goal(subject, domain, adjacency, chains, inputs, {}, scanned, found, justified);
  };
  EXPECT_EQ(questions(stage, 3), 3U);
  EXPECT_EQ(examined, 2048U);
}

TEST(Checker, that_its_caller_stops_says_so_and_gives_no_verdict) {
  const auto& [pslg, goal, mesh] = comb();
  for (const int last : {1, 2, 3}) {
    int asked = 0;
    const Certificate certificate = check(pslg, mesh, goal, {.go_on = [&] { return ++asked < last; }});
    EXPECT_TRUE(certificate.cancelled);
    EXPECT_FALSE(certificate.valid);
    EXPECT_EQ(asked, last) << "the caller is not asked again";
    EXPECT_TRUE(to_text(certificate).starts_with("cancelled: "));
    EXPECT_NE(to_json(certificate).find(R"("cancelled": true)"), std::string::npos);
  }
}

TEST(Checker, that_its_caller_does_not_stop_gives_the_same_certificate) {
  const auto& [pslg, goal, mesh] = comb();
  const Certificate asked = check(pslg, mesh, goal, {.go_on = [] { return true; }});
  EXPECT_TRUE(asked.valid);
  EXPECT_FALSE(asked.cancelled);
  EXPECT_EQ(to_json(asked), to_json(check(pslg, mesh, goal)));
}

}  // namespace
}  // namespace pardel::checker
