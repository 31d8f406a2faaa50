// The repository follows the rules of its structure, and every rule rejects a tree that breaks it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "../temporary_folder.hpp"
#include "rules.hpp"

namespace pardel::structure {
namespace {

namespace fs = std::filesystem;

std::string lines(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& line : all) text += line + '\n';
  return text;
}

TEST(Structure, the_repository_keeps_every_rule) {
  const SourceTree tree = read_source_tree(PARDEL_SOURCE);
  EXPECT_GT(tree.size(), 300u);
  EXPECT_EQ(lines(violations(tree)), "") << "The rules are defined in tests/structure/rules.cpp.";
}

TEST(Structure, every_allowed_violation_is_needed) {
  EXPECT_EQ(lines(unused_exceptions(read_source_tree(PARDEL_SOURCE))), "");
}

/// The modules of parallel/ and distributed/ that have no test file named after them, and the tests that cover them.
const std::map<std::string, std::vector<std::string>> covering_tests = {
    {"threads/threads", {"stopping_test", "threads/parallel_for_test"}},
    {"decomposition/tiles", {"scheduling/tiling_record_test", "scheduling/pending_triangles_test"}},
    {"threads/watched_array", {"scheduling/touches_test"}},
    {"location/gridded", {"location/locator_test", "location/locator_property_test"}},
    {"location/grow_tree", {"location/locator_test", "location/locator_property_test"}},
    {"location/located_triangles", {"location/locator_test", "location/locator_property_test"}},
    {"location/location_grid", {"location/locator_test", "location/locator_property_test"}},
    {"location/location_split", {"location/locator_test", "location/locator_property_test"}},
    {"location/search_tree", {"location/locator_test", "location/locator_property_test"}},
    {"location/visit_by_tile", {"location/locator_test"}},
    {"location/weights", {"location/locator_test"}},
    {"conversion/export_mesh", {"conversion/import_export_test"}},
    {"construction/hairlines_outside", {"construction/hairlines_test"}},
    {"conversion/import_mesh", {"conversion/import_export_test"}},
    {"construction/begin_with_latest", {"construction/delaunay_test", "divided_input/mesh_of_points_test"}},
    {"construction/insertion_order", {"construction/delaunay_test", "delaunay/local_delaunay_test"}},
    {"meshing/refine_in_ranks", {"meshing/pieces_test"}},
    {"refinement/goal_met", {"refine_mesh_test"}},
    {"refinement/make_room", {"refinement/insertion_test"}},
    {"segments/segment_pieces", {"conversion/join_subsegments_test", "refine_mesh_test"}},
    {"construction/crossed_edges", {"construction/insert_constraints_test", "cdt/common_segments_test"}},
    {"cdt/common_vertices", {"divided_input/mesh_of_points_test"}},
    {"cdt/given_segment", {"cdt/common_segments_test"}},
    {"cdt/own_segments", {"cdt/common_segments_test"}},
    {"cdt/problems_of_domain", {"divided_input/mesh_of_points_test"}},
    {"cdt/segments_around", {"divided_input/mesh_of_points_test"}},
    {"cdt/sides_of_triangles", {"divided_input/labels_test"}},
    {"cdt/sites_of_numbers", {"cdt/common_segments_test"}},
    {"divided_input/triangles_at_borders", {"divided_input/labels_test", "divided_input/mesh_of_points_test"}},
    {"divided_input/divided_points", {"divided_input/mesh_of_points_test"}},
    {"divided_input/part_of_domain", {"divided_input/mesh_of_points_test"}},
    {"delaunay/resolve_halo", {"delaunay/triangulated_pieces_test"}},
    {"delaunay/own_points", {"delaunay/triangulated_pieces_test"}},
    {"delaunay/piece_of_points", {"delaunay/triangulated_pieces_test"}},
    {"delaunay/shared_hull", {"delaunay/triangulated_pieces_test"}},
    {"delaunay/problems_of_points", {"delaunay/triangulated_pieces_test"}},
    {"delaunay/triangulated_points", {"delaunay/triangulated_pieces_test"}},
    {"meshing/distribution", {"meshing/margins_test", "meshing/pieces_test"}},
    {"meshing/gaps_in_ranks", {"meshing/pieces_test"}},
    {"meshing/members", {"meshing/pieces_test"}},
    {"meshing/mesh_in_ranks", {"meshing/pieces_test"}},
    {"meshing/piece", {"meshing/pieces_test"}},
    {"meshing/vertex_data", {"meshing/pieces_test"}},
    {"diagnosis/count_faces", {"domain/repair_test"}},
    {"diagnosis/far_part", {"diagnosis/warnings_test"}},
    {"diagnosis/narrowest_part", {"domain/repair_test"}},
    {"diagnosis/straight_walk", {"diagnosis/find_gaps_test", "diagnosis/find_least_size_test"}},
    {"domain/check_faces", {"domain/validate_test"}},
    {"domain/check_values", {"domain/validate_test"}},
    {"domain/find_problems", {"domain/validate_test"}},
    {"domain/findings", {"domain/validate_test"}},
    {"construction/flood", {"construction/carve_test"}},
    {"construction/remove_triangles", {"construction/carve_test"}},
    {"diagnosis/extents_by_scale", {"diagnosis/find_gaps_test", "domain/repair_of_scales_test"}},
    {"diagnosis/tiny_gaps", {"domain/repair_test", "domain/repair_of_scales_test"}},
    {"divided_input/divided_background", {"divided_input/mesh_of_points_test"}},
    {"meshing/check_distributable", {"meshing/pieces_test"}},
    {"patches/border_edges", {"filling/filling_test"}},
    {"patches/cut_out", {"filling/filling_test"}},
    {"patches/lay_patches", {"filling/filling_test"}},
    {"patches/write_strips", {"filling/filling_test", "meshing/filled_pieces_test"}},
    {"filling/division", {"meshing/filled_pieces_test"}},
    {"filling/filled_round", {"filling/refine_filled_test"}},
    {"scheduling/refine_domain", {"mesher_test", "scheduling/after_sweep_test"}},
    {"domain/repair_once", {"domain/repair_test"}},
    {"domain/untangle", {"domain/repair_test"}},
    {"refinement/exemptions", {"mesher_test", "limits_test"}},
    {"triangulation/held", {"meshing/margins_test", "meshing/pieces_test"}},
    {"triangulation/paired_disk_query", {"triangulation/cavity_test"}},
    {"planning/mesh_valid", {"mesher_test"}},
    {"planning/run_plan", {"mesher_test", "filling/refine_filled_test"}},
    {"scheduling/one_process", {"scheduling/phase_test", "scheduling/many_tiles_test"}},
    {"scheduling/waiting", {"scheduling/pending_triangles_test"}},
    {"planning/supervised", {"stopping_test"}},
    {"scheduling/level_rules", {"scheduling/paper_quadtree_test", "scheduling/paper_lattice_test"}},
    {"scheduling/sweeper", {"scheduling/after_sweep_test", "scheduling/many_tiles_test"}},
    {"scheduling/communicator", {"meshing/margins_test"}},
    {"scheduling/refine_by_sweeps", {"scheduling/after_sweep_test", "scheduling/many_tiles_test"}},
    {"segments/conflicts", {"domain/validate_property_test"}},
    {"segments/snapping", {"segments/reach_test"}},
    {"segments/sweep_agenda", {"segments/plane_sweep_test"}},
    {"triangulation/cavity_query", {"triangulation/cavity_test"}},
    {"triangulation/in_circumdisk", {"triangulation/flips_test"}},
    {"triangulation/triangle_shape", {"quality/criteria_test"}},
};

TEST(Structure, every_engine_module_has_its_own_test_or_a_covering_test) {
  const SourceTree tree = read_source_tree(PARDEL_SOURCE);
  const std::set<std::string> folders = {"parallel", "distributed"};
  const auto is_test = [&](const std::string& name) {
    return std::ranges::any_of(
        folders, [&](const std::string& folder) { return tree.contains("tests/" + folder + "/" + name + ".cpp"); });
  };
  std::set<std::string> modules;
  for (const auto& [file, source] : tree) {
    const fs::path path = file;
    if (path.extension() != ".hpp" || !folders.contains(path.parent_path().parent_path().string())) continue;
    const std::string module = path.parent_path().filename().string() + "/" + path.stem().string();
    modules.insert(module);
    const auto covered = covering_tests.find(module);
    const bool has_own = is_test(module + "_test") || is_test(path.stem().string() + "_test");
    EXPECT_NE(has_own, covered != covering_tests.end()) << module;
    if (covered == covering_tests.end()) continue;
    for (const std::string& test : covered->second) EXPECT_TRUE(is_test(test)) << module << ": " << test;
  }
  EXPECT_GT(modules.size(), 50u);
  for (const auto& [module, tests] : covering_tests) EXPECT_TRUE(modules.contains(module)) << module;
}

/// A small tree that keeps every rule; each test adds one file that breaks one.
class StructureRule : public ::testing::Test {
 protected:
  void SetUp() override {
    add("core/mesh.hpp", {});
    add("core/support/shortest.hpp", {});
    add("core/formats/text_reader.hpp", {"../mesh.hpp", "../support/shortest.hpp"}, "pardel::files");
    add("parallel/options.hpp", {"../core/mesh.hpp"});
    add("parallel/arithmetic/predicates.hpp", {}, "pardel::engine");
    add("parallel/domain/faces.hpp", {"../arithmetic/predicates.hpp"}, "pardel::engine");
    add("parallel/triangulation/cavity.hpp", {"../arithmetic/predicates.hpp", "../options.hpp"}, "pardel::engine");
    add("parallel/mesher.cpp", {"options.hpp", "triangulation/cavity.hpp", "domain/faces.hpp"});
    add("properties/checker/check.hpp", {"../../core/mesh.hpp"});
    add("properties/checker/arithmetic/exact.hpp", {}, "pardel::checker");
    add("properties/checker/model/domain.hpp", {"../arithmetic/exact.hpp", "../check.hpp"}, "pardel::checker");
    add("properties/defects/defects.hpp", {"../checker/check.hpp", "../checker/arithmetic/exact.hpp"});
    add("properties/theorems/region_test.cpp", {"../../ref/region.hpp", "../../parallel/options.hpp"});
    add("ref/region.hpp", {"../core/mesh.hpp"});
    add("cli/main.cpp", {"../parallel/options.hpp", "../core/support/shortest.hpp"});
    add("tests/parallel/cavity_test.cpp", {"../../parallel/triangulation/cavity.hpp"});
    ASSERT_EQ(lines(violations(read_source_tree(root_.path()))), "");
  }

