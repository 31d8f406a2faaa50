// The lengths of the features of a GeoJSON file.
#include "../../cli/parse_geojson.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pardel::cli {
namespace {

/// A feature with the properties and the geometry.
std::string feature(const std::string& properties, const std::string& type, const std::string& coordinates) {
  return R"({"type": "Feature", "properties": {)" + properties + R"(}, "geometry": {"type": ")" + type +
         R"(", "coordinates": )" + coordinates + "}}";
}

Result<DrawnDomain> with_lengths(const std::string& features) {
  return parse_geojson(R"({"type": "FeatureCollection", "features": [)" + features + "]}", "a.geojson",
                       LengthProperty::read);
}

TEST(Lengths, of_points_lines_and_borders_of_polygons_are_sources) {
  const Result<DrawnDomain> drawn =
      with_lengths(feature(R"("length": 0.5)", "MultiPoint", "[[3, 4], [5, 6]]") + "," +
                   feature(R"("length": 2)", "LineString", "[[0, 0], [1, 0], [1, 1]]") + "," +
                   feature(R"("length": 7)", "Polygon", "[[[0, 0], [9, 0], [9, 9], [0, 0]]]"));
  ASSERT_TRUE(drawn) << drawn.error().message;
  ASSERT_EQ(drawn->sources.size(), 7U);
  EXPECT_EQ(drawn->sources[0], (SizeSource{{3, 4}, {3, 4}, 0.5, 0.5}));
  EXPECT_EQ(drawn->sources[1], (SizeSource{{5, 6}, {5, 6}, 0.5, 0.5}));
  EXPECT_EQ(drawn->sources[3], (SizeSource{{1, 0}, {1, 1}, 2, 2}));
  EXPECT_EQ(drawn->sources[6], (SizeSource{{9, 9}, {0, 0}, 7, 7}));
  EXPECT_EQ(drawn->polygons[0].length, 7);
}

TEST(Properties, of_a_feature_are_those_of_all_geometries_of_its_collection) {
  const Result<DrawnDomain> drawn = parse_geojson(
      R"({"type": "Feature", "properties": {"marker": 4, "attribute": 2, "length": 0.5},
          "geometry": {"type": "GeometryCollection", "geometries": [
            {"type": "LineString", "coordinates": [[5, 5], [6, 6]]},
            {"type": "GeometryCollection", "geometries": [
              {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 0]]]}]}]}})",
      "a.geojson", LengthProperty::read);
  ASSERT_TRUE(drawn) << drawn.error().message;
  ASSERT_EQ(drawn->pslg.segments.size(), 4U);
  for (const Segment& segment : drawn->pslg.segments) EXPECT_EQ(segment.marker, 4);
  ASSERT_EQ(drawn->polygons.size(), 1U);
  EXPECT_EQ(drawn->polygons[0].attribute, 2);
  EXPECT_EQ(drawn->sources.size(), 4U);
}

TEST(Holes, lie_outside_if_a_corner_does_and_none_lies_inside) {
  const std::vector<Point> outline = {{0, 0}, {6, 0}, {6, 6}, {3, 3}, {0, 6}};
  const auto outside = [&](const std::vector<Point>& hole) { return lies_outside(hole, outline); };
  EXPECT_FALSE(outside({{1, 1}, {2, 1}, {2, 2}})) << "inside";
  EXPECT_TRUE(outside({{7, 1}, {8, 1}, {8, 2}})) << "beside it";
  EXPECT_TRUE(outside({{-1, -1}, {9, -1}, {9, 9}, {-1, 9}})) << "around it";
  EXPECT_TRUE(outside({{2, 5}, {4, 5}, {3, 6}})) << "in a bay";
  EXPECT_TRUE(outside({{6, 2}, {8, 2}, {6, 4}})) << "along a side";
  EXPECT_FALSE(outside({{5, 1}, {8, 1}, {8, 2}})) << "it crosses a side, which the validation finds";
  EXPECT_FALSE(outside({{0, 0}, {6, 0}, {3, 3}})) << "all corners are on the outline";
  EXPECT_FALSE(
      lies_outside(std::vector<Point>{{0.1, 0.1}, {0.7, 0.7}, {0.3, 0.3}}, std::vector<Point>{{0, 0}, {1, 1}, {0, 1}}))
      << "corners on a side up to rounding";
}

TEST(Lengths, that_are_null_or_missing_are_none) {
  const Result<DrawnDomain> drawn = with_lengths(feature(R"("length": null)", "Point", "[3, 4]") + "," +
                                                 feature("", "Polygon", "[[[0, 0], [9, 0], [9, 9], [0, 0]]]"));
  ASSERT_TRUE(drawn) << drawn.error().message;
  EXPECT_TRUE(drawn->sources.empty());
  EXPECT_FALSE(drawn->polygons[0].length);
}

TEST(Lengths, that_are_wrong_are_named_with_their_place) {
  const auto failure = [](const std::string& length) {
    const std::string good = feature(R"("length": 1)", "Point", "[0, 0]");
    const Result<DrawnDomain> drawn =
        with_lengths(good + "," + good + "," + feature(R"("length": )" + length, "Point", "[3, 4]"));
    return drawn ? std::string() : drawn.error().message;
  };
  const std::string at = "a.geojson: features[2].properties.length: expected a length greater than 0, found ";
  EXPECT_EQ(failure("0"), at + "0");
  EXPECT_EQ(failure("-2.5"), at + "-2.5");
  EXPECT_EQ(failure("\"5 m\""), at + "\"5 m\"");
  EXPECT_EQ(failure("[1]"), at + "array");
  EXPECT_NE(failure("1e999").find("the number 1e999 is too large for a double"), std::string::npos);
}

TEST(Lengths, of_a_domain_may_be_anything) {
  const Result<DrawnDomain> drawn = parse_geojson(feature(R"("length": "5 m")", "Point", "[3, 4]"), "a.geojson");
  ASSERT_TRUE(drawn) << drawn.error().message;
  EXPECT_TRUE(drawn->sources.empty());
}

}  // namespace
}  // namespace pardel::cli
