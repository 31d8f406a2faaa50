// Witnesses with the numbers of files.
#include "../../../properties/checker/witness.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "../../../properties/checker/certificate.hpp"
#include "../../../properties/checker/model/numbering.hpp"
#include "numbers_in_sentences.hpp"

namespace pardel::checker {
namespace {

using testing::in_sentence;
using testing::numbers_of_some_file;

TEST(Witness, has_the_numbers_that_it_is_asked_for) {
  const Witness witness = "edge " + edge_text(1, 2) + " of triangle " + triangle_number(3) + " has length " +
                          std::string("2") + ", on segment " + domain_number(0);
  EXPECT_EQ(witness.text(), "edge 1-2 of triangle 3 has length 2, on segment 0");
  EXPECT_EQ(witness.text({.first_of_domain = 1, .first_triangle = 5, .first_vertex = 10}),
            "edge 11-12 of triangle 8 has length 2, on segment 1");
  EXPECT_EQ(witness.text(numbers_of_some_file(9)), "edge 107-114 of triangle 4 has length 2, on segment 9");
}

TEST(Witness, may_be_empty_or_begin_with_a_number) {
  EXPECT_TRUE(Witness().empty());
  EXPECT_EQ((Witness() + "" + Witness()).text(), "");
  EXPECT_FALSE(vertex_number(4).empty());
  EXPECT_EQ((vertex_number(4) + vertex_number(5) + "!").text({.first_vertex = 1}), "56!");
}

TEST(Witness, can_be_taken_apart_and_put_together) {
  const Witness witness = "vertex " + vertex_number(2) + " and triangle " + triangle_number(7);
  const Witness same(witness.words(), witness.numbers());
  EXPECT_EQ(same.text(numbers_of_some_file()), "vertex 114 and triangle 8");
}

/// Files count from 0 or 1, so a number may be one more than the largest index.
TEST(Witness, names_vertices_without_an_own_number_by_the_first_one) {
  const std::vector<std::uint64_t> numbers{50, 60};
  const Witness witness = "edge " + edge_text(1, 2) + ", vertex " + vertex_number(no_index);
  EXPECT_EQ(witness.text({.first_vertex = 1, .vertices = numbers}), "edge 60-3, vertex 4294967296");
}

TEST(Violation, has_no_ids_in_a_message_with_the_numbers_of_files) {
  const Violation violation{
      ViolationKind::unused_vertex, {2}, {{1, 2}, {3, 4}}, "vertex " + vertex_number(2) + " is here"};
  EXPECT_EQ(violation.message(), "unused_vertex: vertex 2 is here [ids 2] at (1, 2), (3, 4)");
  EXPECT_EQ(violation.message(numbers_of_some_file()), "unused_vertex: vertex 114 is here at (1, 2), (3, 4)");
}

TEST(Certificate, has_the_numbers_of_files_in_its_summary) {
  Certificate certificate;
  certificate.region_caps = {0.5, 1};
  certificate.min_angle_deg = {45, 0, {1, 2}};
  certificate.justified = {{0, 3, 10, 5}, {1, 3, 10, 5}};
  const std::string text = summary_text(certificate, numbers_of_some_file());
  for (const char* part : {"areas up to 0.5 in region 1, 1 in region 2",
                           "  smallest angle            45            triangle 1 at (1, 2)\n",
                           "2 triangles below the angle bound, justified by small input angles\n"
                           "  at point 4: 2, down to 5 degrees"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  EXPECT_NE(summary_text(certificate).find("triangle 0 at (1, 2)"), std::string::npos);
}

using Pairs = std::vector<std::pair<std::string, std::string>>;

/// One sentence of each kind. violation_test.cpp and recorded_checks_test.cpp compare all witnesses with in_sentence().
TEST(NumbersInSentences, are_found_by_the_words_before_them) {
  for (
      const auto& [said, file] : Pairs{
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
          {"constrained edge 5 (1-2) lists segment 2 but is part of 0",
           "constrained edge 5 (107-114) lists segment 3 but is part of 1"},
          {"constrained edge 5 refers to a segment that does not exist",
           "constrained edge 5 refers to a segment that does not exist"},
          {"vertex 8 is listed as on segment 4 but is on segment 5",
           "vertex 156 is listed as on segment 5 but is on segment 6"},
          {"", ""}})
    EXPECT_EQ(in_sentence(said, numbers_of_some_file()), file);
}

}  // namespace
}  // namespace pardel::checker
