// Small SVG pictures: triangles, circles, dots. y points up, as in the data; the window fits everything but circles.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../core/result.hpp"

namespace pardel::properties {

struct Circle {
  Point centre;
  double radius = 0;
};

enum class Ink : std::uint8_t { thin, thick, dashed };

/// A light colour for the k-th thing, different from its neighbours'.
[[nodiscard]] std::string tint(std::size_t k);

/// Shapes in data coordinates, in the order in which they are painted. `fill` and `colour` are SVG colours.
class Picture {
 public:
  void polygon(std::vector<Point> corners, std::string fill, Ink ink);
  void line(Point a, Point b, Ink ink);
  void circle(const Circle& circle, std::string colour);
  void dot(Point at, std::string colour);

  Status write(const std::filesystem::path& file) const;

 private:
  struct Shape {
    std::vector<Point> corners;  ///< one: a dot, or a circle's centre
    double radius;               ///< 0: no circle
    std::string fill;
    Ink ink;
  };
  std::vector<Shape> shapes_;
};

}  // namespace pardel::properties
