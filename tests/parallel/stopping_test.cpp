// Every stage of a run asks often whether it may go on, and ends at the first word. The tests count questions and
// insertions, not seconds.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <optional>

#include "../../parallel/construction/carve.hpp"
#include "../../parallel/construction/delaunay.hpp"
#include "../../parallel/construction/insert_constraints.hpp"
#include "../../parallel/conversion/export_mesh.hpp"
#include "../../parallel/conversion/import_mesh.hpp"
#include "../../parallel/domain/find_problems.hpp"
#include "../../parallel/domain/untangle.hpp"
#include "../../parallel/mesher.hpp"
#include "../../parallel/repair.hpp"
#include "../../parallel/sizes.hpp"
#include "../../properties/domains/domains.hpp"

namespace pardel::engine {
namespace {

constexpr std::size_t most_steps_between_questions = 1024;
constexpr std::size_t many = 40'000;

/// Runs a stage on one thread, and stops it at question number `last`. Returns the number of questions asked.
std::size_t questions(const std::function<void(const Threads&)>& stage,
                      std::size_t last = std::numeric_limits<std::size_t>::max()) {
  std::size_t asked = 0;
  StopSignal stop(
      [&]() -> std::optional<Error> {
        if (++asked < last) return {};
        return Error{ErrorKind::cancelled, "stop"};
      },
      std::chrono::seconds(0));
  bool stopped = false;
  try {
    stage(Threads(1, &stop));
  } catch (const Stopped&) {
    stopped = true;
  }
  EXPECT_EQ(stopped, asked == last);
  return asked;
}

/// Expects that the stage asks at least once in 1024 steps, and that it can be stopped at every question.
void expect_stoppable(const std::function<void(const Threads&)>& stage, std::size_t steps) {
  const std::size_t asked = questions(stage);
  EXPECT_GE(asked, steps / most_steps_between_questions);
  for (const std::size_t last : {std::size_t{1}, asked / 3, asked / 2, asked - 1, asked})
    EXPECT_EQ(questions(stage, last), last) << "no question after the answer that stops the run";
}

TEST(Validation, asks_once_in_1024_steps_and_stops_at_the_first_word) {
  for (const Pslg& pslg : {domains::random_points(many, 3), domains::comb(many / 8, 1e-4)}) {
    const auto stage = [&](const Threads& threads) { (void)find_problems(pslg, {.convex_hull = true}, threads); };
    expect_stoppable(stage, 3 * pslg.points.size() + 5 * pslg.segments.size());
  }
}

TEST(Validation, that_its_caller_stops_returns_this_as_its_only_problem) {
  const Pslg pslg = domains::random_points(many, 3);
  const std::vector<Problem> problems = find_problems(pslg, {.go_on = [] { return false; }});
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].kind, ProblemKind::cancelled);
  EXPECT_TRUE(find_problems(pslg, {.go_on = [] { return true; }}).empty());
}

/// A grid of squares with crossing diagonals, and many equal points.
Pslg tangle() {
  constexpr Index side = 150;
  Pslg pslg;
  for (Index y = 0; y <= side; ++y)
    for (Index x = 0; x <= side; ++x) pslg.points.push_back({double(x), double(y)});
  for (Index y = 0; y < side; ++y)
    for (Index x = 0; x < side; ++x) {
      const Index corner = y * (side + 1) + x;
      pslg.segments.push_back({corner, corner + side + 2, 0});
      pslg.segments.push_back({corner + 1, corner + side + 1, 0});
    }
  const std::vector<Point> again(pslg.points.begin(), pslg.points.begin() + side * side / 2);
  pslg.points.insert(pslg.points.end(), again.begin(), again.end());
  return pslg;
}

/// Repairs a domain and says stop at question number `last`. Returns the error and the number of questions.
std::pair<std::optional<Error>, std::size_t> repair_with_stop_at(const Pslg& pslg, std::size_t last) {
  std::size_t asked = 0;
  const auto go_on = [&] { return ++asked < last; };
  const Result<Repaired> repaired = repair(pslg, {.snap = 0, .convex_hull = true, .go_on = go_on});
  return {repaired ? std::nullopt : std::optional(repaired.error()), asked};
}

