// The caller of a running refinement gets the mesh after each sweep, the progress, and the thread of each cell.
#include <algorithm>
#include <set>

#include "../../../core/digest.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../properties/checker/check.hpp"
#include "many_tasks.hpp"

namespace pardel::engine::samples {
namespace {

/// The digests of the meshes seen after each sweep, followed by the digest of the result.
std::vector<Digest> digests_seen(const Case& c, int threads, std::vector<Sweep>& sweeps) {
  std::vector<Digest> seen;
  Options options = options_for(c, Decomposition::automatic, threads);
  options.after_sweep = [&](const Mesh& mesh, const Sweep& sweep) {
    seen.push_back(digest(mesh));
    sweeps.push_back(sweep);
    return Done{};
  };
  const Result<Meshed> meshed = mesh(c.pslg, c.goal, options);
  EXPECT_TRUE(meshed);
  EXPECT_EQ(meshed->report.tiling.sweeps.size(), sweeps.size()) << c.name;
  seen.push_back(digest(meshed->mesh));
  return seen;
}

TEST(AfterSweep, the_last_mesh_seen_is_the_result_on_any_number_of_threads) {
  for (const Case& c : cases()) {
    std::vector<Sweep> sweeps, again;
    const std::vector<Digest> one = digests_seen(c, 1, sweeps);
    ASSERT_GE(one.size(), 3U) << c.name;
    EXPECT_EQ(one[one.size() - 2], one.back()) << c.name;
    EXPECT_NE(one.front(), one.back()) << c.name;
    EXPECT_EQ(digests_seen(c, 2, again), one) << c.name;
    for (std::size_t i = 0; i < sweeps.size(); ++i) EXPECT_EQ(sweeps[i].inserted, again[i].inserted) << c.name;
  }
}

TEST(AfterSweep, every_mesh_seen_is_valid_except_for_the_bounds_of_the_goal) {
  for (const Case& c : cases()) {
    Options options = options_for(c);
    options.after_sweep = [&](const Mesh& mesh, const Sweep&) {
      const Certificate certificate =
          check(c.pslg, mesh, {.min_angle_deg = 0, .convex_hull = c.goal.convex_hull}, {.max_violations = 2});
      EXPECT_TRUE(certificate.valid) << c.name << "\n" << to_text(certificate);
      return Done{};
    };
    EXPECT_TRUE(mesh(c.pslg, c.goal, options)) << c.name;
  }
}

TEST(AfterSweep, watching_does_not_change_the_mesh) {
  for (const Case& c : cases()) {
    Options options = options_for(c, Decomposition::automatic, 2);
    const Result<Meshed> unseen = mesh(c.pslg, c.goal, options);
    options.after_sweep = [](const Mesh&, const Sweep&) { return Done{}; };
    const Result<Meshed> seen = mesh(c.pslg, c.goal, options);
    ASSERT_TRUE(unseen && seen) << c.name;
    EXPECT_TRUE(unseen->mesh == seen->mesh) << c.name;
  }
}

TEST(AfterSweep, an_error_ends_the_refinement_and_is_returned_to_the_caller) {
  const Case& c = cases().front();
  int calls = 0;
  Options options = options_for(c, Decomposition::automatic, 2);
  options.after_sweep = [&](const Mesh&, const Sweep&) -> Status {
    if (++calls < 3) return Done{};
    return Error{ErrorKind::internal, "seen enough"};
  };
  const Result<Meshed> meshed = mesh(c.pslg, c.goal, options);
  ASSERT_FALSE(meshed);
  EXPECT_EQ(meshed.error().kind, ErrorKind::internal);
  EXPECT_EQ(meshed.error().message, "seen enough");
  EXPECT_EQ(calls, 3);
}

TEST(AfterSweep, a_mesh_that_is_refined_is_seen_too) {
  const Result<Meshed> coarse = mesh(domains::regions());
  ASSERT_TRUE(coarse);
  Mesh last;
  Options options;
  options.after_sweep = [&](const Mesh& mesh, const Sweep&) {
    last = mesh;
    return Done{};
  };
  const Result<Meshed> fine = refine(coarse->mesh, {}, {.max_area = 1e-3}, options);
  ASSERT_TRUE(fine);
  EXPECT_TRUE(last == fine->mesh);
}

TEST(Progress, never_goes_backwards_whatever_the_number_of_threads) {
  const std::vector<std::pair<Pslg, Goal>> problems{{domains::pipe(), {.max_area = 1e-5}},
                                                    {domains::random_points(80'000, 5), {}},
                                                    {domains::random_points(80'000, 5), {.min_angle_deg = 30}}};
  for (const auto& [pslg, goal] : problems)
    for (const int threads : {1, 2}) {
      std::vector<Progress> seen;
      Options options{.threads = threads, .triangles_per_tile = 2'000};
      options.progress = [&](const Progress& progress) {
        seen.push_back(progress);
        return true;
      };
      const Result<Meshed> meshed = mesh(pslg, goal, options);
      ASSERT_TRUE(meshed);
      ASSERT_GE(seen.size(), 10U);
      EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end(),
                                 [](const Progress& a, const Progress& b) { return a.triangles < b.triangles; }));
      const auto triangles = static_cast<double>(meshed->mesh.triangles.size());
      EXPECT_NEAR(static_cast<double>(seen.back().triangles) / triangles, 1, 0.01);
      for (const Progress& progress : seen) {
        EXPECT_EQ(progress.estimate == 0, progress.triangles == 0) << "both are unknown before the refinement";
        if (progress.estimate > 0) {
          EXPECT_NEAR(progress.estimate / triangles, 1, 0.15);
        }
      }
    }
}

TEST(Tiling, records_which_thread_worked_on_each_cell) {
  for (const Case& c : cases())
    for (const int threads : {1, 2}) {
      const Result<Meshed> meshed = mesh(c.pslg, c.goal, options_for(c, Decomposition::automatic, threads));
      ASSERT_TRUE(meshed) << c.name;
      const Tiling& tiling = meshed->report.tiling;
      const auto& thread = tiling.thread_of_cell;
      ASSERT_EQ(thread.size(), std::size_t{tiling.columns} * tiling.rows) << c.name;
      EXPECT_GE(*std::min_element(thread.begin(), thread.end()), -1) << c.name;
      EXPECT_GE(*std::max_element(thread.begin(), thread.end()), 0) << c.name;
      EXPECT_LT(*std::max_element(thread.begin(), thread.end()), threads) << c.name;
      EXPECT_DOUBLE_EQ(tiling.high.x - tiling.low.x, tiling.columns * tiling.cell_width) << c.name;
      EXPECT_DOUBLE_EQ(tiling.high.y - tiling.low.y, tiling.rows * tiling.cell_height) << c.name;
    }
}

TEST(Tiling, has_cells_of_all_four_colours_that_were_refined) {
  for (const Case& c : cases()) {
    const Result<Meshed> meshed = mesh(c.pslg, c.goal, options_for(c));
    ASSERT_TRUE(meshed) << c.name;
    const Tiling& tiling = meshed->report.tiling;
    std::set<unsigned> colours;
    for (Index cell = 0; cell < tiling.thread_of_cell.size(); ++cell)
      if (tiling.thread_of_cell[cell] >= 0) colours.insert(tiling.colour_of(cell));
    EXPECT_EQ(colours.size(), 4U) << c.name;
  }
}

}  // namespace
}  // namespace pardel::engine::samples
