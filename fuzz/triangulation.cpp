// The engine's triangulation of a small domain against the definitions (ref/). It must be conformal, and no circumdisk
// may contain a vertex that sees its triangle. It must have as many triangles as the triangulation by definition, and
// the same ones if only one triangulation is Delaunay. The checker must certify it.
#include "../parallel/mesher.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/theorems/refinement/by_definition.hpp"
#include "../properties/theorems/refinement/cocircular_neighbours.hpp"
#include "fuzz_one.hpp"
#include "mesh_case.hpp"

namespace pardel::fuzz {
namespace {

constexpr std::size_t most_points = 60;

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  MeshCase drawn = decode_small_case(bytes);
  drawn.goal.convex_hull = false;
  const Prepared prepared = prepare(drawn);
  if (!prepared.usable || prepared.pslg.points.size() > most_points) return -1;
  const Pslg& pslg = prepared.pslg;

  const Result<Meshed> meshed = triangulate(pslg);
  if (!meshed) fail("a valid Pslg was rejected: " + meshed.error().message);
  const Certificate certificate = check(pslg, meshed->mesh, {.min_angle_deg = 0});
  if (!certificate.valid) fail("the checker: " + certificate.violations.front().message());

  const ref::PlainMesh found = ref::to_plain_mesh(meshed->mesh);
  if (!ref::is_conformal(found)) fail("the triangulation is not conformal by definition");
  if (!ref::is_constrained_delaunay(found)) fail("the triangulation is not constrained Delaunay by definition");
  if (!properties::has_plain_coordinates(pslg)) return 0;
  const ref::PlainMesh expected = properties::triangulation_by_definition(pslg);
  if (found.triangles.size() != expected.triangles.size())
    fail("the number of triangles is not that of the definition");
  if (properties::has_cocircular_neighbours(expected)) return 0;
  if (properties::sorted(meshed->mesh.triangles, [](const Triangle& t) { return t.v; }) !=
      properties::sorted(expected.triangles, [](const ref::Corners& t) { return t; }))
    fail("the triangles are not those of the only Delaunay triangulation");
  return 0;
}

}  // namespace pardel::fuzz
