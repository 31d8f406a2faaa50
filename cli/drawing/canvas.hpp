// A picture under construction: maps the plane to the picture, draws with cairo, and writes SVG or PNG.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../core/result.hpp"
#include "../../core/support/output_file.hpp"
#include "cairo_library.hpp"
#include "colour.hpp"

namespace pardel::cli {

/// A rectangle of the plane.
struct Window {
  Point low, high;
};

/// The smallest window around the points; a square of side 1 if it would be empty.
[[nodiscard]] Window window_around(std::span<const Point> points);

enum class PictureFormat : std::uint8_t { svg, png };

/// Sizes are in pixels for PNG and in user units for SVG.
struct Layout {
  PictureFormat format = PictureFormat::svg;
  double pixels = 1600;  ///< the longer side of the drawing, without margins
  bool legend = true;    ///< leaves a column free to the right of the drawing
  bool cut = false;      ///< nothing is drawn outside the window; otherwise marks at its border are drawn completely
};

class Canvas {
 public:
  Canvas(const CairoLibrary& cairo, const std::filesystem::path& file, const Window& window, const Layout& layout);

  /// The length that line widths and letters are multiples of: a thousandth of the longer side of the drawing.
  [[nodiscard]] double unit() const { return unit_; }
  /// The length of the plane's unit in the picture.
  [[nodiscard]] double scale() const { return scale_; }
  /// The size of the drawing, and its place.
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] double margin() const { return 20 * unit_; }
  [[nodiscard]] Point at(Point p) const;
  /// True if the point lies in the window.
  [[nodiscard]] bool contains(Point p) const;

  /// A convex polygon of the plane. Parts outside the window are not drawn.
  void add_polygon(std::span<const Point> corners);
  void add_line(Point a, Point b);
  /// Draws what was added since the last call.
  void fill(Colour colour);
  void stroke(Colour colour, double width);
  /// Draws an image over the whole drawing. `pixels`: rows from the top, premultiplied ARGB.
  void paint(std::vector<std::uint32_t>& pixels, int columns, int rows);

  /// A path of the picture; its places are those that at() returns.
  void move_to(Point place);
  void line_to(Point place);
  void close_path();
  /// Fill the path with smooth sides. The first one keeps it, to be stroked, too.
  void fill_and_keep(Colour colour);
  void fill_smoothly(Colour colour);
  /// A line of text that begins at the place.
  void write(const std::string& text, Point place, double height, Colour colour);

  /// From now on nothing is clipped: for the legend.
  void leave_drawing();

  /// Completes the file.
  [[nodiscard]] Status finish();

 private:
  [[nodiscard]] bool outside(std::span<const Point> corners) const;

  CairoLibrary cairo_;
  OutputFile out_;
  std::string name_;
  bool png_;
  Window window_;
  double unit_, scale_, width_, height_;
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context_;
};

}  // namespace pardel::cli
