#include "canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace pardel::cli {
namespace {

constexpr double legend_width = 210;  // in units

cairo_status_t write_bytes(void* out, const unsigned char* bytes, unsigned int size) {
  auto& file = *static_cast<OutputFile*>(out);
  file.write({reinterpret_cast<const char*>(bytes), size});
  return file.ok() ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

/// Cuts off the part of a convex polygon on one side of a line: where sign * (coordinate - limit) > 0.
std::vector<Point> cut(const std::vector<Point>& corners, double Point::*coordinate, double limit, double sign) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point p = corners[i], q = corners[(i + 1) % corners.size()];
    const double of_p = sign * (p.*coordinate - limit), of_q = sign * (q.*coordinate - limit);
    if (of_p <= 0) kept.push_back(p);
    if ((of_p < 0 && of_q > 0) || (of_p > 0 && of_q < 0)) {
      const double t = of_p / (of_p - of_q);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return kept;
}

/// The polygon within a window a little larger than the drawing: cairo's coordinates are limited to 2^23 pixels.
std::vector<Point> clipped(std::span<const Point> corners, const Window& window) {
  const double margin = 0.1 * std::max(window.high.x - window.low.x, window.high.y - window.low.y);
  std::vector<Point> polygon(corners.begin(), corners.end());
  polygon = cut(polygon, &Point::x, window.low.x - margin, -1);
  polygon = cut(polygon, &Point::x, window.high.x + margin, 1);
  polygon = cut(polygon, &Point::y, window.low.y - margin, -1);
  return cut(polygon, &Point::y, window.high.y + margin, 1);
}

}  // namespace

Window window_around(std::span<const Point> points) {
  if (points.empty()) return {{0, 0}, {1, 1}};
  Window window{points[0], points[0]};
  for (const Point p : points) {
    window.low = {std::min(window.low.x, p.x), std::min(window.low.y, p.y)};
    window.high = {std::max(window.high.x, p.x), std::max(window.high.y, p.y)};
  }
  const bool empty = window.low == window.high;
  return empty ? Window{{window.low.x - 0.5, window.low.y - 0.5}, {window.low.x + 0.5, window.low.y + 0.5}} : window;
}

Canvas::Canvas(const CairoLibrary& cairo, const std::filesystem::path& file, const Window& window, const Layout& layout)
    : cairo_(cairo),
      out_(file),
      name_(file.string()),
      png_(layout.format == PictureFormat::png),
      window_(window),
      surface_(nullptr, cairo.surface_destroy),
      context_(nullptr, cairo.destroy) {
  const double extent = std::max(window.high.x - window.low.x, window.high.y - window.low.y);
  scale_ = layout.pixels / extent;
  unit_ = layout.pixels / 1000;
  width_ = (window.high.x - window.low.x) * scale_;
  height_ = (window.high.y - window.low.y) * scale_;
  // The legend needs some height, even next to a flat drawing.
  const double page_width = std::ceil(width_ + 2 * margin() + (layout.legend ? legend_width * unit_ : 0));
  const double page_height = std::ceil(std::max(height_, (layout.legend ? 420 : 0) * unit_) + 2 * margin());
  surface_.reset(png_ ? cairo_.image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(page_width),
                                                    static_cast<int>(page_height))
                      : cairo_.svg_surface_create_for_stream(write_bytes, &out_, page_width, page_height));
  context_.reset(cairo_.create(surface_.get()));
  cairo_.set_source_rgb(context_.get(), 1, 1, 1);
  cairo_.paint(context_.get());
  cairo_.set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_.set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_.select_font_face(context_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_.save(context_.get());
  const double rim = layout.cut ? 0 : margin() / 2;
  cairo_.rectangle(context_.get(), margin() - rim, margin() - rim, width_ + 2 * rim, height_ + 2 * rim);
  cairo_.clip(context_.get());
}

Point Canvas::at(Point p) const {
  return {margin() + (p.x - window_.low.x) * scale_, margin() + (window_.high.y - p.y) * scale_};
}

bool Canvas::contains(Point p) const {
  return p.x >= window_.low.x && p.x <= window_.high.x && p.y >= window_.low.y && p.y <= window_.high.y;
}

bool Canvas::outside(std::span<const Point> corners) const {
  const auto all = [&](const auto& beyond) { return std::ranges::all_of(corners, beyond); };
  return all([&](Point p) { return p.x < window_.low.x; }) || all([&](Point p) { return p.x > window_.high.x; }) ||
         all([&](Point p) { return p.y < window_.low.y; }) || all([&](Point p) { return p.y > window_.high.y; });
}

void Canvas::add_polygon(std::span<const Point> corners) {
  if (outside(corners)) return;
  const auto add = [&](std::span<const Point> polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point place = at(polygon[i]);
      (i == 0 ? cairo_.move_to : cairo_.line_to)(context_.get(), place.x, place.y);
    }
    if (polygon.size() > 2) cairo_.close_path(context_.get());
  };
  if (std::ranges::all_of(corners, [&](Point p) { return contains(p); })) return add(corners);
  add(clipped(corners, window_));
}

