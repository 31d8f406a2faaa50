// pardel mesh and check with a GeoJSON file for --sources.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;

class DrawnLengths : public Workshop {
 protected:
  /// Two unit squares side by side, with the attributes 1 and 2. The second one has the length 0.05.
  DrawnLengths() {
    write("two.geojson", collection({feature(R"("attribute": 1)", polygon({square(0, 0, 1, 1)})),
                                     feature(R"("attribute": 2, "length": 0.05)", polygon({square(1, 0, 2, 1)}))}));
  }

  static std::string square(double left, double bottom, double right, double top) {
    return json{{left, bottom}, {right, bottom}, {right, top}, {left, top}, {left, bottom}}.dump();
  }
  static std::string polygon(const std::vector<std::string>& rings) { return geometry("Polygon", list(rings)); }
  static std::string geometry(const std::string& type, const std::string& coordinates) {
    return R"({"type": ")" + type + R"(", "coordinates": )" + coordinates + "}";
  }
  static std::string feature(const std::string& properties, const std::string& shape) {
    return R"({"type": "Feature", "properties": {)" + properties + R"(}, "geometry": )" + shape + "}";
  }
  static std::string collection(const std::vector<std::string>& features) {
    return R"({"type": "FeatureCollection", "features": )" + list(features) + "}";
  }

  /// The report on the mesh of two.geojson, which is checked.
  [[nodiscard]] json meshed(const std::string& sources, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"two.geojson", "-o", "m.ele", "--grading", "1", "--check"};
    if (!sources.empty()) arguments.insert(arguments.end(), {"--sources", sources});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return report(arguments);
  }
  [[nodiscard]] int triangles(const std::string& sources) const { return meshed(sources)["mesh"]["triangles"]; }
  /// The same as --sources and as a text of rules.
  [[nodiscard]] bool are_equal(const std::string& drawing, const std::string& rules) const {
    write("drawn.json", drawing);
    write("rules.sources", rules);
    return meshed("drawn.json")["digest"] == meshed("rules.sources")["digest"];
  }
  [[nodiscard]] Ran check(const std::string& sources) const {
    return pardel({"check", "two.geojson", "m.ele", "--grading", "1", "--sources", sources});
  }
  /// The message for sources that are refused.
  [[nodiscard]] std::string refusal(const std::string& sources) const {
    const Ran ran = pardel({"mesh", "two.geojson", "-o", "w.vtu", "--grading", "1", "--sources", sources});
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_FALSE(exists("w.vtu"));
    return ran.err;
  }

 private:
  static std::string list(const std::vector<std::string>& elements) {
    std::string text;
    for (const std::string& each : elements) text += (text.empty() ? "" : ",\n") + each;
    return "[" + text + "]";
  }
};

