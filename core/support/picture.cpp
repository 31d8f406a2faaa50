#include "picture.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "output_file.hpp"

namespace pardel::drawing {
namespace {

constexpr double side = 600, margin = 60;

std::string stroke(Ink ink) {
  switch (ink) {
    case Ink::thin:
      return "stroke=\"#7088a0\" stroke-width=\"1\"";
    case Ink::thick:
      return "stroke=\"#202020\" stroke-width=\"3\"";
    case Ink::dashed:
      return "stroke=\"#202020\" stroke-width=\"1\" stroke-dasharray=\"4 3\"";
  }
  return {};
}

}  // namespace

std::string tint(std::size_t k) { return "hsl(" + std::to_string((210 + k * 137) % 360) + ",70%,85%)"; }

void Picture::polygon(std::vector<Point> corners, std::string fill, Ink ink) {
  shapes_.push_back({std::move(corners), 0, std::move(fill), ink});
}
void Picture::line(Point a, Point b, Ink ink) { shapes_.push_back({{a, b}, 0, "none", ink}); }
void Picture::circle(const Circle& circle, std::string colour) {
  shapes_.push_back({{circle.centre}, circle.radius, std::move(colour), Ink::thin});
}
void Picture::dot(Point at, std::string colour) { shapes_.push_back({{at}, 0, std::move(colour), Ink::thin}); }

Status Picture::write(const std::filesystem::path& file) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low{infinity, infinity}, high{-infinity, -infinity};
  for (const Shape& shape : shapes_) {
    if (shape.radius > 0) continue;
    for (const Point& p : shape.corners) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const double extent = std::max(high.x - low.x, high.y - low.y), scale = extent > 0 ? side / extent : 1;
  const auto x = [&](Point p) { return (p.x - low.x) * scale + margin; };
  const auto y = [&](Point p) { return (high.y - p.y) * scale + margin; };

  std::ostringstream svg;
  svg.precision(7);
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << (high.x - low.x) * scale + 2 * margin << ' '
      << (high.y - low.y) * scale + 2 * margin << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  for (const Shape& shape : shapes_) {
    if (shape.corners.size() > 1) {
      svg << "<path d=\"M";
      for (const Point& p : shape.corners) svg << ' ' << x(p) << ' ' << y(p);
      svg << "Z\" fill=\"" << shape.fill << "\" " << stroke(shape.ink) << "/>\n";
    } else if (shape.radius > 0) {
      svg << "<circle cx=\"" << x(shape.corners[0]) << "\" cy=\"" << y(shape.corners[0]) << "\" r=\""
          << shape.radius * scale << "\" fill=\"none\" stroke=\"" << shape.fill << "\"/>\n";
    } else {
      svg << "<circle cx=\"" << x(shape.corners[0]) << "\" cy=\"" << y(shape.corners[0]) << "\" r=\"4\" fill=\""
          << shape.fill << "\"/>\n";
    }
  }
  svg << "</svg>\n";
  OutputFile out(file);
  out.write(svg.str());
  return out.commit();
}

}  // namespace pardel::drawing
