// Each way to break the contract is caught and named, and the run ends with a certified mesh.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../../core/digest.hpp"
#include "../../off_the_shelf/mesh_with_mesher.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "bad_meshers.hpp"

namespace pardel {
namespace {

const Goal goal{.min_angle_deg = 25, .max_area = 0.0002};

ValidPslg square() {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  return *validate(pslg);
}
Result<MeshedWithMesher> run(SubdomainMesher& mesher, Scheme scheme, int threads = 1) {
  return mesh_with_mesher(square(), goal, mesher, {.scheme = scheme, .triangles_per_task = 300}, {.threads = threads});
}

class Breaking : public testing::TestWithParam<BreachKind> {};

TEST_P(Breaking, is_caught_and_named) {
  const BreachKind kind = GetParam();
  const Scheme scheme = kind == BreachKind::outside_cell ? Scheme::cells : Scheme::frozen;
  BadMesher mesher(kind);
  const Result<MeshedWithMesher> made = run(mesher, scheme);
  ASSERT_TRUE(made.ok()) << made.error().message;
  const Breaches& breaches = made->mesher.breaches;
  EXPECT_GT(breaches.of(kind), 0U);
  const Breach& first = breaches.first[static_cast<std::size_t>(kind)];
  EXPECT_EQ(name(first.kind), std::string(name(kind)));
  const Certificate certificate = check(square().pslg(), made->mesh, goal);
  EXPECT_TRUE(certificate.valid) << to_text(certificate);
  EXPECT_TRUE(made->report.goal_met());
}

std::vector<BreachKind> all_kinds() {
  std::vector<BreachKind> kinds;
  for (int kind = 0; kind < breach_kinds; ++kind) kinds.push_back(static_cast<BreachKind>(kind));
  return kinds;
}
INSTANTIATE_TEST_SUITE_P(the_contract, Breaking, testing::ValuesIn(all_kinds()),
                         [](const auto& kind) { return std::string(name(kind.param)); });

TEST(OffTheShelf, names_the_exception_of_a_mesher) {
  class Thrower final : public SubdomainMesher {
    [[nodiscard]] MesherAbilities abilities() const override { return own_mesher()->abilities(); }
    [[nodiscard]] RefinedSubdomain refine(const Subdomain&) override { throw std::runtime_error("out of ideas"); }
  } mesher;
  const Result<MeshedWithMesher> made = run(mesher, Scheme::frozen);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->mesher.breaches.of(BreachKind::failed), made->mesher.tasks);
  EXPECT_EQ(made->mesher.breaches.first[0].what, "out of ideas");
}

TEST(OffTheShelf, tries_once_more_after_a_sweep_that_achieved_nothing) {
  /// Fails at first, then works.
  class Late final : public SubdomainMesher {
   public:
    explicit Late(std::uint64_t failures) : failures_(failures) {}
    [[nodiscard]] MesherAbilities abilities() const override { return own_->abilities(); }
    [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
      if (calls_++ >= failures_) return own_->refine(subdomain);
      RefinedSubdomain answer;
      answer.ending = RefinedSubdomain::Ending::failed;
      return answer;
    }

   private:
    std::uint64_t failures_, calls_ = 0;
    std::unique_ptr<SubdomainMesher> own_ = own_mesher();
  };
  for (const Scheme scheme : {Scheme::frozen, Scheme::cells}) {
    Late never(UINT64_MAX);
    const MesherReport hopeless = run(never, scheme)->mesher;
    EXPECT_EQ(hopeless.sweeps, 2U);
    EXPECT_EQ(hopeless.inserted, 0U);
    Late late(hopeless.tasks / 2 + 1);
    const Result<MeshedWithMesher> made = run(late, scheme);
    EXPECT_GT(made->mesher.inserted, made->mesher.completed);
    EXPECT_TRUE(check(square().pslg(), made->mesh, goal).valid);
  }
}

/// Notes whether it gets a triangle at the origin.
class Witness final : public SubdomainMesher {
 public:
  explicit Witness(bool exempts_small_angles) : exempts_(exempts_small_angles) {}
  [[nodiscard]] MesherAbilities abilities() const override {
    MesherAbilities abilities = own_->abilities();
    abilities.exempts_small_angles = exempts_;
    return abilities;
  }
  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    std::size_t small = 0;
    for (const auto& v : subdomain.triangles)
      for (const Index corner : v)
        if (subdomain.points[corner] == Point{0, 0}) ++small;
    seen += small;
    return own_->refine(subdomain);
  }
  std::atomic<std::size_t> seen{0};