  void add(const std::string& file, const std::vector<std::string>& includes, const std::string& name = "pardel") {
    std::string text;
    for (const std::string& include : includes) text += "#include \"" + include + "\"\n";
    root_.write(file, text + "namespace " + name + " {\n}\n");
  }

  /// The violations in the tree after one more file is added.
  std::string violations_with(const std::string& file, const std::vector<std::string>& includes,
                              const std::string& name = "pardel") {
    add(file, includes, name);
    return lines(violations(read_source_tree(root_.path())));
  }

  TemporaryFolder root_;
};

TEST_F(StructureRule, a_private_header_of_the_engine_is_not_included_from_outside) {
  EXPECT_EQ(violations_with("cli/draw.cpp", {"../parallel/triangulation/cavity.hpp"}),
            "cli/draw.cpp:1: includes parallel/triangulation/cavity.hpp: the header is private to parallel\n");
}

TEST_F(StructureRule, a_private_header_of_the_checker_is_not_included_from_outside) {
  EXPECT_EQ(violations_with("cli/draw.cpp", {"../properties/checker/model/domain.hpp"}),
            "cli/draw.cpp:1: includes properties/checker/model/domain.hpp: the header is private to "
            "properties/checker\n");
}

TEST_F(StructureRule, a_private_header_of_core_is_not_included_from_outside) {
  EXPECT_EQ(violations_with("parallel/mesher2.cpp", {"../core/formats/text_reader.hpp"}),
            "parallel/mesher2.cpp:1: includes core/formats/text_reader.hpp: the header is private to core\n");
}

TEST_F(StructureRule, a_private_header_is_not_included_in_angle_brackets) {
  root_.write("examples/a.cpp",
              "#include <pardel/parallel/options.hpp>\n#include <pardel/parallel/domain/faces.hpp>\n");
  EXPECT_EQ(lines(violations(read_source_tree(root_.path()))),
            "examples/a.cpp:2: includes parallel/domain/faces.hpp: the header is private to parallel\n");
}

TEST_F(StructureRule, an_allowed_violation_holds_for_its_own_folder_only) {
  EXPECT_EQ(violations_with("tests/cli/draw_test.cpp", {"../../parallel/triangulation/cavity.hpp"}),
            "tests/cli/draw_test.cpp:1: includes parallel/triangulation/cavity.hpp: the header is private to "
            "parallel\n");
}

TEST_F(StructureRule, the_checker_uses_neither_the_engine_nor_ref_nor_defects_nor_theorems) {
  add("properties/theorems/scene.hpp", {});
  EXPECT_EQ(violations_with("properties/checker/check.cpp",
                            {"check.hpp", "../../parallel/options.hpp", "../../ref/region.hpp",
                             "../defects/defects.hpp", "../theorems/scene.hpp"}),
            "properties/checker/check.cpp:2: includes parallel/options.hpp: properties/checker may not use parallel\n"
            "properties/checker/check.cpp:3: includes ref/region.hpp: properties/checker may not use ref\n"
            "properties/checker/check.cpp:4: includes properties/defects/defects.hpp: properties/checker may not use "
            "properties/defects\n"
            "properties/checker/check.cpp:5: includes properties/theorems/scene.hpp: properties/checker may not use "
            "properties/theorems\n");
}

TEST_F(StructureRule, the_domains_do_not_use_the_engine) {
  EXPECT_EQ(violations_with("properties/domains/domains.cpp", {"../../parallel/options.hpp"}),
            "properties/domains/domains.cpp:1: includes parallel/options.hpp: properties/domains may not use "
            "parallel\n");
}

TEST_F(StructureRule, core_uses_nothing_above_it) {
  EXPECT_EQ(violations_with("core/mesh.cpp", {"mesh.hpp", "../parallel/options.hpp"}),
            "core/mesh.cpp:2: includes parallel/options.hpp: core may not use parallel\n");
}

TEST_F(StructureRule, the_engine_does_not_use_the_checker) {
  EXPECT_EQ(violations_with("parallel/mesher2.cpp", {"../properties/checker/check.hpp"}),
            "parallel/mesher2.cpp:1: includes properties/checker/check.hpp: parallel may not use properties/checker\n");
}

TEST_F(StructureRule, ref_and_the_engine_do_not_use_each_other) {
  EXPECT_EQ(violations_with("ref/region.cpp", {"region.hpp", "../parallel/options.hpp"}),
            "ref/region.cpp:2: includes parallel/options.hpp: ref may not use parallel\n");
  EXPECT_EQ(violations_with("ref/region.cpp", {"region.hpp", "../properties/checker/check.hpp"}),
            "ref/region.cpp:2: includes properties/checker/check.hpp: ref may not use properties/checker\n");
  add("ref/region.cpp", {"region.hpp"});
  EXPECT_EQ(violations_with("parallel/mesher2.cpp", {"../ref/region.hpp"}),
            "parallel/mesher2.cpp:1: includes ref/region.hpp: parallel may not use ref\n");
}

TEST_F(StructureRule, a_room_does_not_use_a_higher_room) {
  EXPECT_EQ(violations_with("parallel/arithmetic/pair.hpp", {"../triangulation/cavity.hpp"}, "pardel::engine"),
            "parallel/arithmetic/pair.hpp:1: includes parallel/triangulation/cavity.hpp: it is not below "
            "parallel/arithmetic in the order of rooms\n");
  add("parallel/arithmetic/pair.hpp", {}, "pardel::engine");
  EXPECT_EQ(violations_with("properties/checker/arithmetic/sum.hpp", {"../model/domain.hpp"}, "pardel::checker"),
            "properties/checker/arithmetic/sum.hpp:1: includes properties/checker/model/domain.hpp: it is not "
            "below properties/checker/arithmetic in the order of rooms\n");
}

TEST_F(StructureRule, domain_and_triangulation_do_not_use_each_other) {
  EXPECT_EQ(violations_with("parallel/domain/hull.cpp", {"../triangulation/cavity.hpp"}),
            "parallel/domain/hull.cpp:1: includes parallel/triangulation/cavity.hpp: it is not below "
            "parallel/domain in the order of rooms\n");
  add("parallel/domain/hull.cpp", {});
  EXPECT_EQ(violations_with("parallel/triangulation/flips.cpp", {"../domain/faces.hpp"}),
            "parallel/triangulation/flips.cpp:1: includes parallel/domain/faces.hpp: it is not below "
            "parallel/triangulation in the order of rooms\n");
}

TEST_F(StructureRule, a_public_header_includes_no_private_one) {
  EXPECT_EQ(violations_with("parallel/report.hpp", {"triangulation/cavity.hpp"}),
            "parallel/report.hpp:1: includes parallel/triangulation/cavity.hpp: a public header includes a private "
            "one\n");
  EXPECT_EQ(violations_with("parallel/report.hpp", {"../core/support/shortest.hpp"}),
            "parallel/report.hpp:1: includes core/support/shortest.hpp: a public header includes a private one\n");
}

TEST_F(StructureRule, a_private_header_opens_the_namespace_of_its_room) {
  EXPECT_EQ(violations_with("parallel/triangulation/flips.hpp", {}, "pardel"),
            "parallel/triangulation/flips.hpp: opens namespace pardel, but the namespace of its room is "
            "pardel::engine\n");
}

TEST_F(StructureRule, a_new_room_must_be_listed) {
  EXPECT_EQ(violations_with("parallel/smoothing/laplace.hpp", {}, "pardel::engine"),
            "parallel/smoothing/laplace.hpp: its folder is not in the list of rooms (tests/structure/rules.cpp)\n");
  add("parallel/smoothing/laplace.cpp", {});
  fs::remove(root_.path() / "parallel/smoothing/laplace.hpp");
  EXPECT_EQ(violations_with("gui/window.cpp", {}),
            "gui/window.cpp: its folder is not in the list of folders (tests/structure/rules.cpp)\n");
}

TEST_F(StructureRule, an_include_names_a_file_that_exists) {
  EXPECT_EQ(violations_with("core/mesh.cpp", {"meshes.hpp"}),
            "core/mesh.cpp:1: includes core/meshes.hpp: there is no such file\n");
}

TEST_F(StructureRule, files_do_not_include_each_other_in_a_circle) {
  add("parallel/triangulation/a.hpp", {"b.hpp"}, "pardel::engine");
  EXPECT_EQ(violations_with("parallel/triangulation/b.hpp", {"a.hpp"}, "pardel::engine"),
            "parallel/triangulation/a.hpp -> parallel/triangulation/b.hpp -> parallel/triangulation/a.hpp: files "
            "include each other in a circle\n");
}

TEST_F(StructureRule, a_class_of_the_engine_has_at_most_200_lines) {
  const auto with_lines = [](int lines) {
    std::string text = "class Long : public Base {\n";
    for (int i = 2; i < lines; ++i) text += "  int a" + std::to_string(i) + ";\n";
    return text + "};\n";
  };
  std::ofstream(root_.path() / "parallel/domain/faces.hpp") << with_lines(200);
  EXPECT_EQ(lines(violations(read_source_tree(root_.path()))), "");
  std::ofstream(root_.path() / "parallel/domain/faces.hpp") << "struct Short {};\n" << with_lines(201);
  EXPECT_EQ(lines(violations(read_source_tree(root_.path()))),
            "parallel/domain/faces.hpp:2: class Long has 201 lines, more than 200\n");
}

}  // namespace
}  // namespace pardel::structure
