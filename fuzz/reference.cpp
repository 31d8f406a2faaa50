// The engine against the executable specification (ref/): a small domain for which Ruppert's algorithm is proven is
// meshed by both. Both must reach the goal, and both meshes must be conformal and (constrained) Delaunay by definition;
// the checker must certify both.
#include <map>
#include <set>
#include <string>

#include "../parallel/mesher.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/domains/paths.hpp"
#include "../ref/faces.hpp"
#include "../ref/ruppert.hpp"
#include "fuzz_one.hpp"
#include "supply.hpp"

namespace pardel::fuzz {
namespace {

/// A square of side 16, possibly with a rectangular hole or island, or a wall from side to side, and isolated points.
/// No two segments meet at less than 60 degrees.
Pslg decode_domain(Supply& bytes) {
  Pslg pslg;
  const int kind = bytes.below(4), low = 3 + bytes.below(5), high = 8 + bytes.below(6), right = 8 + bytes.below(6);
  domains::add_closed(pslg, domains::rectangle(0, 0, 16, 16));
  if (kind == 1 || kind == 2) domains::add_closed(pslg, domains::rectangle(low, low, right, high));
  if (kind == 1) pslg.holes.push_back({(low + right) / 2.0, (low + high) / 2.0});
  if (kind == 3) domains::add_open(pslg, {{double(low), 2}, {double(right), double(high)}});
  std::set<std::pair<int, int>> used;
  while (!bytes.empty() && used.size() < 16) {
    const int x = 1 + bytes.below(15), y = 1 + bytes.below(15);
    const auto lies_between = [](int k, int a, int b) { return k >= a && k <= b; };
    const bool in_box = lies_between(x, low, right) && lies_between(y, low, high);
    const bool on_wall = kind == 3 && (right - low) * (y - 2) == (high - 2) * (x - low);
    if ((kind == 1 || kind == 2) && in_box) continue;
    if (!on_wall && used.insert({x, y}).second) pslg.points.push_back({double(x), double(y)});
  }
  return pslg;
}

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
  Supply supply(bytes);
  Goal goal{.min_angle_deg = supply.one_of({20.7, 10.0, 15.0, 0.0})};
  goal.conforming = supply.flag(128);
  if (const int cap = supply.below(4); cap == 3) goal.max_area = 12;
  const Pslg pslg = decode_domain(supply);

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
