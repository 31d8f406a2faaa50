#include "hole_seeds.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/doubled_area.hpp"
#include "../../parallel/mesher.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

/// Where border edges start and end. The subdomain lies to the left.
using Border = std::vector<std::pair<Index, Index>>;

/// The points and edges of the border alone. `border`: sorted.
Pslg border_of(const Subdomain& subdomain, Border& border) {
  Pslg pslg;
  std::vector<Index> number(subdomain.points.size(), no_index);
  const auto renumbered = [&](Index point) {
    if (number[point] == no_index) {
      number[point] = static_cast<Index>(pslg.points.size());
      pslg.points.push_back(subdomain.points[point]);
    }
    return number[point];
  };
  for (const SubdomainEdge& e : subdomain.edges) {
    if (e.inside) continue;
    const Index a = renumbered(e.a), b = renumbered(e.b);
    pslg.segments.push_back({a, b});
    border.push_back({a, b});
  }
  std::ranges::sort(border);
  return pslg;
}

/// The faces of a triangulation between border edges.
class Faces {
 public:
  Faces(const Mesh& mesh, const Border& border) : mesh_(mesh), border_(border), seen_(mesh.triangles.size(), 0) {}

  std::vector<Point> holes() {
    std::vector<Point> seeds;
    for (Index start = 0; start < seen_.size(); ++start) {
      if (seen_[start] != 0) continue;
      const Face face = face_of(start);
      if (!face.is_covered) seeds.push_back(centroid(face.largest));
    }
    return seeds;
  }

 private:
  struct Face {
    bool is_covered = false;  ///< by triangles of the subdomain
    Index largest = 0;
  };

  Face face_of(Index start) {
    Face face{false, start};
    std::vector<Index> waiting{start};
    seen_[start] = 1;
    while (!waiting.empty()) {
      const Index t = waiting.back();
      waiting.pop_back();
      if (area(t) > area(face.largest)) face.largest = t;
      const Triangle& triangle = mesh_.triangles[t];
      for (unsigned i = 0; i < 3; ++i) {
        const Index from = triangle.v[(i + 1) % 3], to = triangle.v[(i + 2) % 3], across = triangle.n[i];
        const bool on_left = is_border(from, to);
        face.is_covered = face.is_covered || on_left;
        if (across == no_index || on_left || is_border(to, from)) continue;
        if (std::exchange(seen_[across], 1) == 0) waiting.push_back(across);
      }
    }
    return face;
  }
  [[nodiscard]] bool is_border(Index from, Index to) const {
    return std::ranges::binary_search(border_, std::pair(from, to));
  }
  [[nodiscard]] double area(Index t) const {
    const auto [a, b, c] = mesh_.triangles[t].v;
    return doubled_area(mesh_.points[a], mesh_.points[b], mesh_.points[c]);
  }
  [[nodiscard]] Point centroid(Index t) const {
    const auto [a, b, c] = mesh_.triangles[t].v;
    return centroid_of(mesh_.points[a], mesh_.points[b], mesh_.points[c]);
  }

  const Mesh& mesh_;
  const Border& border_;
  std::vector<char> seen_;
};

}  // namespace

Result<std::vector<Point>> hole_seeds(const Subdomain& subdomain) {
  Border border;
  const Pslg pslg = border_of(subdomain, border);
  // Holes are not known yet, so this covers them, too.
  const Result<Meshed> meshed = triangulate(pslg, false, {.threads = 1});
  if (!meshed) return meshed.error();
  return Faces(meshed->mesh, border).holes();
}

}  // namespace pardel::engine
