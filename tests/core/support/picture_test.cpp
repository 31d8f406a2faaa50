#include "../../../core/support/picture.hpp"

#include <gtest/gtest.h>

#include "../../temporary_folder.hpp"

namespace pardel::drawing {
namespace {

std::string written(const Picture& picture) {
  const TemporaryFolder folder;
  EXPECT_TRUE(picture.write(folder / "picture.svg"));
  return folder.read("picture.svg");
}

TEST(Picture, the_window_has_a_margin_and_the_y_axis_points_up) {
  Picture picture;
  picture.polygon({{0, 0}, {2, 0}, {2, 1}}, "none", Ink::thin);
  const std::string svg = written(picture);
  EXPECT_NE(svg.find("viewBox=\"0 0 720 420\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("M 60 360 660 360 660 60Z"), std::string::npos) << svg;
}

TEST(Picture, shapes_are_painted_in_the_order_of_the_calls) {
  Picture picture;
  picture.line({0, 0}, {1, 1}, Ink::dashed);
  picture.dot({1, 0}, "black");
  picture.circle({{0, 0}, 1}, "red");
  const std::string svg = written(picture);
  const auto line = svg.find("<path"), dot = svg.find("fill=\"black\""), circle = svg.find("stroke=\"red\"");
  ASSERT_NE(circle, std::string::npos) << svg;
  EXPECT_LT(line, dot);
  EXPECT_LT(dot, circle);
}

TEST(Picture, a_circle_does_not_enlarge_the_window) {
  Picture picture, with_circle;
  for (Picture* p : {&picture, &with_circle}) p->line({0, 0}, {1, 0}, Ink::thick);
  with_circle.circle({{5, 7}, 100}, "red");
  const auto window = [](const std::string& svg) { return svg.substr(0, svg.find('>')); };
  EXPECT_EQ(window(written(picture)), window(written(with_circle)));
}

TEST(Picture, of_a_small_thing_is_as_large_as_that_of_a_large_thing) {
  std::string all[2];
  for (const bool small : {false, true}) {
    Picture picture;
    const double side = small ? 0.0625 : 16;
    picture.polygon({{0, 0}, {side, 0}, {side, side / 2}}, "none", Ink::thin);
    all[small ? 1 : 0] = written(picture);
  }
  EXPECT_EQ(all[0], all[1]);
}

}  // namespace
}  // namespace pardel::drawing
