// The engine against the executable specification (ref/): a small domain for which Ruppert's algorithm is proven is
// meshed by both. Both must reach the goal, and both meshes must be conformal and (constrained) Delaunay by definition;
// the checker must certify both.
#include <map>
#include <string>

#include "../parallel/mesher.hpp"
#include "../properties/checker/check.hpp"
#include "../ref/faces.hpp"
#include "../ref/ruppert.hpp"
#include "fuzz_one.hpp"
#include "reference_case.hpp"

namespace pardel::fuzz {
namespace {

/// Without the constraints that have triangles on both sides.
ref::PlainMesh with_boundary_only(ref::PlainMesh mesh) {
  std::map<ref::Edge, int> triangles;
  for (const ref::Corners& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      ++triangles[{low, high}];
    }
  std::erase_if(mesh.constraints, [&](const ref::Edge& e) {
    const auto [low, high] = std::minmax(e[0], e[1]);
    return triangles[{low, high}] == 2;
  });
  return mesh;
}

/// A conforming mesh is Delaunay as if only the boundary of the domain were constrained. A circumdisk that reaches
/// across a hole may contain vertices beyond it.
void check_by_definition(const Mesh& mesh, const Goal& goal, const std::string& whose) {
  const ref::PlainMesh plain = ref::to_plain_mesh(mesh);
  if (!ref::is_conformal(plain)) fail(whose + " mesh is not conformal by definition");
  if (!ref::is_constrained_delaunay(goal.conforming ? with_boundary_only(plain) : plain))
    fail(whose + " mesh is not Delaunay by definition");
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  const auto [pslg, goal] = decode_reference_case(bytes);
  const Result<Mesh> reference = ref::ruppert(pslg, goal);
  const Result<Meshed> engine = mesh(pslg, goal);
  if (!engine) fail("the engine rejects the domain: " + engine.error().message);
  if (!reference) {
    if (reference.error().kind != ErrorKind::usage && reference.error().kind != ErrorKind::invalid_input)
      fail("the reference fails: " + reference.error().message);
    return -1;
  }
  if (!engine->report.exempt.empty()) fail("the engine misses a goal that is proven to be reached");
  for (const auto& [name, found] :
       {std::pair("the engine's", &engine->mesh), std::pair("the reference's", &*reference)}) {
    const Certificate certificate = check(pslg, *found, goal);
    if (!certificate.valid) fail(name + std::string(" mesh: ") + certificate.violations.front().message());
    if (!certificate.justified.empty()) fail(name + std::string(" mesh has a small angle without a cause"));
    if (found->triangles.size() < 150) check_by_definition(*found, goal, name);
  }
  return 0;
}

}  // namespace pardel::fuzz
