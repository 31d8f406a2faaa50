#include "small_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pardel::cli {
namespace {

/// The colour of a triangle together with its edges. The edges cover more of a smaller triangle: at `largest` pixels
/// about as much as drawn edges would, and 12 % more each time the size halves.
Colour with_edges(Colour fill, double size) {
  const double halvings = std::log2(SmallTriangles::largest / std::max(size, 1e-6));
  return mixed(fill, edge_colour, std::clamp(0.1 + 0.12 * halvings, 0.0, 0.85));
}

std::uint32_t argb(double red, double green, double blue, double alpha) {
  const auto byte = [&](double value) { return static_cast<std::uint32_t>(std::lround(255 * alpha * value)); };
  return static_cast<std::uint32_t>(std::lround(255 * alpha)) << 24 | byte(red) << 16 | byte(green) << 8 | byte(blue);
}

}  // namespace

SmallTriangles::SmallTriangles(const Canvas& canvas)
    : columns_(std::max(1, static_cast<int>(std::ceil(canvas.width())))),
      rows_(std::max(1, static_cast<int>(std::ceil(canvas.height())))),
      margin_(canvas.margin()) {}

void SmallTriangles::add(const std::array<Point, 3>& c, double size, Colour fill, bool edges) {
  if (pixels_.empty()) pixels_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  const double area = std::abs((c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x)) / 2;
  const Colour colour = edges ? with_edges(fill, size) : fill;
  // The triangle is cut into n * n equal ones with sides of at most half a pixel. Each counts at its centroid.
  const int n = std::max(1, static_cast<int>(std::ceil(2 * size)));
  const double share = area / (n * n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 2 * (n - i) - 1; ++j) {
      const int pair = j / 2;  // of two triangles with a common side
      const double offset = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
      const double u = (i + offset) / n, v = (pair + offset) / n;
      const double x = c[0].x + u * (c[1].x - c[0].x) + v * (c[2].x - c[0].x) - margin_;
      const double y = c[0].y + u * (c[1].y - c[0].y) + v * (c[2].y - c[0].y) - margin_;
      if (!(x >= 0 && x < columns_ && y >= 0 && y < rows_)) continue;
      Sum& sum =
          pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)];
      sum.red += static_cast<float>(share * colour.red);
      sum.green += static_cast<float>(share * colour.green);
      sum.blue += static_cast<float>(share * colour.blue);
      sum.area += static_cast<float>(share);
    }
  }
}

void SmallTriangles::paint(Canvas& canvas) {
  if (pixels_.empty()) return;
  std::vector<std::uint32_t> image(pixels_.size());
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const Sum& sum = pixels_[i];
    if (!(sum.area > 0)) continue;
    // Shares are samples of the area. So a pixel that is covered to more than a half counts as covered.
    const double alpha = std::min(1.0, 2.0 * static_cast<double>(sum.area));
    image[i] = argb(sum.red / sum.area, sum.green / sum.area, sum.blue / sum.area, alpha);
  }
  canvas.paint(image, columns_, rows_);
}

}  // namespace pardel::cli