TEST_F(DrawnLengths, of_a_domain_count_only_if_it_is_given_as_sources) {
  const json without = meshed(""), with = meshed("two.geojson");
  EXPECT_LT(without["mesh"]["triangles"], 100);
  EXPECT_GT(with["mesh"]["triangles"], 1'000) << "a unit square with edges of 0.05 at most";
  EXPECT_EQ(with["goal"]["sources"], "two.geojson");
  EXPECT_EQ(meshed("two.geojson", {"--threads", "1"})["digest"], meshed("two.geojson", {"--threads", "2"})["digest"]);
}

TEST_F(DrawnLengths, are_judged_by_the_check) {
  static_cast<void>(meshed("two.geojson"));
  const Ran right = check("two.geojson");
  EXPECT_EQ(right.exit_code, 0) << right;
  static_cast<void>(meshed(""));
  const Ran coarse = check("two.geojson");
  EXPECT_EQ(coarse.exit_code, 1) << coarse;
  EXPECT_TRUE(holds(coarse.out + coarse.err, {"size exceeded"}));
}

TEST_F(DrawnLengths, make_the_mesh_that_the_same_rules_make) {
  EXPECT_TRUE(are_equal(feature(R"("length": 0.02)", geometry("Point", "[0.5, 0.5]")), "point 0.5 0.5 0.02\n"));
  EXPECT_TRUE(are_equal(feature(R"("length": 0.02)", geometry("MultiPoint", "[[0.5, 0.5], [1.5, 0.2]]")),
                        "point 0.5 0.5 0.02\npoint 1.5 0.2 0.02\n"));
  EXPECT_TRUE(are_equal(feature(R"("length": 0.05)", polygon({square(1, 0, 2, 1)})), "region 2 0.05\n"));
}

TEST_F(DrawnLengths, on_a_line_hold_along_all_of_it) {
  write("line.json", feature(R"("length": 0.02)", geometry("LineString", "[[0.2, 0.5], [1.8, 0.5], [1.8, 0.6]]")));
  write("ends.json", feature(R"("length": 0.02)", geometry("MultiPoint", "[[0.2, 0.5], [1.8, 0.5], [1.8, 0.6]]")));
  EXPECT_GT(triangles("line.json"), 2 * triangles("ends.json"));
  static_cast<void>(meshed("ends.json"));
  EXPECT_EQ(check("line.json").exit_code, 1);
}

TEST_F(DrawnLengths, do_not_hold_in_the_hole_of_a_polygon) {
  // The border of the hole has the length, so inside the hole lengths grow from there.
  const std::string outer = square(0, 0, 1, 1);
  write("ring.json", feature(R"("length": 0.02)", polygon({outer, square(0.1, 0.1, 0.9, 0.9)})));
  write("full.json", feature(R"("length": 0.02)", polygon({outer})));
  const int ring = triangles("ring.json"), full = triangles("full.json");
  EXPECT_GT(ring, 2'000);
  EXPECT_LT(ring, full * 3 / 4);
}

TEST_F(DrawnLengths, of_nested_polygons_are_the_least) {
  const std::string outer = polygon({square(0, 0, 2, 1)}), inner = polygon({square(0.25, 0.25, 0.75, 0.75)});
  const auto with = [&](const std::string& of_outer, const std::string& of_inner, bool inner_first) {
    const std::string a = feature("\"length\": " + of_outer, outer), b = feature("\"length\": " + of_inner, inner);
    write("nested.json", inner_first ? collection({b, a}) : collection({a, b}));
    return meshed("nested.json");
  };
  const json fine_inside = with("0.1", "0.02", false);
  EXPECT_EQ(with("0.1", "0.02", true)["digest"], fine_inside["digest"]);
  write("outer.json", feature(R"("length": 0.1)", outer));
  EXPECT_GT(fine_inside["mesh"]["triangles"], triangles("outer.json") + 500);
  const json fine_outside = with("0.05", "0.5", true);
  write("outer.json", feature(R"("length": 0.05)", outer));
  EXPECT_EQ(meshed("outer.json")["digest"], fine_outside["digest"]);
}

TEST_F(DrawnLengths, hold_nowhere_outside_the_polygons) {
  // Far from the polygon, in all directions, the lengths are those of the domain.
  write("small.json", feature(R"("length": 0.01)", polygon({square(0.45, 0.45, 0.55, 0.55)})));
  EXPECT_LT(triangles("small.json"), 2'000) << "0.01 everywhere needs about 40,000";
  write("beside.json", feature(R"("length": 0.01)", polygon({square(100, 100, 101, 101)})));
  EXPECT_EQ(meshed("beside.json")["digest"], meshed("")["digest"]);
}

TEST_F(DrawnLengths, of_polygons_may_be_crossed_by_other_shapes) {
  write("crossed.json", collection({feature(R"("length": 0.1)", polygon({square(0.25, 0.25, 0.75, 0.75)})),
                                    feature(R"("length": 0.1)", geometry("LineString", "[[0.1, 0.5], [1.9, 0.5]]")),
                                    feature("", polygon({square(0.5, 0.5, 1.5, 0.9)})),
                                    feature(R"("length": 0.1)", geometry("Point", "[0.25, 0.5]"))}));
  EXPECT_GT(triangles("crossed.json"), 100);
}

TEST_F(DrawnLengths, of_polygons_that_cross_are_refused_or_repaired) {
  // The first point of the file is in no polygon with a length.
  write("cross.json", collection({feature("", geometry("Point", "[7, 7]")),
                                  feature(R"("length": 0.1)", polygon({square(0.1, 0.1, 1, 0.6)})),
                                  feature(R"("length": 0.05)", polygon({square(0.5, 0.3, 1.5, 0.9)}))}));
  EXPECT_TRUE(holds(refusal("cross.json"), {"cross.json: 2 problems", "Segments 2-3 and 5-6 cross at (1, 0.3).",
                                            "Segments 3-4 and 8-5 cross at (0.5, 0.6).", "'pardel mesh --repair'"}));
  EXPECT_GT(meshed("cross.json", {"--repair"})["mesh"]["triangles"], 500);
  const Ran same = check("cross.json");
  EXPECT_EQ(same.exit_code, 0) << same;
}

TEST_F(DrawnLengths, that_cannot_be_read_are_refused_with_their_place) {
  write("zero.json", collection({feature("", "null"), feature(R"("length": 0)", "null")}));
  EXPECT_TRUE(holds(refusal("zero.json"),
                    {"zero.json: features[1].properties.length: expected a length greater than 0, found 0"}));
  write("none.json", collection({feature(R"("length": null)", polygon({square(0, 0, 1, 1)}))}));
  EXPECT_TRUE(holds(refusal("none.json"), {"none.json: expected an edge length: no point, line or polygon has the "
                                           "property 'length'"}));
  const Ran missing = pardel({"mesh", "two.geojson", "-o", "m.ele", "--grading", "1", "--sources", "x.geojson"});
  EXPECT_EQ(missing.exit_code, 5) << missing;
}

}  // namespace
}  // namespace pardel::testing
