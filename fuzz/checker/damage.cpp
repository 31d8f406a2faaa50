#include "damage.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../../properties/defects/edit.hpp"
#include "../doubles.hpp"

namespace pardel::fuzz {
namespace {

using generators::Random;
namespace edit = defects::edit;

Index any(std::size_t n, Random& random) { return static_cast<Index>(random.below(n)); }

void damage_triangles(Mesh& mesh, Random& random) {
  const auto any_triangle = [&] { return any(mesh.triangles.size(), random); };
  const auto any_vertex = [&] { return any(mesh.points.size(), random); };
  switch (random.below(5)) {
    case 0: {
      const Index v = any_vertex(), to = any_vertex();
      mesh.points[v] = edit::between(mesh.points[v], mesh.points[to], random.chance(2) ? 0.5 : 1.0);
      break;
    }
    case 1:
      edit::flip(mesh, {any_triangle(), random.between(0, 2)});
      break;
    case 2:
      if (mesh.triangles.size() > 1) edit::erase_triangles(mesh, {any_triangle()});
      break;
    case 3: {
      const Index a = any_vertex(), b = any_vertex();
      edit::append_triangle(mesh, {a, b, any_vertex()}, edit::region_of(mesh, 0));
      edit::relink(mesh);
      break;
    }
    default: {
      const Index t = any_triangle();
      mesh.triangles[t].v[random.below(3)] = any_vertex();
      edit::relink(mesh);
    }
  }
}

void damage_constrained_edges(Mesh& mesh, Random& random) {
  auto& edges = mesh.constrained_edges;
  const Index t = any(mesh.triangles.size(), random);
  const auto& v = mesh.triangles[t].v;
  if (edges.empty() || random.chance(4)) return edges.push_back({v[0], v[1], no_index, 0});
  ConstrainedEdge& edge = edges[random.below(edges.size())];
  switch (random.below(4)) {
    case 0:
      edge = edges.back();
      edges.pop_back();
      break;
    case 1:
      edge.marker += random.between(-1, 1);
      break;
    case 2:
      edge.segment = edges[random.below(edges.size())].segment;
      break;
    default:
      std::swap(edge.a, edge.b);  // no mistake: edges have no direction
  }
}

void damage_labels(Mesh& mesh, Random& random) {
  const Index v = any(mesh.points.size(), random), t = any(mesh.triangles.size(), random);
  switch (random.below(6)) {
    case 0:
      mesh.triangles[t].n[random.below(3)] = random.chance(2) ? no_index : any(mesh.triangles.size(), random);
      break;
    case 1:
      if (!mesh.region.empty()) mesh.region[t] = random.chance(2) ? no_index : mesh.region[mesh.region.size() - 1];
      break;
    case 2:
      if (!mesh.point_markers.empty()) mesh.point_markers[v] = random.between(0, 3);
      break;
    case 3:
      if (!mesh.origin.empty()) mesh.origin[v] = mesh.origin[any(mesh.origin.size(), random)];
      break;
    case 4:
      if (!mesh.point_attributes.empty())
        mesh.point_attributes[any(mesh.point_attributes.size(), random)] = random.between(-1, 1);
      break;
    default:
      damage_constrained_edges(mesh, random);
  }
}

}  // namespace

void damage(Mesh& mesh, Random& random) {
  if (random.chance(2))
    damage_triangles(mesh, random);
  else
    damage_labels(mesh, random);
}

void nudge(Mesh& mesh, Random& random) {
  const std::size_t n = mesh.points.size();
  Point& p = mesh.points[n - 1 - random.below(std::min<std::size_t>(n, 4))];
  if (random.chance(4)) p = edit::between(p, mesh.points[any(n, random)], random.between(-20, 20) * 1e-10);
  p = {moved(p.x, random.between(-3, 3)), moved(p.y, random.between(-3, 3))};
}

void damage_values(Mesh& mesh, Random& random) {
  if (random.chance(2) && !mesh.point_attributes.empty()) {
    // The last vertices are inserted ones.
    const std::size_t n = mesh.point_attributes.size(), last = n - 1 - random.below(std::min<std::size_t>(n, 8));
    double& value = mesh.point_attributes[last];
    value = random.chance(8) ? std::nan("") : value + std::ldexp(random.chance(2) ? 1 : -1, random.between(-40, 4));
    return;
  }
  if (mesh.region_attributes.empty()) mesh.region_attributes.push_back(random.between(0, 7));
  if (mesh.region.empty()) mesh.region.resize(mesh.triangles.size(), no_index);
  mesh.region[any(mesh.region.size(), random)] = any(mesh.region_attributes.size(), random);
}

}  // namespace pardel::fuzz
