// What the checker concludes from one scan of all triangles, without walks through the mesh.
#include "../../../properties/checker/model/scan.hpp"

#include <map>

#include "../../../core/neighbours.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../properties/checker/check.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/domains/generators/random.hpp"
#include "../../../properties/theorems/framework/property.hpp"

namespace pardel::checker {
namespace {

bool are_reciprocal(const Mesh& mesh) {
  return scan(mesh.points.span(), mesh.triangles.span(), {}).neighbours_reciprocal;
}

PARDEL_PROPERTY(
    Scan, finds_each_neighbour_that_is_wrong,
    {.statement = "the neighbours of a mesh are reciprocal, and no longer if one of them is changed",
     .source = "properties/checker/model/scan.hpp",
     .families = "meshes of random points; one neighbour of one triangle becomes any other triangle or none, "
                 "or two neighbours of one triangle change places"}) {
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  Mesh mesh = triangulate(domains::random_points(random.between(4, 60), random.next()))->mesh;
  RC_ASSERT(are_reciprocal(mesh));
  const std::size_t t = random.below(mesh.triangles.size());
  auto& neighbours = mesh.triangles[t].n;
  const auto before = neighbours;
  if (random.chance(3))
    std::swap(neighbours[0], neighbours[1]);
  else
    neighbours[random.below(3)] = random.chance(4) ? no_index : static_cast<Index>(random.below(mesh.triangles.size()));
  RC_ASSERT(are_reciprocal(mesh) == (neighbours == before));
}

/// Adds the unit square with this lower left corner. Vertices of different sheets differ, except in the square at (6,
/// 3).
class Bands {
 public:
  void add_cell(int x, int y, int sheet) {
    const Index a = vertex(x, y, sheet), b = vertex(x + 1, y, sheet), c = vertex(x + 1, y + 1, sheet),
                d = vertex(x, y + 1, sheet);
    mesh_.triangles.push_back({{a, b, c}, {no_index, no_index, no_index}});
    mesh_.triangles.push_back({{a, c, d}, {no_index, no_index, no_index}});
  }
  Mesh finished() {
    rebuild_neighbours(mesh_.triangles, mesh_.points.size());
    return mesh_;
  }

 private:
  Index vertex(int x, int y, int sheet) {
    const bool shared = (x == 6 || x == 7) && (y == 3 || y == 4);
    const auto [at, is_new] = number_.try_emplace({x, y, shared ? 0 : sheet}, static_cast<Index>(mesh_.points.size()));
    if (is_new) mesh_.points.push_back({static_cast<double>(x), static_cast<double>(y)});
    return at->second;
  }

  Mesh mesh_;
  std::map<std::array<int, 3>, Index> number_;
};

bool is_on_ring(int x, int y) { return x == 0 || x == 6 || y == 0 || y == 6; }

PARDEL_PROPERTY(
    Scan, does_not_hide_a_handle_of_two_bands_that_cross,
    {.statement = "a surface with a handle has the wrong Euler characteristic, also if all its triangles are "
                  "counter-clockwise and all its vertices have one fan",
     .source = "properties/checker/stages/check_topology.cpp",
     .families = "two square rings that cross twice and have a square in common at one of the crossings, "
                 "with triangles in any order"}) {
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  std::vector<std::array<int, 3>> cells;  // x, y, sheet
  for (int x = 0; x < 7; ++x)
    for (int y = 0; y < 7; ++y) {
      if (!is_on_ring(x, y)) continue;
      cells.push_back({x, y, 0});
      if (x + 3 != 6 || y + 3 != 3) cells.push_back({x + 3, y + 3, 1});
    }
  random.shuffle(cells);
  Bands bands;
  for (const auto& [x, y, sheet] : cells) bands.add_cell(x, y, sheet);
  Pslg square;
  square.points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const Certificate found = check(square, bands.finished(), Goal{}, {.foreign = true});
  RC_ASSERT(found.violation_counts[static_cast<std::size_t>(ViolationKind::euler_characteristic)] == 1U);
  RC_ASSERT(found.violation_counts[static_cast<std::size_t>(ViolationKind::non_manifold_vertex)] == 0U);
}

PARDEL_PROPERTY(Scan, does_not_hide_the_triangle_in_a_hole,
                {.statement = "a triangle that contains the seed of a hole is reported as that",
                 .source = "properties/checker/stages/check_coverage.cpp",
                 .families = "a square with a square hole that is filled with triangles, any seed in the hole"}) {
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  Pslg plate;
  plate.points = {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}};
  plate.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  const Mesh filled = triangulate(plate)->mesh;
  plate.holes = {{random.uniform(1.1, 1.4), random.uniform(1.5, 1.9)}};  // on no diagonal
  const std::string text = to_text(check(plate, filled, Goal{.min_angle_deg = 0}));
  RC_ASSERT(text.find("contains the seed of hole 0") != std::string::npos);
}

}  // namespace
}  // namespace pardel::checker
