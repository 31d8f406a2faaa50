// Triangles that are too small to be drawn one by one.
#pragma once

#include <array>
#include <vector>

#include "canvas.hpp"
#include "colour.hpp"

namespace pardel::cli {

/// An image with the mean colour of the triangles in each pixel. A triangle counts as much as the area that it covers.
class SmallTriangles {
 public:
  /// In pixels: a triangle is small if its longest side is shorter.
  static constexpr double largest = 3;

  explicit SmallTriangles(const Canvas& canvas);

  /// `corners`: places in the picture. `size`: the longest side in the picture. `edges`: the colour includes that of
  /// the edges, which shows the density of the mesh; without them it is the colour of the legend.
  void add(const std::array<Point, 3>& corners, double size, Colour fill, bool edges);
  void paint(Canvas& canvas);

 private:
  struct Sum {
    float red = 0, green = 0, blue = 0, area = 0;
  };

  int columns_, rows_;
  double margin_;
  std::vector<Sum> pixels_;  ///< empty until a triangle is added
};

}  // namespace pardel::cli
