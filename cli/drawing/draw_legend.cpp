#include "draw_legend.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "../plural.hpp"
#include "draw_domain.hpp"

namespace pardel::cli {
namespace {

constexpr std::size_t most_entries = 14;
constexpr std::size_t longest_line = 24;  // in characters

/// Writes from the top to the bottom of the column.
class Column {
 public:
  explicit Column(Canvas& canvas)
      : canvas_(canvas), x_(canvas.width() + 3 * canvas.margin()), y_(canvas.margin() + 16 * canvas.unit()) {
    canvas.leave_drawing();
  }

  void text(const std::string& line, double size = 15, double indent = 0) {
    canvas_.write(shortened(line), {x_ + indent * canvas_.unit(), y_}, size * canvas_.unit(), {0.15, 0.15, 0.15});
  }
  void box(Colour colour, double width, double height) {
    const double u = canvas_.unit();
    canvas_.move_to({x_, y_ - height * u});
    canvas_.line_to({x_ + width * u, y_ - height * u});
    canvas_.line_to({x_ + width * u, y_});
    canvas_.line_to({x_, y_});
    canvas_.close_path();
    canvas_.fill_and_keep(colour);
    canvas_.stroke(edge_colour, 0.5 * u);
  }
  void down(double units) { y_ += units * canvas_.unit(); }
  /// The middle of the mark of a line of text.
  [[nodiscard]] Point mark() const { return {x_ + 8 * canvas_.unit(), y_ - 5 * canvas_.unit()}; }

 private:
  static std::string shortened(const std::string& line) {
    if (line.size() <= longest_line) return line;
    std::size_t end = longest_line - 3;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0) == 0x80) --end;
    return line.substr(0, end) + "...";
  }

  Canvas& canvas_;
  double x_, y_;
};

/// Bands of colour, the largest value at the top, with the values at their borders.
void draw_scale(Column& column, const Legend& legend) {
  const double height = 240.0 / static_cast<double>(legend.colours.size());
  for (std::size_t i = legend.colours.size(); i > 0; --i) {
    column.text(legend.labels[i], 13, 30);
    column.down(height);
    column.down(-5);
    column.box(legend.colours[i - 1], 22, height);
    column.down(5);
  }
  column.text(legend.labels[0], 13, 30);
}

void draw_entries(Column& column, const Legend& legend) {
  const std::size_t shown = std::min(legend.colours.size(), most_entries);
  for (std::size_t i = 0; i < shown; ++i) {
    column.box(legend.colours[i], 16, 12);
    column.text(legend.labels[i], 14, 26);
    column.down(21);
  }
  if (shown < legend.colours.size()) column.text(fmt::format("and {} more", legend.colours.size() - shown), 14);
}

}  // namespace

void draw_legend(Canvas& canvas, const std::vector<std::string>& text, const Legend& legend) {
  Column column(canvas);
  for (std::size_t i = 0; i < text.size(); ++i) {
    column.text(text[i], i == 0 ? 18 : 15);
    column.down(i == 0 ? 26 : 21);
  }
  if (legend.title.empty()) return;
  column.down(14);
  column.text(legend.title, 15);
  column.down(24);
  if (legend.is_scale()) return draw_scale(column, legend);
  draw_entries(column, legend);
}

void draw_legend(Canvas& canvas, const std::string& headline, const Pslg& pslg) {
  Column column(canvas);
  column.text(headline, 18);
  column.down(30);
  const auto entry = [&](std::size_t count, const char* noun, const auto& draw) {
    if (count == 0) return;
    draw(column.mark());
    column.text(plural(count, noun), 15, 24);
    column.down(22);
  };
  entry(pslg.points.size(), "point", [&](Point p) { draw_dot(canvas, p, 3 * canvas.unit()); });
  entry(pslg.segments.size(), "segment", [&](Point p) {
    canvas.move_to({p.x - 8 * canvas.unit(), p.y});
    canvas.line_to({p.x + 8 * canvas.unit(), p.y});
    canvas.stroke(segment_colour, 1.8 * canvas.unit());
  });
  entry(pslg.holes.size(), "hole", [&](Point p) { draw_cross(canvas, p); });
  entry(pslg.regions.size(), "region", [&](Point p) { draw_diamond(canvas, p); });
}

}  // namespace pardel::cli
