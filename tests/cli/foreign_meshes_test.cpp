// pardel check on meshes of other programs: it reports exactly the violations that these meshes have.
#include <fmt/core.h>

#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "../../core/formats.hpp"
#include "../../properties/defects/edit.hpp"
#include "../properties/checker/cgal_meshes.hpp"
#include "program.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;
using Kinds = std::set<std::string>;

/// A quadrilateral with a quadrilateral hole. Both programs read the same numbers as text.
struct Plate {
  using Corner = std::pair<const char*, const char*>;
  std::array<Corner, 8> corners{{{"0", "0"},
                                 {"3", "0"},
                                 {"3", "3"},
                                 {"0", "3"},  // outline
                                 {"1", "1"},
                                 {"2", "1"},
                                 {"2", "2"},
                                 {"1", "2"}}};  // hole
  Corner in_hole{"1.5", "1.5"};
  double size_outside = 0.4;
  double size_at_hole = 0.05;
  std::array<int, 2> markers{};  ///< of the outline and the hole, 0 for none

  /// The end corner of side i, which starts at corner i.
  static int end(int i) { return i / 4 * 4 + (i + 1) % 4; }

  [[nodiscard]] std::string poly() const {
    std::string text = "8 2 0 0\n";
    for (int i = 0; i < 8; ++i) text += fmt::format("{} {} {}\n", i, corners[i].first, corners[i].second);
    text += "8 1\n";
    for (int i = 0; i < 8; ++i) text += fmt::format("{} {} {} {}\n", i, i, end(i), markers[i / 4]);
    return text + fmt::format("1\n0 {} {}\n", in_hole.first, in_hole.second);
  }

  [[nodiscard]] std::string geo() const {
    std::string text;
    for (int i = 0; i < 8; ++i) {
      text += fmt::format("Point({}) = {{{}, {}, 0, {}}};\n", i + 1, corners[i].first, corners[i].second,
                          i < 4 ? size_outside : size_at_hole);
    }
    for (int i = 0; i < 8; ++i) text += fmt::format("Line({}) = {{{}, {}}};\n", i + 1, i + 1, end(i) + 1);
    return text + "Curve Loop(1) = {1, 2, 3, 4};\nCurve Loop(2) = {5, 6, 7, 8};\nPlane Surface(1) = {1, 2};\n";
  }
};

class ForeignMesh : public Workshop {
 protected:
  using Options = std::vector<std::string>;

  /// Returns the kinds of violations that the program finds. Expects exit code 0 if and only if there are none.
  [[nodiscard]] Kinds judged(const std::string& domain, const std::string& mesh, const Options& goal) const {
    std::vector<std::string> arguments = {"check", domain, mesh, "--quiet", "--json", "-"};
    arguments.insert(arguments.end(), goal.begin(), goal.end());
    const Ran ran = pardel(arguments);
    const json certificate = json::parse(ran.out, nullptr, false);
    if (!certificate.is_object()) {
      ADD_FAILURE() << ran;
      return {"no certificate"};
    }
    Kinds kinds;
    for (const auto& [kind, count] : certificate["violation_counts"].items()) kinds.insert(kind);
    EXPECT_EQ(ran.exit_code, kinds.empty() ? 0 : 1) << ran;
    EXPECT_EQ(certificate["valid"], kinds.empty()) << ran;
    return kinds;
  }
};

// Gmsh.

class GmshMesh : public ForeignMesh {
 protected:
  void SetUp() override {
    if (run("gmsh", {"-version"}).exit_code == 127) GTEST_SKIP() << "gmsh is not installed (Debian package gmsh)";
  }