TEST(Repair, that_its_caller_stops_returns_at_the_first_word) {
  const Pslg pslg = tangle();
  for (const std::size_t last : {1U, 2U, 3U, 5U}) {
    const auto [error, asked] = repair_with_stop_at(pslg, last);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind, ErrorKind::cancelled);
    EXPECT_EQ(asked, last) << "no question after the answer that stops the repair";
  }
}

TEST(Repair, untangles_with_a_question_in_1024_steps) {
  const Pslg pslg = tangle();
  const auto stage = [&](const Threads& threads) {
    Work work{pslg, std::vector<Index>(pslg.points.size()), std::vector<Index>(pslg.segments.size())};
    for (const double snap : {0.0, 1e-9}) EXPECT_TRUE(untangle(work, snap, *threads.stop));
  };
  expect_stoppable(stage, 4 * (pslg.points.size() + 2 * pslg.segments.size()));
}

TEST(Triangulation, of_points_asks_once_in_1024_steps_and_stops_at_the_first_word) {
  const Pslg pslg = domains::random_points(many, 4);
  // Each point is ordered along the curve (three passes), assigned to a tile, and inserted.
  expect_stoppable([&](const Threads& threads) { (void)delaunay(pslg.points, threads); }, 5 * many);
}

TEST(Segments, are_inserted_with_a_question_in_1024_steps) {
  const Pslg pslg = domains::comb(many / 8, 1e-4);
  const Result<Delaunay> made = delaunay(pslg.points);
  ASSERT_TRUE(made);
  std::vector<VertexId> vertex(pslg.points.size());
  for (VertexId v = 0; v < vertex.size(); ++v) vertex[made->input_of_vertex[v]] = v;
  std::vector<Constraint> constraints;
  for (const Segment& s : pslg.segments) constraints.push_back({vertex[s.a], vertex[s.b]});
  const auto stage = [&](const Threads& threads) {
    Triangulation t = made->triangulation;
    EXPECT_TRUE(insert_constraints(t, constraints, threads));
  };
  expect_stoppable(stage, made->triangulation.slots.size() + constraints.size());
}

TEST(Segments, that_cross_the_whole_mesh_are_inserted_with_questions_on_the_way) {
  std::vector<Point> points;
  for (int i = 0; i < 3000; ++i)
    points.insert(points.end(), {{double(i), 1.0 + i % 7}, {double(i) + 0.5, -1.0 - i % 5}});
  points.insert(points.end(), {{-1, 0}, {3000, 0}});
  const Result<Delaunay> made = delaunay(points);
  ASSERT_TRUE(made);
  Constraint whole{0, 0};
  for (VertexId v = 0; v < points.size(); ++v) {
    if (made->input_of_vertex[v] == 6000) whole.a = v;
    if (made->input_of_vertex[v] == 6001) whole.b = v;
  }
  const std::vector<Constraint> constraints{whole};
  const auto stage = [&](const Threads& threads) {
    Triangulation t = made->triangulation;
    EXPECT_TRUE(insert_constraints(t, constraints, threads));
  };
  // The segment crosses nearly 6000 edges; each is listed and flipped.
  expect_stoppable(stage, made->triangulation.slots.size() + 2 * 5000);
}

TEST(Carving, asks_once_in_1024_steps_and_stops_at_the_first_word) {
  const Result<Delaunay> made = delaunay(domains::random_points(many, 5).points);
  ASSERT_TRUE(made);
  const auto stage = [&](const Threads& threads) {
    Triangulation t = made->triangulation;
    (void)carve(t, {.convex_hull = true, .holes = {}, .region_seeds = {{0.5, 0.5}}}, threads);
  };
  expect_stoppable(stage, made->triangulation.slots.size());
}

TEST(Conversion, asks_once_in_1024_steps_and_stops_at_the_first_word) {
  Pslg pslg = domains::random_points(many, 6);
  const Result<Meshed> meshed = triangulate(pslg);
  ASSERT_TRUE(meshed);
  const auto import = [&](const Threads& threads) { EXPECT_TRUE(import_mesh(meshed->mesh, threads)); };
  expect_stoppable(import, 3 * meshed->mesh.triangles.size());

  const std::vector<double> attributes(many / 2, 1.0);
  std::vector<std::array<Index, 3>> background{meshed->mesh.triangles[0].v};
  for (Index& v : background[0]) v %= static_cast<Index>(attributes.size());
  const Result<DomainTriangulation> domain = triangulate_domain(pslg, true);
  ASSERT_TRUE(domain);
  const auto export_it = [&](const Threads& threads) {
    (void)export_mesh(DomainTriangulation(*domain), {}, {pslg.points, 1, attributes, {}}, background, threads);
  };
  expect_stoppable(export_it, many / 2);  // the other half of the points gets interpolated attributes
}

