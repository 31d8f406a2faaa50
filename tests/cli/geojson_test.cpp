// Domains in GeoJSON.
#include <cmath>
#include <string>

#include "../../core/formats.hpp"
#include "program.hpp"

namespace pardel::testing {
namespace {

/// Two neighbours with different markers, a ring that is a hole, a polygon that is a hole, a line and a point.
constexpr const char* bay = R"({"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {"marker": 2, "attribute": 1, "max_area": 0.01},
   "geometry": {"type": "Polygon", "coordinates": [
     [[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]], [[0.5, 0.5], [1, 0.5], [1, 1], [0.5, 1], [0.5, 0.5]]]}},
  {"type": "Feature", "properties": {"marker": 3, "attribute": 7, "name": "marsh"},
   "geometry": {"type": "Polygon", "coordinates": [[[2, 0], [3, 0.1], [3, 2], [2, 2], [2, 0]]]}},
  {"type": "Feature", "properties": {"hole": true, "marker": null},
   "geometry": {"type": "Polygon", "coordinates": [[[2.4, 0.6], [2.7, 0.6], [2.7, 0.9], [2.4, 0.6]]]}},
  {"type": "Feature", "properties": null, "geometry": {"type": "LineString", "coordinates": [[0.2, 1.5], [0.8, 1.7]]}},
  {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [1.5, 1.5, 3.25]}},
  {"type": "Feature", "properties": {"marker": 9}, "geometry": null}]}
)";

class GeoJson : public Workshop {
 protected:
  /// The domain of a file with this text.
  [[nodiscard]] Pslg domain(const std::string& text) const {
    write("d.geojson", text);
    const Ran ran = pardel({"convert", "d.geojson", "d.poly", "-q"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    const Result<Pslg> pslg = read_pslg(folder_ / "work" / "d.poly");
    EXPECT_TRUE(pslg);
    return pslg ? *pslg : Pslg{};
  }
  /// The message for a wrong file, which must be refused with the code of invalid input.
  [[nodiscard]] std::string refusal(const std::string& text) const {
    write("w.json", text);
    const Ran ran = pardel({"mesh", "w.json", "-o", "w.vtu"});
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_FALSE(exists("w.vtu"));
    return ran.err;
  }
};

TEST_F(GeoJson, shared_edges_of_polygons_become_one_segment_with_the_first_marker) {
  const Pslg pslg = domain(bay);
  EXPECT_EQ(pslg.points.size(), 16U);
  EXPECT_EQ(pslg.points[15], (Point{1.5, 1.5}));
  ASSERT_EQ(pslg.segments.size(), 15U);
  EXPECT_EQ(pslg.segments[1], (Segment{1, 2, 2}));
  EXPECT_EQ(pslg.segments[8], (Segment{1, 8, 3}));
  EXPECT_EQ(pslg.segments[14], (Segment{13, 14, 0}));
}

TEST_F(GeoJson, rings_and_polygons_that_are_holes_are_holes_and_properties_make_regions) {
  const Pslg pslg = domain(bay);
  EXPECT_EQ(pslg.holes.size(), 2U);
  ASSERT_EQ(pslg.regions.size(), 2U);
  EXPECT_EQ(pslg.regions[0].attribute, 1);
  EXPECT_EQ(pslg.regions[0].max_area, 0.01);
  EXPECT_EQ(pslg.regions[1].attribute, 7);
  EXPECT_TRUE(std::isinf(pslg.regions[1].max_area));
}

TEST_F(GeoJson, is_meshed_and_checked_like_a_poly) {
  write("bay.geojson", bay);
  const Ran ran = pardel({"mesh", "bay.geojson", "-o", "bay.vtu", "--regions", "--check", "-q"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(pardel({"check", "bay.geojson", "bay.vtu", "--regions"}).exit_code, 0);
  EXPECT_TRUE(holds(pardel({"doctor", "bay.geojson"}).out, {"2 holes, 2 regions: no problem"}));
  EXPECT_EQ(pardel({"draw", "bay.geojson", "bay.svg"}).exit_code, 0);
}

TEST_F(GeoJson, a_ring_that_other_polygons_fill_is_a_hole_only_where_they_leave_a_gap) {
  const std::string outer = R"([[[0,0],[4,0],[4,4],[0,4],[0,0]],[[1,1],[3,1],[3,3],[1,3],[1,1]]])";
  const auto with = [&](const std::string& inner) {
    return domain(R"({"type": "MultiPolygon", "coordinates": [)" + outer + "," + inner + "]}");
  };
  EXPECT_TRUE(with("[[[1,1],[3,1],[3,3],[1,3],[1,1]]]").holes.empty());
  const Pslg half = with("[[[1,1],[2,1],[2,3],[1,3],[1,1]]]");
  ASSERT_EQ(half.holes.size(), 1U);
  EXPECT_GT(half.holes[0].x, 2);
  EXPECT_LT(half.holes[0].x, 3);
}

TEST_F(GeoJson, a_space_between_polygons_is_a_hole) {
  const Pslg pslg = domain(R"({"type": "GeometryCollection", "geometries": [
    {"type": "Polygon", "coordinates": [[[0,0],[3,0],[2,1],[1,1],[0,0]]]},
    {"type": "Polygon", "coordinates": [[[3,0],[3,3],[2,2],[2,1],[3,0]]]},
    {"type": "MultiPolygon", "coordinates": [[[[3,3],[0,3],[1,2],[2,2],[3,3]]], [[[0,3],[0,0],[1,1],[1,2],[0,3]]]]}]})");
  ASSERT_EQ(pslg.holes.size(), 1U);
  EXPECT_GT(pslg.holes[0].x, 1);
  EXPECT_LT(pslg.holes[0].x, 2);
  EXPECT_FALSE(pslg.has_segment_markers);
}

TEST_F(GeoJson, of_lines_only_is_a_domain_without_holes_but_those_that_are_polygons) {
  const std::string lines = R"({"type": "MultiLineString", "coordinates": [[[0,0],[4,0],[4,4],[0,4],[0,0]],
    [[1,1],[2,1],[2,2],[1,1]]]})";
  EXPECT_TRUE(domain(lines).holes.empty());
  const Pslg pslg = domain(R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": )" + lines +
                           R"(}, {"type": "Feature", "properties": {"hole": true}, "geometry":
    {"type": "Polygon", "coordinates": [[[3,1],[3.5,1],[3.5,2],[3,1]]]}}]})");
  EXPECT_EQ(pslg.holes.size(), 1U);
}