  /// Writes plate.poly and runs Gmsh, which writes plate.msh.
  void mesh(const Plate& plate, const Options& options = {}, const std::string& groups = "") const {
    write("plate.poly", plate.poly());
    write("plate.geo", plate.geo() + groups);
    Options arguments = {"plate.geo", "-2", "-format", "msh41", "-algo", "del2d", "-nt", "1", "-o", "plate.msh"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ran ran = run("gmsh", arguments);
    ASSERT_EQ(ran.exit_code, 0) << ran;
    ASSERT_TRUE(exists("plate.msh")) << ran;
  }

  [[nodiscard]] Kinds judged(const Options& goal = {}) const {
    return ForeignMesh::judged("plate.poly", "plate.msh", goal);
  }
};

TEST_F(GmshMesh, is_certified_for_what_it_meets_and_refused_for_the_bound_it_misses) {
  mesh({});
  EXPECT_EQ(judged({"--min-angle", "30", "--max-area", "0.1", "--conforming"}), Kinds{});
  EXPECT_EQ(judged({"--min-angle", "33", "--max-area", "0.1"}), Kinds{"small_angle"});
  EXPECT_EQ(judged({"--min-angle", "30", "--max-area", "0.05"}), Kinds{"large_area"});
  EXPECT_EQ(judged({"--min-angle", "30", "--max-edge", "0.3"}), Kinds{"long_edge"});
}

TEST_F(GmshMesh, carries_markers_as_physical_groups) {
  Plate plate;
  plate.markers = {7, 9};
  const std::string outline = "Physical Surface(\"domain\") = {1};\nPhysical Curve(\"marker 7\") = {1, 2, 3, 4};\n";
  mesh(plate, {}, outline + "Physical Curve(9) = {5, 6, 7, 8};\n");
  EXPECT_EQ(judged(), Kinds{});
  mesh(plate, {}, outline + "Physical Curve(9) = {6, 7, 8};\nPhysical Curve(10) = {5};\n");
  EXPECT_EQ(judged(), Kinds{"wrong_edge_marker"});
  mesh(plate, {}, outline + "Physical Curve(9) = {6, 7, 8};\n");
  EXPECT_EQ(judged(), Kinds{"missing_constrained_edge"}) << "with groups, Gmsh leaves out what is in none";
}

// Gmsh writes text with 16 significant digits, but a double needs up to 17.
TEST_F(GmshMesh, as_text_moves_an_input_vertex_of_17_digits_and_as_binary_keeps_it) {
  Plate plate;
  plate.corners[4].first = plate.corners[7].first = "1.2345678901234567";
  mesh(plate);
  EXPECT_TRUE(judged().contains("missing_input_vertex"));
  mesh(plate, {"-bin"});
  EXPECT_EQ(judged(), Kinds{});
}

// 16 digits of numbers just above 10^9 are 8 times as coarse as doubles, more than two units allow.
TEST_F(GmshMesh, as_text_rounds_vertices_off_slanted_segments_and_as_binary_does_not) {
  Plate plate;
  plate.corners = {{{"1000000000", "1000000000"},
                    {"1017000000", "1003000000"},
                    {"1019000000", "1016000000"},
                    {"1001000000", "1013000000"},
                    {"1007000000", "1006000000"},
                    {"1012000000", "1007000000"},
                    {"1013000000", "1012000000"},
                    {"1006000000", "1011000000"}}};
  plate.in_hole = {"1010000000", "1009000000"};
  plate.size_outside = plate.size_at_hole = 2e6;
  mesh(plate);
  EXPECT_EQ(judged(), Kinds{"chain_off_segment"});
  mesh(plate, {"-bin"});
  EXPECT_EQ(judged(), Kinds{});
}

TEST_F(GmshMesh, is_not_everywhere_Delaunay_once_its_vertices_are_smoothed) {
  Plate plate;
  plate.size_outside = 0.05;
  plate.size_at_hole = 0.01;
  mesh(plate);
  EXPECT_EQ(judged(), Kinds{"not_delaunay"});
  mesh(plate, {"-smooth", "0"});
  EXPECT_EQ(judged({"--min-angle", "0"}), Kinds{});
}

// CGAL's Mesh_2. This library writes the files.

class CgalMesh : public ForeignMesh {
 protected:
  CgalMesh() {
    const Result<Pslg> plate = parse_poly(Plate{}.poly(), "plate.poly");
    domain_ = *plate;
    mesh_ = refined_by_cgal(domain_, 0.5);
    list_boundary();
    write("plate.poly", Plate{}.poly());
  }

  /// Gives the boundary edges Triangle's boundary marker. In .node and .vtu files the boundary vertices have it, too.
  void list_boundary() {
    for (const Triangle& triangle : mesh_.triangles) {
      for (int i = 0; i < 3; ++i) {
        if (triangle.n[i] != no_index) continue;
        mesh_.constrained_edges.push_back({triangle.v[(i + 1) % 3], triangle.v[(i + 2) % 3], no_index, 1});
      }
    }
  }

  /// Expects these violations for the mesh in each format.
  void expect(const Options& goal, const Kinds& kinds) const {
    for (const std::string file : {"cgal.node", "cgal.off", "cgal.msh", "cgal.vtu"}) {
      ASSERT_TRUE(write_mesh(mesh_, domain_, folder_ / "work" / file));
      EXPECT_EQ(judged("plate.poly", file, goal), kinds) << file;
    }
  }

  Pslg domain_;
  Mesh mesh_;
};

TEST_F(CgalMesh, is_certified_for_its_own_bounds_and_refused_for_a_sharper_angle) {
  expect({"--min-angle", "20.7", "--max-edge", "0.5", "--conforming"}, {});
  expect({"--min-angle", "30", "--max-edge", "0.5"}, {"small_angle"});
  expect({"--min-angle", "20.7", "--max-edge", "0.3"}, {"long_edge"});
}

TEST_F(CgalMesh, with_one_edge_flipped_is_not_Delaunay) {
  bool flipped = false;
  for (Index t = 0; t < mesh_.triangles.size() && !flipped; ++t) flipped = defects::edit::flip(mesh_, {t, 0});
  ASSERT_TRUE(flipped);
  expect({"--min-angle", "0"}, {"not_delaunay"});
}

}  // namespace
}  // namespace pardel::testing
