// The checker counts from 0; its sentences get the numbers of the files. Each kind of sentence that names something is
// here.
#include "../../cli/numbers_of_files.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace pardel::cli {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

Mesh ten_points() {
  Mesh mesh;
  mesh.points.resize(10);
  return mesh;
}

/// Vertices are 100, 107, 114, ...; triangles and what the domain has count from 1.
TEST(NumbersOfFiles, stand_in_all_sentences_of_the_checker) {
  Mesh mesh = ten_points();
  mesh.first_id = {1};
  for (std::uint64_t v = 0; v < 10; ++v) mesh.numbers.of_points.push_back(100 + 7 * v);
  const NumbersOfFiles numbers(FirstId{1}, mesh);
  for (
      const auto& [checker, file] : Pairs{
          {"triangle 3: angle 34.9° is below 40°", "triangle 4: angle 34.9° is below 40°"},
          {"triangle 3: area 3 is above 1", "triangle 4: area 3 is above 1"},
          {"edge 1-2 of triangle 3: length 2 is above 1", "edge 107-114 of triangle 4: length 2 is above 1"},
          {"vertex 2 lies too far from segment 3", "vertex 114 lies too far from segment 4"},
          {"triangle 3: longest edge 2 is above 1, the size at its centroid",
           "triangle 4: longest edge 2 is above 1, the size at its centroid"},
          {"triangle 3 has area 2 > 1, the cap of region 0", "triangle 4 has area 2 > 1, the cap of region 1"},
          {"boundary edges 0-4 and 1-2 intersect", "boundary edges 100-128 and 107-114 intersect"},
          {"the triangles cover the left of boundary edge 1-2 2 times and its right 1 times",
           "the triangles cover the left of boundary edge 107-114 2 times and its right 1 times"},
          {"edge 1-2 of triangle 3 has no neighbour although it lies inside the domain and on no segment",
           "edge 107-114 of triangle 4 has no neighbour although it lies inside the domain and on no segment"},
          {"triangle 3 ends at edge 1-2, which lies on no chain and not inside the domain",
           "triangle 4 ends at edge 107-114, which lies on no chain and not inside the domain"},
          {"no triangle on the left of edge 1-2 of segment 0, where the domain is",
           "no triangle on the left of edge 107-114 of segment 1, where the domain is"},
          {"the face of the domain on the left of segment 4 has no triangle at any of its segments",
           "the face of the domain on the left of segment 5 has no triangle at any of its segments"},
          {"the face on the right of segment 4 is cut off in the mesh from its part beside segment 5",
           "the face on the right of segment 5 is cut off in the mesh from its part beside segment 6"},
          {"input point 3 lies on one side of segment 1 in the domain, and on the other side of its edges in the mesh",
           "input point 4 lies on one side of segment 2 in the domain, and on the other side of its edges in the mesh"},
          {"around input point 3, the first edges on segment 1, segment 2, the hull do not leave in this order",
           "around input point 4, the first edges on segment 2, segment 3, the hull do not leave in this order"},
          {"triangle 3 contains the seed of hole 0", "triangle 4 contains the seed of hole 1"},
          {"triangle 3 has two equal corners", "triangle 4 has two equal corners"},
          {"edge 1-2 of triangles 3 and 4 is not locally Delaunay: vertex 2 (1, 2) lies inside the circumcircle",
           "edge 107-114 of triangles 4 and 5 is not locally Delaunay: vertex 114 (1, 2) lies inside the circumcircle"},
          {"triangle 3 is not counter-clockwise: twice its signed area is -3",
           "triangle 4 is not counter-clockwise: twice its signed area is -3"},
          {"triangle 3 lists 4 as its neighbour across edge 1-2, but that triangle does not list it there",
           "triangle 4 lists 5 as its neighbour across edge 107-114, but that triangle does not list it there"},
          {"triangles 3 and 4 share edge 1-2 but are not neighbours",
           "triangles 4 and 5 share edge 107-114 but are not neighbours"},
          {"triangles 3 and 4 have the same corners", "triangles 4 and 5 have the same corners"},
          {"vertex 2 has two triangles on the left of its edge to vertex 3",
           "vertex 114 has two triangles on the left of its edge to vertex 121"},
          {"vertex 2 has 5 triangles, but a walk around it from its boundary edges reaches 4",
           "vertex 114 has 5 triangles, but a walk around it from its boundary edges reaches 4"},
          {"edge 1-2 has 3 triangles, more than one on a side",
           "edge 107-114 has 3 triangles, more than one on a side"},
          {"the component of triangle 3 has V - E + F = 1 and 2 boundary loops, which do not sum to 2",
           "the component of triangle 4 has V - E + F = 1 and 2 boundary loops, which do not sum to 2"},
          {"input point 3 of the domain is not a vertex of the mesh",
           "input point 4 of the domain is not a vertex of the mesh"},
          {"input point 3 was moved or renumbered: vertex 2 is (1, 2)",
           "input point 4 was moved or renumbered: vertex 114 is (1, 2)"},
          {"vertex 2 has no triangle and is not an input point",
           "vertex 114 has no triangle and is not an input point"},
          {"segment 3 from point 1 to 2 is not covered by a chain of mesh edges within the rounding distance",
           "segment 4 from point 2 to 3 is not covered by a chain of mesh edges within the rounding distance"},
          {"the hull edge from point 1 to 2 is not covered by a chain",
           "the hull edge from point 2 to 3 is not covered by a chain"},
          {"vertex 2 is no input point, but the edges on segment 1 and those on the hull meet there",
           "vertex 114 is no input point, but the edges on segment 2 and those on the hull meet there"},
          {"constrained edge 1-2 is listed as constrained but is part of no segment",
           "constrained edge 107-114 is listed as constrained but is part of no segment"},
          {"constrained edge 1-2 has marker 5 instead of 3", "constrained edge 107-114 has marker 5 instead of 3"},
          {"edge 1-2 is part of segment 4 but is not listed as constrained",
           "edge 107-114 is part of segment 5 but is not listed as constrained"},
          {"vertex 2 has marker 3 instead of 1 or 2", "vertex 114 has marker 3 instead of 1 or 2"},
          {"triangle 3 has the region attribute 5, but its face has 7, that of region 0",
           "triangle 4 has the region attribute 5, but its face has 7, that of region 1"},
          {"attribute 0 of vertex 2 is 3 instead of 4", "attribute 0 of vertex 114 is 3 instead of 4"},
          {"attribute 0 of vertex 2 is 3, but those of the ends of segment 5 are between 0 and 1",
           "attribute 0 of vertex 114 is 3, but those of the ends of segment 6 are between 0 and 1"},
          {"the triangles' areas sum to 3, the area within the boundary is 4; the exact difference rounds to 1",
           "the triangles' areas sum to 3, the area within the boundary is 4; the exact difference rounds to 1"},
          {"point attributes: 5 entries instead of 4", "point attributes: 5 entries instead of 4"},
          {"  smallest angle            45            triangle 0 at (1, 2)\n  equilateral triangles     0\nangles",
           "  smallest angle            45            triangle 1 at (1, 2)\n  equilateral triangles     0\nangles"},
          {"3 triangles below the angle bound, justified by small input angles\n  at point 3: 2, down to 5 degrees",
           "3 triangles below the angle bound, justified by small input angles\n  at point 4: 2, down to 5 degrees"},
          {"", ""}})
    EXPECT_EQ(numbers.in_sentence(checker), file);
}

TEST(NumbersOfFiles, count_from_0_where_the_mesh_has_none) {
  const Mesh mesh = ten_points();
  const std::string sentence = "edge 1-2 of triangle 3 of segment 4";
  EXPECT_EQ(NumbersOfFiles(FirstId{0}, mesh).in_sentence(sentence), sentence);
  EXPECT_EQ(NumbersOfFiles(FirstId{0}).in_sentence(sentence), sentence);
  EXPECT_EQ(NumbersOfFiles(FirstId{1}).in_sentence(sentence), "edge 1-2 of triangle 3 of segment 5");
}

/// A reader guarantees that corners exist; the checker also reports those that do not.
TEST(NumbersOfFiles, of_vertices_that_do_not_exist_stay) {
  Mesh mesh = ten_points();
  mesh.first_id = {1};
  EXPECT_EQ(NumbersOfFiles(FirstId{0}, mesh).in_sentence("vertex 9, vertex 10"), "vertex 10, vertex 10");
  EXPECT_EQ(NumbersOfFiles(FirstId{0}, mesh).in_sentence("vertex 99999999999999999999999"),
            "vertex 99999999999999999999999");
}

}  // namespace
}  // namespace pardel::cli
