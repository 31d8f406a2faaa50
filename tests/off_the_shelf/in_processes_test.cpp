// Meshers in processes make the same meshes as without, and whole runs survive their crashes.
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "../../core/digest.hpp"
#include "../../off_the_shelf/mesh_with_mesher.hpp"
#include "../../off_the_shelf/own_mesher.hpp"
#include "../../parallel/validate.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "scripted_mesher.hpp"

namespace pardel {
namespace {

MeshedWithMesher run(const Pslg& pslg, const Goal& goal, SubdomainMesher& mesher, Scheme scheme, int threads) {
  const MesherOptions how{.scheme = scheme, .triangles_per_task = 300};
  Result<MeshedWithMesher> made = mesh_with_mesher(*validate(pslg), goal, mesher, how, {.threads = threads});
  if (!made) ADD_FAILURE() << made.error().message;
  return std::move(made).value();
}

/// A counter that all processes share.
class SharedCounter {
 public:
  SharedCounter()
      : value_(new (mmap(nullptr, sizeof *value_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
                   std::atomic<int>(0)) {}
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;
  ~SharedCounter() { munmap(value_, sizeof *value_); }
  std::atomic<int>& value() { return *value_; }

 private:
  std::atomic<int>* value_;
};

class InProcesses : public testing::TestWithParam<Scheme> {};

TEST_P(InProcesses, the_mesh_is_the_same_as_without_processes) {
  const Pslg pslg = domains::key();
  const Goal goal{.min_angle_deg = 25, .max_area = 0.002};
  const auto own = own_mesher();
  const Digest expected = digest(run(pslg, goal, *own, GetParam(), 1).mesh);
  for (const int workers : {1, 2, 3}) {
    const auto mesher = std::move(in_processes(own_mesher(), workers)).value();
    for (const int threads : {1, 3}) {
      const MeshedWithMesher made = run(pslg, goal, *mesher, GetParam(), threads);
      EXPECT_EQ(digest(made.mesh), expected) << workers << " workers, " << threads << " threads";
      EXPECT_EQ(made.mesher.breaches.total(), 0U);
      EXPECT_GT(made.mesher.tasks, 10U);
    }
  }
}

TEST_P(InProcesses, area_caps_of_regions_arrive) {
  const Pslg pslg = domains::regions();
  const Goal goal{.max_area = 0.01, .region_caps = true};
  const auto own = own_mesher();
  const auto mesher = std::move(in_processes(own_mesher(), 2)).value();
  EXPECT_EQ(digest(run(pslg, goal, *mesher, GetParam(), 2).mesh), digest(run(pslg, goal, *own, GetParam(), 2).mesh));
}

TEST_P(InProcesses, sizes_that_depend_on_the_place_are_kept) {
  const Pslg pslg = domains::square();
  const Goal goal{.size = [](Point p) { return 0.01 + 0.1 * std::hypot(p.x - 0.3, p.y - 0.3); }};
  const auto mesher = std::move(in_processes(own_mesher(), 2)).value();
  const MeshedWithMesher made = run(pslg, goal, *mesher, GetParam(), 2);
  EXPECT_TRUE(check(pslg, made.mesh, goal).valid);
  EXPECT_EQ(made.mesher.breaches.total(), 0U);
  EXPECT_LT(made.mesher.completed, made.mesher.inserted);
  const auto own = own_mesher();
  const auto without = static_cast<double>(run(pslg, goal, *own, GetParam(), 2).mesh.triangles.size());
  EXPECT_NEAR(static_cast<double>(made.mesh.triangles.size()), without, 0.1 * without);
}

INSTANTIATE_TEST_SUITE_P(Schemes, InProcesses, testing::Values(Scheme::frozen, Scheme::cells, Scheme::decoupled),
                         [](const auto& scheme) { return std::string(name(scheme.param)); });

TEST(InProcessesRun, a_mesher_that_crashes_in_every_third_task_gives_a_certified_mesh) {
  const Pslg pslg = domains::pipe();
  const Goal goal{.min_angle_deg = 25, .max_area = 0.001};
  for (const int threads : {1, 3}) {
    SharedCounter calls;
    const auto mesher = scripted_in_processes(
        [&calls, own = std::shared_ptr(own_mesher())](const Subdomain& subdomain) {
          if (++calls.value() % 3 == 0) std::abort();
          return own->refine(subdomain);
        },
        2);
    const MeshedWithMesher made = run(pslg, goal, *mesher, Scheme::frozen, threads);
    EXPECT_TRUE(check(pslg, made.mesh, goal).valid);
    EXPECT_GT(calls.value(), 10);
    // The first task of a phase is asked twice. If one of the answers is a crash, they differ; two crashes are one.
    const Breaches& breaches = made.mesher.breaches;
    const auto crashes = static_cast<std::uint64_t>(calls.value() / 3);
    const std::uint64_t reported = breaches.of(BreachKind::crashed) + breaches.of(BreachKind::other_answer);
    EXPECT_LE(reported, crashes);
    EXPECT_GE(reported + (threads > 1 ? made.mesher.phases : 0), crashes);
    EXPECT_EQ(breaches.first[static_cast<std::size_t>(BreachKind::crashed)].what, "SIGABRT");
  }
}

TEST(InProcessesRun, crashes_that_depend_on_the_subdomain_give_one_mesh_on_any_number_of_threads) {
  const Pslg pslg = domains::pipe();
  const Goal goal{.min_angle_deg = 25, .max_area = 0.001};
  std::optional<Digest> expected;
  for (const int threads : {1, 2, 4}) {
    const auto mesher = scripted_in_processes(
        [own = std::shared_ptr(own_mesher())](const Subdomain& subdomain) {
          if (subdomain.points.size() % 3 == 0) std::abort();
          return own->refine(subdomain);
        },
        threads);
    const MeshedWithMesher made = run(pslg, goal, *mesher, Scheme::frozen, threads);
    EXPECT_GT(made.mesher.breaches.of(BreachKind::crashed), 0U);
    if (!expected) expected = digest(made.mesh);
    EXPECT_EQ(digest(made.mesh), *expected);
  }
}

TEST(InProcessesRun, the_abilities_are_those_of_the_mesher_and_thread_safety) {
  const MesherAbilities inner{false, true, false, true, false};
  const auto mesher = std::move(in_processes(std::make_unique<ScriptedMesher>(nullptr, inner), 1)).value()->abilities();
  EXPECT_FALSE(mesher.obeys_cell);
  EXPECT_TRUE(mesher.keeps_frozen_edges);
  EXPECT_FALSE(mesher.splits_segments);
  EXPECT_TRUE(mesher.exempts_small_angles);
  EXPECT_TRUE(mesher.is_thread_safe);
}

TEST(InProcessesRun, no_workers_are_a_usage_error) {
  const auto none = in_processes(own_mesher(), 0);
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().kind, ErrorKind::usage);
  EXPECT_EQ(none.error().message, "the number of workers must be at least 1, not 0");
}

}  // namespace
}  // namespace pardel
