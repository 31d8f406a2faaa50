#include "wrong_mesh_case.hpp"

#include <cmath>
#include <string>

#include "../../properties/wrong_meshes/wrong_mesh.hpp"
#include "compare.hpp"
#include "damage.hpp"

namespace pardel::fuzz {
namespace {

using wrong_meshes::Kind;
using wrong_meshes::WrongMesh;

Point scaled(Point p, int exponent) { return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)}; }

/// Multiplies all lengths by a power of two, which changes no verdict.
void scale(WrongMesh& made, int exponent) {
  const auto scale_points = [&](auto& points) {
    for (Point& p : points) p = scaled(p, exponent);
  };
  const auto scale_number = [&](double& x, int power) { x = std::ldexp(x, power * exponent); };
  scale_points(made.pslg.points);
  scale_points(made.pslg.holes);
  scale_points(made.mesh.points);
  scale_points(made.fault);
  for (Region& region : made.pslg.regions) {
    region.seed = scaled(region.seed, exponent);
    scale_number(region.max_area, 2);
  }
  scale_number(made.reach, 1);
  scale_number(made.goal.max_area, 2);
  scale_number(made.goal.max_edge, 1);
  for (auto& source : made.goal.sources) {
    source.a = scaled(source.a, exponent);
    source.b = scaled(source.b, exponent);
    scale_number(source.at_a, 1);
    scale_number(source.at_b, 1);
  }
  if (made.goal.size)
    made.goal.size = [size = made.goal.size, exponent](Point p) {
      return std::ldexp(size(scaled(p, -exponent)), exponent);
    };
}

}  // namespace

int try_wrong_mesh(Supply bytes) {
  const auto kinds = wrong_meshes::all();
  const Kind& kind = kinds[bytes.byte() % kinds.size()];
  const int exponent = bytes.below(32), changes = bytes.below(4);
  const std::uint64_t seed = bytes.word();
  std::optional<WrongMesh> made = wrong_meshes::make(kind, seed);
  if (!made) return -1;
  scale(*made, exponent < 16 ? exponent : exponent - 32);
  made->options.max_violations = 100'000;
  const Certificate certificate = compare(made->pslg, made->mesh, made->goal, made->options);
  if (const std::string missed = wrong_meshes::missed(kind, *made, certificate); !missed.empty())
    fail(std::string(kind.name) + ": " + missed);
  if (changes == 0) return 0;
  // What else is wrong is known to the definitions only.
  generators::Random random(seed);
  if (changes == 1) nudge(made->mesh, random);
  for (int i = 1; i < changes; ++i) damage(made->mesh, random);
  compare(made->pslg, made->mesh, made->goal, made->options);
  return 0;
}

}  // namespace pardel::fuzz