TEST_F(GeoJson, seeds_are_inside_where_polygons_have_to_be_repaired) {
  write("cross.json", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"attribute": 4}, "geometry": {"type": "Polygon", "coordinates":
      [[[0,0],[4,0],[4,4],[0,4],[0,0]], [[1,1],[2,1],[2,2],[1,2],[1,1]]]}},
    {"type": "Feature", "properties": {"attribute": 5}, "geometry": {"type": "Polygon", "coordinates":
      [[[3,3],[6,3],[6,6],[3,6],[3,3]]]}}]})");
  EXPECT_EQ(pardel({"mesh", "cross.json", "-o", "c.vtu"}).exit_code, 3);
  const Ran ran = pardel({"mesh", "cross.json", "-o", "c.vtu", "--repair", "--check"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"1 hole, 3 regions", "area 23"})) << ran;
}

TEST_F(GeoJson, coordinates_are_the_nearest_doubles) {
  const Pslg pslg = domain(R"({"type": "LineString", "coordinates": [[0.1, -0.0], [1e-300, 123456789.12345679]]})");
  EXPECT_EQ(pslg.points[0], (Point{0.1, 0}));
  EXPECT_EQ(pslg.points[1], (Point{1e-300, 123456789.12345679}));
}

TEST_F(GeoJson, wrong_json_is_an_error_with_line_and_column) {
  EXPECT_TRUE(holds(refusal("{\"type\": \"Polygon\",\n \"coordinates\": [[[0,0],[1,0],,[1,1]]]}"), {"w.json:2:31: "}));
  EXPECT_TRUE(holds(refusal("{\"type\": \"Point\",\n \"coordinates\": [0, 1e999]}"),
                    {"w.json:2:21: the number 1e999 is too large for a double"}));
  EXPECT_TRUE(holds(refusal(""), {"w.json:1:1: "}));
}

