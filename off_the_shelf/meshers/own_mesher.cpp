#include "../own_mesher.hpp"

#include <algorithm>
#include <utility>

#include "../../parallel/refinement/task.hpp"
#include "../subdomains/box_of.hpp"
#include "../subdomains/half_edges.hpp"
#include "../subdomains/room.hpp"

namespace pardel {

using namespace engine;

namespace {

constexpr int frozen_marker = 1, free_marker = 2;

/// A subdomain as the engine's triangulation.
struct Imported {
  Triangulation t;
  DomainSegments segments;
  std::vector<double> caps;  ///< of the regions
};

/// Triangles with the same area cap become a region.
void set_regions(const Subdomain& subdomain, Imported& result) {
  if (subdomain.max_areas.empty()) return;
  result.caps = subdomain.max_areas;
  std::ranges::sort(result.caps);
  result.caps.erase(std::unique(result.caps.begin(), result.caps.end()), result.caps.end());
  for (const double cap : subdomain.max_areas)
    result.t.region.push_back(static_cast<Index>(std::ranges::lower_bound(result.caps, cap) - result.caps.begin()));
}

Imported import_subdomain(const Subdomain& subdomain) {
  Imported result;
  Triangulation& t = result.t;
  for (const Point p : subdomain.points) t.points.push_back(p);
  t.origin.resize(subdomain.points.size());
  std::fill(t.origin.begin(), t.origin.end(), input_vertex);
  const HalfEdges sides(subdomain.triangles, subdomain.points.size());
  for (const auto& v : subdomain.triangles) {
    Slot slot{v, {}};
    for (unsigned side = 0; side < 3; ++side) {
      const Index across = sides.find(slot.to(side), slot.from(side));
      if (across != no_index) slot.n[side] = EdgeRef(across / 3, across % 3);
    }
    t.slots.push_back(slot);
  }
  std::vector<Constraint> constraints;
  std::vector<int> markers;
  for (const SubdomainEdge& e : subdomain.edges) {
    const Index side = sides.find(e.a, e.b);
    if (e.inside) t.constrain(EdgeRef(side / 3, side % 3));
    constraints.push_back({e.a, e.b});
    markers.push_back(e.may_be_split ? free_marker : frozen_marker);
  }
  result.segments = DomainSegments(t.points, constraints, markers);
  set_regions(subdomain, result);
  return result;
}

/// One cell, or the cell of the subdomain in the middle of nine. The cell is a little smaller than that of the
/// subdomain, so that rounding moves no point out of it. `box`: contains the subdomain.
Tiles tiles_for(const Subdomain& subdomain, Box box) {
  if (!subdomain.cell) return Tiles(Lattice(box, 1, 1));
  const double margin = 1e-9 * box.extent();
  box = {std::max(subdomain.cell->low.x, box.min_x - box.extent()) + margin,
         std::max(subdomain.cell->low.y, box.min_y - box.extent()) + margin,
         std::min(subdomain.cell->high.x, box.max_x + box.extent()) - margin,
         std::min(subdomain.cell->high.y, box.max_y + box.extent()) - margin};
  const double width = box.max_x - box.min_x, height = box.max_y - box.min_y;
  return Tiles(Lattice({box.min_x - width, box.min_y - height, box.max_x + width, box.max_y + height}, 3, 3));
}

class OwnMesher final : public SubdomainMesher {
 public:
  [[nodiscard]] MesherAbilities abilities() const override { return {true, true, true, true, true}; }

  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    Imported in = import_subdomain(subdomain);
    Triangulation& t = in.t;
    Goal goal = subdomain.goal;
    goal.region_caps = !in.caps.empty();
    const Criteria criteria(goal, Placement::off_centre, in.caps);
    Options options;
    const Box box = box_of(subdomain);
    options.min_edge = std::max({subdomain.min_edge, room_at({box.min_x, box.min_y}), room_at({box.max_x, box.max_y})});
    options.kept_markers = {frozen_marker};
    const Assessor assessor(t, in.segments, criteria, options);

    const auto vertices = static_cast<Index>(t.points.size()), triangles = static_cast<Index>(t.slots.size());
    std::vector<QueuedTriangle> seeds;
    for (TriangleId id = 0; id < triangles; ++id) {
      const Assessment a = assessor.assess(id);
      if (a.need != Assessment::Need::nothing) seeds.push_back(assessor.entry(id, a));
    }
    const auto most = static_cast<Index>(std::min<std::size_t>(subdomain.most_new_points, max_engine_triangles / 4));
    FreeIndices free{IndexPool({{vertices, vertices + most}}), IndexPool({{triangles, triangles + 2 * most}})};
    t.points.resize_uninitialised(vertices + most);
    t.origin.resize_uninitialised(vertices + most);
    t.slots.resize_uninitialised(triangles + 2 * most);
    if (!t.region.empty()) t.region.resize_uninitialised(triangles + 2 * most);
    const Tiles tiles = tiles_for(subdomain, box);
    Task task(t, assessor, criteria, options.min_edge, subdomain.cell.has_value());
    RefinedSubdomain answer;
    // The limit on new points ends the task; a limit on time would let the mesh depend on the speed of the machine.
    const TaskResult done = task.run(tiles, tiles.cells() / 2, seeds, {}, free, [](std::uint64_t) {});
    if (done.out_of_numbers > 0) answer.ending = RefinedSubdomain::Ending::limit;
    write(t, vertices + most - static_cast<Index>(free.vertices.left()),
          triangles + 2 * most - static_cast<Index>(free.triangles.left()), subdomain, answer);
    return answer;
  }

 private:
  static void write(const Triangulation& t, Index vertices, Index triangles, const Subdomain& subdomain,
                    RefinedSubdomain& answer) {
    answer.points.assign(t.points.begin(), t.points.begin() + vertices);
    for (auto v = static_cast<Index>(subdomain.points.size()); v < vertices; ++v)
      answer.edge_of_new_point.push_back(t.origin[v] == interior_vertex ? no_index : segment_of_origin(t.origin[v]));
    answer.triangles.reserve(triangles);
    for (TriangleId id = 0; id < triangles; ++id) answer.triangles.push_back(t.slots[id].v);
  }
};

}  // namespace

std::unique_ptr<SubdomainMesher> own_mesher() { return std::make_unique<OwnMesher>(); }

}  // namespace pardel
