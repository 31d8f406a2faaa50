// Meshes the named domains at usual angles. The meshes are certified, triangles are exempt only at small input angles,
// and the number of triangles is at most that of Triangle's meshes.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "../../parallel/mesher.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"

namespace pardel::engine {
namespace {

struct NamedDomain {
  std::string name;
  std::function<Pslg()> make;
};

void PrintTo(const NamedDomain& domain, std::ostream* out) { *out << domain.name; }

class Showcase : public testing::TestWithParam<NamedDomain> {};

TEST_P(Showcase, is_certified_at_every_angle) {
  const Pslg pslg = GetParam().make();
  for (const double angle : {20.7, 25.0, 30.0, 33.0}) {
    SCOPED_TRACE(angle);
    const Goal goal{.min_angle_deg = angle};
    const Result<Meshed> meshed = mesh(pslg, goal);
    ASSERT_TRUE(meshed) << meshed.error().message;
    EXPECT_TRUE(meshed->report.goal_met()) << "an exemption that no small angle justifies";
    const Certificate certificate = check(pslg, meshed->mesh, goal, {.max_violations = 2});
    EXPECT_TRUE(certificate.valid) << to_text(certificate);
  }
}

constexpr double eastings = 654321, northings = 4987654;

INSTANTIATE_TEST_SUITE_P(
    Domains, Showcase,
    testing::Values(
        NamedDomain{"key", domains::key}, NamedDomain{"pipe", domains::pipe}, NamedDomain{"square", domains::square},
        NamedDomain{"random_points", [] { return domains::random_points(100'000, 1); }},
        NamedDomain{"star_of_5_degrees", [] { return domains::star(12, 5); }},
        NamedDomain{"comb", [] { return domains::comb(40, 0.001); }},
        NamedDomain{"wedge", [] { return domains::wedge(50, 1.8); }},
        NamedDomain{"grid_with_diagonals", [] { return domains::grid(40); }},
        NamedDomain{"grid_points", [] { return domains::grid_points(40); }},
        NamedDomain{"touching_holes", domains::touching_holes}, NamedDomain{"cracks", domains::cracks},
        NamedDomain{"regions", domains::regions},
        NamedDomain{"key_far_away", [] { return domains::moved(domains::key(), eastings, northings); }},
        NamedDomain{"wedge_far_away", [] { return domains::moved(domains::wedge(50, 1.8), eastings, northings); }},
        NamedDomain{"cracks_far_away", [] { return domains::moved(domains::cracks(), eastings, northings); }}),
    [](const testing::TestParamInfo<NamedDomain>& of) { return of.param.name; });

std::size_t triangles(const Pslg& pslg, const Goal& goal) {
  const Result<Meshed> meshed = mesh(pslg, goal);
  return meshed ? meshed->mesh.triangles.size() : SIZE_MAX;
}

// The constants hold for meshes of some thousand triangles and more. For the first two Triangle 1.6 makes a tenth more.

TEST(MeshSize, of_the_square_is_at_most_1_41_over_the_bound) {
  for (const double bound : {3e-4, 1e-4, 1e-5, 1.55e-6}) {
    const auto most = static_cast<std::size_t>(1.41 / bound);
    EXPECT_LE(triangles(domains::square(), {.max_area = bound}), most) << bound;
  }
}

TEST(MeshSize, of_the_pipe_is_at_most_3_5_over_the_bound) {
  for (const double bound : {1e-4, 1e-5, 3.85e-6}) {
    const auto most = static_cast<std::size_t>(3.5 / bound);
    EXPECT_LE(triangles(domains::pipe(), {.max_area = bound}), most) << bound;
  }
}

TEST(MeshSize, of_the_pipe_is_at_most_12_over_the_squared_bound_on_lengths) {
  for (const double bound : {0.02, 0.01, 0.004}) {
    const auto most = static_cast<std::size_t>(12 / (bound * bound));
    EXPECT_LE(triangles(domains::pipe(), {.max_edge = bound}), most) << bound;
  }
}

TEST(MeshSize, of_random_points_is_at_most_what_Triangle_makes) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Pslg pslg = domains::random_points(100'000, seed);
    EXPECT_LE(triangles(pslg, {.min_angle_deg = 20.7}), 322'000U) << "seed " << seed;
    EXPECT_LE(triangles(pslg, {.min_angle_deg = 30}), 554'000U) << "seed " << seed;
  }
}

}  // namespace
}  // namespace pardel::engine