/// Counts how often the mesher asks for the wanted size after its caller has said stop. It asks once per new triangle.
TEST(Refinement, makes_no_more_than_64_insertions_per_thread_after_the_word) {
  for (const int threads : {1, 2, 4})
    for (const int word : {2, 5, 9}) {
      std::atomic<bool> stopped{false};
      std::atomic<std::uint64_t> sizes_after{0};
      Goal goal{.size = [&](Point) {
        if (stopped) ++sizes_after;
        return 0.002;
      }};
      int calls = 0;
      Options options{.threads = threads};
      options.progress = [&](const Progress& progress) {
        if (progress.triangles > 0 && ++calls >= word) stopped = true;
        return !stopped;
      };
      const Result<Meshed> meshed = mesh(domains::square(), goal, options);
      ASSERT_FALSE(meshed);
      EXPECT_EQ(meshed.error().kind, ErrorKind::cancelled);
      EXPECT_EQ(calls, word) << "the caller is not asked again";
      // An insertion makes about six triangles. A thread that has not yet seen the word makes 64 insertions at most, or
      // examines the triangles of one block.
      EXPECT_LE(sizes_after, static_cast<std::uint64_t>(threads) * 64 * 30);
    }
}

TEST(Stopping, at_any_call_of_the_caller_ends_the_run_with_that_call) {
  for (const int threads : {1, 2})
    for (int last = 1; last <= 12; ++last) {
      int calls = 0;
      Options options{.threads = threads};
      options.progress = [&](const Progress&) { return ++calls < last; };
      const Result<Meshed> meshed = mesh(domains::pipe(), {.max_area = 4e-6}, options);
      ASSERT_FALSE(meshed);
      EXPECT_EQ(meshed.error().kind, ErrorKind::cancelled);
      EXPECT_EQ(calls, last);
    }
}

TEST(Stopping, that_does_not_happen_leaves_the_mesh_as_it_is) {
  for (const int threads : {1, 2}) {
    Options options{.threads = threads};
    options.progress = [](const Progress&) { return true; };
    const Result<Meshed> asked = mesh(domains::pipe(), {.max_area = 1e-4}, options);
    const Result<Meshed> unasked = mesh(domains::pipe(), {.max_area = 1e-4});
    ASSERT_TRUE(asked && unasked);
    EXPECT_TRUE(asked->mesh == unasked->mesh);
  }
}

TEST(Stopping, ends_the_other_functions_of_the_mesher_too) {
  const Pslg pslg = domains::random_points(many, 7);
  const Result<Meshed> coarse = triangulate(pslg);
  ASSERT_TRUE(coarse);
  Options options;
  options.progress = [](const Progress&) { return false; };
  const std::vector<double> sizes(many, 1.0);
  EXPECT_EQ(triangulate(pslg, false, options).error().kind, ErrorKind::cancelled);
  EXPECT_EQ(refine(coarse->mesh, {}, {}, options).error().kind, ErrorKind::cancelled);
  EXPECT_EQ(interpolated_size(pslg, sizes, false, options).error().kind, ErrorKind::cancelled);
}

TEST(Memory, that_the_points_alone_exceed_is_reported_before_the_triangulation) {
  const Pslg pslg = domains::random_points(many, 8);
  int calls = 0;
  Options options{.max_memory = 80 * many - 1};
  options.progress = [&](const Progress&) { return ++calls > 0; };
  const Result<ValidPslg, std::vector<Problem>> domain = validate(pslg);
  ASSERT_TRUE(domain);
  const Result<Meshed> refused = triangulate(*domain, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::resources);
  EXPECT_NE(refused.error().message.find("3.05 MiB"), std::string::npos) << refused.error().message;
  EXPECT_EQ(calls, 0);
}

}  // namespace
}  // namespace pardel::engine
