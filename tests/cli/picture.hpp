// Reads a PNG that the program wrote.
#pragma once

#include <cairo.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace pardel::testing {

class Picture {
 public:
  explicit Picture(const std::filesystem::path& png) : surface_(cairo_image_surface_create_from_png(png.c_str())) {}

  [[nodiscard]] bool ok() const { return cairo_surface_status(surface_.get()) == CAIRO_STATUS_SUCCESS; }
  [[nodiscard]] int width() const { return cairo_image_surface_get_width(surface_.get()); }
  [[nodiscard]] int height() const { return cairo_image_surface_get_height(surface_.get()); }
  /// 0xRRGGBB
  [[nodiscard]] std::uint32_t at(int x, int y) const {
    const unsigned char* row =
        cairo_image_surface_get_data(surface_.get()) + y * cairo_image_surface_get_stride(surface_.get());
    return reinterpret_cast<const std::uint32_t*>(row)[x] & 0xFFFFFF;
  }
  /// The mean of red, green and blue over a rectangle, from 0 to 255.
  [[nodiscard]] double brightness(int x0, int y0, int x1, int y1) const {
    double sum = 0;
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) sum += (at(x, y) >> 16) + (at(x, y) >> 8 & 0xFF) + (at(x, y) & 0xFF);
    return sum / (3.0 * (x1 - x0) * (y1 - y0));
  }

 private:
  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
};

}  // namespace pardel::testing