void Canvas::add_line(Point a, Point b) { add_polygon(std::array{a, b}); }

void Canvas::fill(Colour colour) {
  cairo_.set_source_rgb(context_.get(), colour.red, colour.green, colour.blue);
  // Neighbouring triangles would show a light line between them if their sides were smoothed.
  cairo_.set_antialias(context_.get(), CAIRO_ANTIALIAS_NONE);
  cairo_.fill(context_.get());
  cairo_.set_antialias(context_.get(), CAIRO_ANTIALIAS_DEFAULT);
}

void Canvas::stroke(Colour colour, double width) {
  cairo_.set_source_rgb(context_.get(), colour.red, colour.green, colour.blue);
  cairo_.set_line_width(context_.get(), width);
  cairo_.stroke(context_.get());
}

void Canvas::paint(std::vector<std::uint32_t>& pixels, int columns, int rows) {
  const int stride = columns * static_cast<int>(sizeof(std::uint32_t));
  cairo_surface_t* image = cairo_.image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()),
                                                                CAIRO_FORMAT_ARGB32, columns, rows, stride);
  cairo_.save(context_.get());
  cairo_.translate(context_.get(), margin(), margin());
  cairo_.scale(context_.get(), width_ / columns, height_ / rows);
  cairo_.set_source_surface(context_.get(), image, 0, 0);
  cairo_.pattern_set_filter(cairo_.get_source(context_.get()), CAIRO_FILTER_NEAREST);
  cairo_.paint(context_.get());
  cairo_.restore(context_.get());
  cairo_.surface_destroy(image);
}

void Canvas::leave_drawing() { cairo_.restore(context_.get()); }

void Canvas::move_to(Point place) { cairo_.move_to(context_.get(), place.x, place.y); }

void Canvas::line_to(Point place) { cairo_.line_to(context_.get(), place.x, place.y); }

void Canvas::close_path() { cairo_.close_path(context_.get()); }

void Canvas::fill_and_keep(Colour colour) {
  cairo_.set_source_rgb(context_.get(), colour.red, colour.green, colour.blue);
  cairo_.fill_preserve(context_.get());
}

void Canvas::fill_smoothly(Colour colour) {
  fill_and_keep(colour);
  cairo_.new_path(context_.get());
}

void Canvas::write(const std::string& text, Point place, double height, Colour colour) {
  cairo_.set_font_size(context_.get(), height);
  cairo_.set_source_rgb(context_.get(), colour.red, colour.green, colour.blue);
  move_to(place);
  cairo_.show_text(context_.get(), text.c_str());
  cairo_.new_path(context_.get());
}

Status Canvas::finish() {
  cairo_status_t drawn = cairo_.status(context_.get());
  if (png_ && drawn == CAIRO_STATUS_SUCCESS)
    drawn = cairo_.surface_write_to_png_stream(surface_.get(), write_bytes, &out_);
  context_.reset();
  cairo_.surface_finish(surface_.get());  // writes the SVG
  if (drawn == CAIRO_STATUS_SUCCESS) drawn = cairo_.surface_status(surface_.get());
  if (drawn != CAIRO_STATUS_SUCCESS && drawn != CAIRO_STATUS_WRITE_ERROR)
    return Error{ErrorKind::resources, fmt::format("{}: {}", name_, cairo_.status_to_string(drawn))};
  return out_.commit();
}

}  // namespace pardel::cli
