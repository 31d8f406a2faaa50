// T3 and T3-sharp for whole meshes: the bounds on ratio and area come from the mesh, and the bound on the circumradius
// holds for all of its triangles.
#include "whole_meshes.hpp"

#include <string>

#include "../framework/property.hpp"
#include "../framework/rapidcheck_generators.hpp"
#include "../framework/shares.hpp"
#include "ratio_and_area.hpp"

namespace pardel::properties {
namespace {
using ref::Number;

constexpr const char* kinds =
    "Delaunay triangulations of random scenes; rectangles refined by Ruppert's algorithm, with and without triangles "
    "of the extremal shape attached; lattices of nearly equilateral triangles; bounds that the mesh attains, or larger";

/// The largest r⁴ of a random mesh, and bounds on the largest ρ² and the largest A² of its triangles.
struct BoundedMesh {
  Number fourth_power_of_radius, ratio, area;
};

BoundedMesh some_bounded_mesh() {
  const auto no_simpler = [](const WholeMesh&) { return std::vector<WholeMesh>(); };
  const WholeMesh whole = *generators::generator(random_whole_mesh, no_simpler).as("mesh");
  const int slack = *rc::gen::element(0, 1, 2).as("excess of both bounds, in 64ths");
  RC_TAG(std::string(name(whole.kind)));
  RC_ASSERT(ref::is_conformal(whole.mesh));
  const Squares most = largest(whole.mesh);
  return {fourth_power(most.radius), most.ratio() * (64 + slack) / 64, most.area * (64 + slack) / 64};
}

/// Is r more than nine tenths of the bound?
bool is_near(const Number& power, const Number& bound) { return 10'000 * power > 9 * 9 * 9 * 9 * bound; }

PARDEL_PROPERTY(T3, holds_for_whole_random_meshes,
                {.statement = "Let ρ̄ bound the ratio of circumradius to shortest edge of all triangles of a mesh, and "
                              "Δ̄ their areas. Then no circumradius is larger than 2 ρ̄^(3/2) sqrt(Δ̄).",
                 .source = "[CC] Theorem 3; THEORY.md, T3",
                 .families = kinds}) {
  const BoundedMesh mesh = some_bounded_mesh();
  const Number bound = paper_bound(mesh.ratio, mesh.area);
  RC_ASSERT(mesh.fourth_power_of_radius <= bound);
  classify(is_near(mesh.fourth_power_of_radius, bound), "a circumradius above 0.9 of the bound", 12);
}

PARDEL_PROPERTY(T3Sharp, holds_for_whole_random_meshes,
                {.statement = "Let ρ̄ bound the ratio of circumradius to shortest edge of all triangles of a mesh, and "
                              "Δ̄ their areas. Then no circumradius is larger than 2 ρ̄² sqrt(Δ̄) / (4ρ̄² - 1)^(1/4).",
                 .source = "THEORY.md, T3-sharp",
                 .families = kinds}) {
  const BoundedMesh mesh = some_bounded_mesh();
  const Number bound = sharp_bound(mesh.ratio, mesh.area);
  RC_ASSERT(mesh.fourth_power_of_radius <= bound);
  classify(is_near(mesh.fourth_power_of_radius, bound), "a circumradius above 0.9 of the bound", 40);
}

}  // namespace
}  // namespace pardel::properties