TEST_F(GeoJson, a_wrong_value_is_an_error_with_its_place_in_the_file) {
  const auto of_feature = [&](const std::string& properties, const std::string& geometry) {
    return refusal(R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": null}, )"
                   R"({"type": "Feature", "properties": )" +
                   properties + R"(, "geometry": )" + geometry + "}]}");
  };
  const auto polygon = [](const std::string& ring) {
    return R"({"type": "Polygon", "coordinates": [[[0,0],[9,0],[9,9],[0,0]], )" + ring + "]}";
  };
  const std::string at = "w.json: features[1].geometry.coordinates[1]";
  EXPECT_TRUE(holds(of_feature("{}", polygon("[[1,1],[2,\"1\"],[2,2],[1,1]]")),
                    {at + "[1]: expected a position, two numbers, found array"}));
  EXPECT_TRUE(holds(of_feature("{}", polygon("[[1,1],[2,1],[2,2],[1,2]]")),
                    {at + "[3]: expected the first position of the ring, which closes it, found array"}));
  EXPECT_TRUE(holds(of_feature("{}", polygon("[[1,1],[2,1],[1,1]]")),
                    {at + ": expected at least four positions of a ring, found array"}));
  EXPECT_TRUE(holds(of_feature("{}", polygon("[[10,1],[12,1],[12,2],[10,1]]")),
                    {at + ": expected a hole inside the first ring of the polygon, found a ring outside it"}));
  EXPECT_TRUE(holds(of_feature("{}", polygon("7")), {at + ": expected an array of positions, found 7"}));
  EXPECT_TRUE(holds(of_feature("{}", R"({"type": "Curve"})"),
                    {"features[1].geometry.type: expected the type of a GeoJSON object, found \"Curve\""}));
  EXPECT_TRUE(holds(of_feature(R"({"marker": 1.5})", "null"),
                    {"features[1].properties.marker: expected a whole number of 32 bits, found 1.5"}));
  EXPECT_TRUE(holds(of_feature(R"({"max_area": 0})", "null"),
                    {"features[1].properties.max_area: expected an area greater than 0, found 0"}));
  EXPECT_TRUE(holds(of_feature(R"({"attribute": "sand"})", "null"),
                    {"features[1].properties.attribute: expected a number, found \"sand\""}));
  EXPECT_TRUE(
      holds(of_feature(R"({"hole": 1})", "null"), {"features[1].properties.hole: expected true or false, found 1"}));
  EXPECT_TRUE(holds(refusal("[1]"), {"w.json: expected a GeoJSON object, found array"}));
  EXPECT_TRUE(holds(refusal("{}"), {"w.json: type: expected the type of a GeoJSON object, found null"}));
}

TEST_F(GeoJson, is_recognised_on_standard_input_by_its_brace) {
  for (const std::string before : {"", " \r\n\t\n", "\xEF\xBB\xBF"}) {
    write("bay.geojson", before + bay);
    ASSERT_EQ(pardel({"mesh", "bay.geojson", "-o", "named.vtu"}).exit_code, 0);
    const RunOptions from{.in_file = "bay.geojson"};
    const Ran meshed = pardel({"mesh", "-", "-o", "streamed.vtu"}, from);
    EXPECT_EQ(meshed.exit_code, 0) << meshed;
    EXPECT_EQ(read("streamed.vtu"), read("named.vtu"));
    EXPECT_EQ(pardel({"check", "-", "named.vtu"}, from).exit_code, 0);
    EXPECT_EQ(pardel({"doctor", "/dev/stdin"}, from).exit_code, 0);
    EXPECT_EQ(pardel({"draw", "-", "bay.svg"}, from).exit_code, 0);
    ASSERT_EQ(pardel({"convert", "bay.geojson", "named.poly"}).exit_code, 0);
    EXPECT_EQ(pardel({"convert", "-", "-"}, from).out, read("named.poly"));
  }
}

TEST_F(GeoJson, that_is_wrong_on_standard_input_is_an_error_with_line_and_column) {
  write("wrong.json", "\n{\"type\": }\n");
  const Ran ran = pardel({"mesh", "-", "-o", "w.vtu"}, {.in_file = "wrong.json"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"pardel: -:2:10: "})) << ran;
}

TEST_F(GeoJson, collections_that_are_nested_too_deeply_are_refused) {
  std::string text = R"({"type": "Point", "coordinates": [0, 0]})";
  for (int i = 0; i < 20; ++i) text = R"({"type": "GeometryCollection", "geometries": [)" + text + "]}";
  EXPECT_TRUE(holds(refusal(text), {"expected at most 16 collections in each other"}));
  EXPECT_EQ(refusal(std::string(200'000, '[')).find("terminate"), std::string::npos);
}

TEST_F(GeoJson, a_file_that_cannot_be_read_is_an_error_of_files) {
  const Ran missing = pardel({"mesh", "none.geojson", "-o", "w.vtu"});
  EXPECT_EQ(missing.exit_code, 5) << missing;
  EXPECT_TRUE(holds(missing.err, {"none.geojson: cannot be opened"}));
  std::filesystem::create_directory(folder_ / "work" / "folder.json");
  const Ran folder = pardel({"mesh", "folder.json", "-o", "w.vtu"});
  EXPECT_EQ(folder.exit_code, 5) << folder;
  EXPECT_TRUE(holds(folder.err, {"folder.json: cannot be read"}));
}

}  // namespace
}  // namespace pardel::testing