 private:
  bool exempts_;
  std::unique_ptr<SubdomainMesher> own_ = own_mesher();
};

TEST(OffTheShelf, gives_no_triangle_at_a_small_input_angle_to_a_mesher_that_does_not_know_them) {
  const Pslg wedge = domains::wedge(72, 5);  // all around the origin
  const Goal angles{.min_angle_deg = 25, .max_area = 0.05};
  for (const Scheme scheme : {Scheme::frozen, Scheme::cells, Scheme::decoupled})
    for (const bool exempts : {false, true}) {
      Witness mesher(exempts);
      const Result<MeshedWithMesher> made = mesh_with_mesher(
          *validate(wedge), angles, mesher, {.scheme = scheme, .triangles_per_task = 1000000}, {.threads = 2});
      ASSERT_TRUE(made.ok()) << made.error().message;
      EXPECT_EQ(mesher.seen > 0, exempts);
      EXPECT_TRUE(check(wedge, made->mesh, angles).valid);
    }
}

TEST(OffTheShelf, splits_borders_to_pieces_that_keep_the_floor) {
  constexpr double min_edge = 0.015;
  const auto mesher = own_mesher();
  const Result<MeshedWithMesher> made =
      mesh_with_mesher(square(), {.max_area = 1e-4}, *mesher, {.scheme = Scheme::decoupled, .triangles_per_task = 50},
                       {.threads = 1, .min_edge = min_edge});
  ASSERT_TRUE(made.ok());
  for (const Triangle& t : made->mesh.triangles)
    for (unsigned i = 0; i < 3; ++i) {
      const Point a = made->mesh.points[t.v[i]], b = made->mesh.points[t.v[(i + 1) % 3]];
      EXPECT_GE(std::hypot(a.x - b.x, a.y - b.y), 0.9 * min_edge);
    }
}

TEST(OffTheShelf, makes_one_mesh_on_any_number_of_threads) {
  for (const Scheme scheme : {Scheme::frozen, Scheme::cells, Scheme::decoupled}) {
    const auto mesher = own_mesher();
    const Result<MeshedWithMesher> one = run(*mesher, scheme);
    ASSERT_TRUE(one.ok());
    EXPECT_GT(one->mesher.tasks, 4U);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(digest(run(*mesher, scheme, threads)->mesh), digest(one->mesh));
  }
}

TEST(OffTheShelf, refuses_a_scheme_that_the_mesher_cannot_serve) {
  class Limited final : public SubdomainMesher {
   public:
    [[nodiscard]] MesherAbilities abilities() const override { return able; }
    [[nodiscard]] RefinedSubdomain refine(const Subdomain&) override { return {}; }
    MesherAbilities able;
  } mesher;
  mesher.able.keeps_frozen_edges = true;
  Result<MeshedWithMesher> made = run(mesher, Scheme::cells);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().kind, ErrorKind::usage);
  EXPECT_EQ(made.error().message, "the scheme 'cells' needs a mesher that inserts points in a given cell only");
  mesher.able = {.obeys_cell = true};
  made = run(mesher, Scheme::decoupled);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().message, "the scheme 'decoupled' needs a mesher that keeps frozen edges");
}

TEST(OffTheShelf, refuses_a_test_of_the_user) {
  const auto mesher = own_mesher();
  const Goal tested{.user_test = [](const std::array<Point, 3>&, double) { return false; }};
  const Result<MeshedWithMesher> made = mesh_with_mesher(square(), tested, *mesher);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().kind, ErrorKind::usage);
  EXPECT_EQ(made.error().message, "a test of the user cannot be given to another mesher");
}

TEST(OffTheShelf, makes_meshes_as_large_as_mesh_does) {
  const Goal fine{.min_angle_deg = 25, .max_area = 2e-5};
  const std::size_t without = mesh(square(), fine, {.threads = 1})->mesh.triangles.size();
  for (const auto& [scheme, most] :
       {std::pair{Scheme::frozen, 1.03}, std::pair{Scheme::cells, 1.03}, std::pair{Scheme::decoupled, 1.08}}) {
    const auto mesher = own_mesher();
    const auto made = mesh_with_mesher(square(), fine, *mesher, {.scheme = scheme, .triangles_per_task = 5000});
    ASSERT_TRUE(made.ok());
    EXPECT_LE(static_cast<double>(made->mesh.triangles.size()), most * static_cast<double>(without)) << name(scheme);
    EXPECT_LE(static_cast<double>(made->mesher.completed), 0.06 * static_cast<double>(without)) << name(scheme);
  }
}

}  // namespace
}  // namespace pardel
