// The seeds of drawings with known areas.
#include "../../cli/place_seeds.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "../../cli/parse_geojson.hpp"
#include "../../fuzz/drawn_cells.hpp"

namespace pardel::cli {
namespace {

TEST(Seeds, make_regions_with_the_areas_that_were_drawn_and_holes_of_the_rest) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    generators::Random random(seed);
    const fuzz::DrawnCells cells = fuzz::any_cells(random);
    Result<DrawnDomain> drawn = parse_geojson(cells.text, "cells.geojson");
    ASSERT_TRUE(drawn) << drawn.error().message;
    ASSERT_EQ(fuzz::difference(place_seeds(std::move(*drawn)), cells), "") << cells.text;
  }
}

TEST(Seeds, of_the_last_of_several_polygons_count) {
  const auto square = [](double low, double high, double attribute) {
    return DrawnPolygon{{{{low, low}, {high, low}, {high, high}, {low, high}}}, false, attribute, {}};
  };
  DrawnDomain domain;
  for (const double at : {0.0, 1.0}) {
    const auto first = static_cast<Index>(domain.pslg.points.size());
    domain.polygons.push_back(square(at, 4 - at, at + 1));
    for (const Point& p : domain.polygons.back().rings.front()) domain.pslg.points.push_back(p);
    for (Index i = 0; i < 4; ++i) domain.pslg.segments.push_back({first + i, first + (i + 1) % 4});
  }
  const Pslg pslg = place_seeds(std::move(domain));
  EXPECT_TRUE(pslg.holes.empty());
  ASSERT_EQ(pslg.regions.size(), 2U);
  for (const Region& region : pslg.regions) {
    const bool is_inside = region.seed.x > 1 && region.seed.x < 3 && region.seed.y > 1 && region.seed.y < 3;
    EXPECT_EQ(region.attribute, is_inside ? 2 : 1);
  }
}

TEST(Seeds, of_a_polygon_with_a_largest_area_and_no_attribute_make_a_region) {
  DrawnDomain domain;
  domain.pslg.points = {{0, 0}, {4, 0}, {0, 4}};
  domain.pslg.segments = {{0, 1}, {1, 2}, {2, 0}};
  domain.polygons = {{{{{0, 0}, {4, 0}, {0, 4}}}, false, {}, 0.5}};
  const Pslg pslg = place_seeds(std::move(domain));
  ASSERT_EQ(pslg.regions.size(), 1U);
  EXPECT_EQ(pslg.regions[0].attribute, 0);
  EXPECT_EQ(pslg.regions[0].max_area, 0.5);
}

TEST(Seeds, of_polygons_along_one_line_end_without_a_mesh) {
  DrawnDomain domain;
  domain.pslg.points = {{0, 0}, {1, 0}, {2, 0}};
  domain.pslg.segments = {{0, 1}, {1, 2}, {2, 0}};
  domain.polygons = {{{{{0, 0}, {1, 0}, {2, 0}}}, false, 1.0, {}}};
  EXPECT_TRUE(place_seeds(std::move(domain)).regions.empty());
}

}  // namespace
}  // namespace pardel::cli
