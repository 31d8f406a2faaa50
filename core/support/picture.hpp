// Pictures: small SVG files with polygons, lines, circles and dots. The y-axis points up. The visible window contains
// all shapes except circles, which may lie partly outside.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "../pslg.hpp"
#include "../result.hpp"

namespace pardel::drawing {

struct Circle {
  Point centre;
  double radius = 0;
};

enum class Ink : std::uint8_t { thin, thick, dashed };

/// A light SVG colour for number k, different from the colours of k - 1 and k + 1.
[[nodiscard]] std::string tint(std::size_t k);

/// Shapes are in data coordinates and are painted in the order of the calls. `fill` and `colour` are SVG colours.
class Picture {
 public:
  void polygon(std::vector<Point> corners, std::string fill, Ink ink);
  void line(Point a, Point b, Ink ink);
  void circle(const Circle& circle, std::string colour);
  void dot(Point at, std::string colour);

  /// Writes the picture to an SVG file.
  [[nodiscard]] Status write(const std::filesystem::path& file) const;

 private:
  struct Shape {
    std::vector<Point> corners;  ///< one point for a dot; the centre of a circle
    double radius;               ///< 0 if the shape is not a circle
    std::string fill;
    Ink ink;
  };
  std::vector<Shape> shapes_;
};

}  // namespace pardel::drawing
