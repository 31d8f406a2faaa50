// SVG drawings of a mesh and of a Pslg. The y axis points up.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "../formats.hpp"
#include "records.hpp"

namespace pardel {
using namespace files;
namespace {

/// Maps the data to a canvas whose longer side has 1000 units, plus a margin.
class Canvas {
 public:
  template <class Points>
  explicit Canvas(const Points& points) {
    if (points.size() == 0) return;
    low_ = high_ = points[0];
    for (const Point& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    const double extent = std::max(high_.x - low_.x, high_.y - low_.y);
    if (extent > 0) scale_ = side / extent;
  }

  void open(OutputFile& out) const {
    Bytes to;
    to << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ";
    number(to, (high_.x - low_.x) * scale_ + 2 * margin) << ' ';
    number(to, (high_.y - low_.y) * scale_ + 2 * margin)
        << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    out.write(to.view());
  }

  Bytes& put(Bytes& to, const Point& p, double dx = 0, double dy = 0) const {
    number(to, (p.x - low_.x) * scale_ + margin + dx) << ' ';
    return number(to, (high_.y - p.y) * scale_ + margin + dy);
  }

  /// Writes three decimals, because a thousandth of a unit is not visible.
  static Bytes& number(Bytes& to, double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof(digits), value, std::chars_format::fixed, 3);
    return to << (end.ec == std::errc() ? std::string_view(digits, end.ptr) : std::string_view("0"));
  }

 private:
  static constexpr double side = 1000;
  static constexpr double margin = 20;
  Point low_;
  Point high_;
  double scale_ = 1;
};

/// Hues of consecutive regions differ by the golden angle, so they are easy to distinguish. Argument 0 means no region.
std::size_t hue_of_region(std::size_t region) { return (210 + region * 137) % 360; }

/// The most shapes of one path. Readers refuse attributes above 10 MB; a shape takes less than 100 bytes.
constexpr std::size_t shapes_of_a_path = 5000;

/// Draws n shapes, as several paths if there are many; format(bytes, i) appends the commands of shape i.
template <class Format>
void draw_paths(OutputFile& out, std::size_t n, std::string_view style, const Format& format) {
  for (std::size_t first = 0; first < n; first += shapes_of_a_path) {
    out.write("<path ");
    out.write(style);
    out.write(" d=\"\n");
    write_records(out, std::min(shapes_of_a_path, n - first), [&](Bytes& to, std::size_t i) { format(to, first + i); });
    out.write("\"/>\n");
  }
}

/// Draws segments or constrained edges.
template <class Edges, class Points>
void draw_lines(OutputFile& out, const Canvas& canvas, const Edges& edges, const Points& points) {
  draw_paths(out, edges.size(), "fill=\"none\" stroke=\"#202020\" stroke-width=\"1.5\" stroke-linecap=\"round\"",
             [&](Bytes& to, std::size_t i) {
               canvas.put(to << 'M', points[edges[i].a]);
               canvas.put(to << 'L', points[edges[i].b]) << '\n';
             });
}

/// Draws the triangles of one hue.
void draw_triangles(OutputFile& out, const Canvas& canvas, const Mesh& mesh, std::span<const Index> triangles,
                    std::size_t hue) {
  Bytes style;
  style << "stroke=\"#7088a0\" stroke-width=\"0.3\" stroke-linejoin=\"round\" fill=\"hsl(" << hue << ",60%,88%)\"";
  draw_paths(out, triangles.size(), style.view(), [&](Bytes& to, std::size_t i) {
    const auto& v = mesh.triangles[triangles[i]].v;
    canvas.put(to << 'M', mesh.points[v[0]]);
    canvas.put(to << 'L', mesh.points[v[1]]);
    canvas.put(to << 'L', mesh.points[v[2]]) << "Z\n";
  });
}

}  // namespace

Status write_svg(const Mesh& mesh, const std::filesystem::path& file, const GoOn& go_on) {
  OutputFile out(file, go_on);
  const Canvas canvas(mesh.points);
  canvas.open(out);
  std::array<std::vector<Index>, 360> by_hue;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const bool in_region = t < mesh.region.size() && mesh.region[t] != no_index;
    by_hue[hue_of_region(in_region ? std::size_t{mesh.region[t]} + 1 : 0)].push_back(t);
  }
  for (std::size_t hue = 0; hue < by_hue.size(); ++hue) {
    if (!by_hue[hue].empty()) draw_triangles(out, canvas, mesh, by_hue[hue], hue);
  }
  draw_lines(out, canvas, mesh.constrained_edges, mesh.points);
  out.write("</svg>\n");
  return out.commit();
}

Status write_svg(const Pslg& pslg, const std::filesystem::path& file, const GoOn& go_on) {
  OutputFile out(file, go_on);
  const Canvas canvas(pslg.points);
  canvas.open(out);
  draw_lines(out, canvas, pslg.segments, pslg.points);
  draw_paths(out, pslg.points.size(), "stroke=\"#205090\" stroke-width=\"4\" stroke-linecap=\"round\"",
             [&](Bytes& to, std::size_t i) { canvas.put(to << 'M', pslg.points[i]) << "h0\n"; });
  draw_paths(out, pslg.holes.size(), "stroke=\"#c02020\" stroke-width=\"2\"", [&](Bytes& to, std::size_t i) {
    canvas.put(to << 'M', pslg.holes[i], -6, -6) << "l12 12";
    canvas.put(to << 'M', pslg.holes[i], -6, 6) << "l12 -12\n";
  });
  write_records(out, pslg.regions.size(), [&](Bytes& to, std::size_t i) {
    canvas.put(to << "<path fill=\"#208040\" d=\"M", pslg.regions[i].seed, 0, -6) << "l6 6l-6 6l-6 -6Z\"/>\n";
    canvas.put(to << "<text font-size=\"14\" transform=\"translate(", pslg.regions[i].seed, 9, 5)
        << ")\">" << pslg.regions[i].attribute << "</text>\n";
  });
  out.write("</svg>\n");
  return out.commit();
}

}  // namespace pardel
