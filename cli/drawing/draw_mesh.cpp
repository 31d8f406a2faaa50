#include "draw_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "../length.hpp"
#include "draw_lines.hpp"
#include "small_triangles.hpp"

namespace pardel::cli {
namespace {

using Corners = std::array<Point, 3>;

Corners corners_of(const Mesh& mesh, Index t) {
  const auto& v = mesh.triangles[t].v;
  return {mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]};
}

/// The longest side in the picture.
double size_of(const Canvas& canvas, const Corners& c) {
  return canvas.scale() * std::max({length(c[0], c[1]), length(c[1], c[2]), length(c[2], c[0])});
}

/// Each class of sizes is a quarter of an octave, so that line widths change gradually.
int class_of(double size) { return static_cast<int>(std::floor(4 * std::log2(size))); }
double size_of_class(int k) { return std::exp2(0.25 * k); }

/// The corners of the triangles that are large enough to be drawn one by one.
std::vector<bool> corners_of_large(const Canvas& canvas, const Mesh& mesh) {
  std::vector<bool> is_corner(mesh.points.size());
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    if (size_of(canvas, corners_of(mesh, t)) >= SmallTriangles::largest)
      for (const Index v : mesh.triangles[t].v) is_corner[v] = true;
  return is_corner;
}

/// The triangles that are drawn one by one, by colour and by class of size. Small triangles that touch large ones are
/// drawn in both ways: otherwise pixels that are partly covered in each way would be too light.
struct Sorted {
  std::vector<std::vector<Index>> by_colour;
  std::map<int, std::vector<Index>> by_size;
};

Sorted sorted(const Canvas& canvas, const Mesh& mesh, const Colouring& colouring, SmallTriangles& small) {
  const bool edges = !colouring.legend.is_scale();
  Sorted large;
  large.by_colour.resize(colouring.palette.size());
  const std::vector<bool> touches_large = corners_of_large(canvas, mesh);
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const Corners corners = corners_of(mesh, t);
    const double size = size_of(canvas, corners);
    const std::uint16_t colour = colouring.colour_of[t];
    if (size < SmallTriangles::largest)
      small.add({canvas.at(corners[0]), canvas.at(corners[1]), canvas.at(corners[2])}, size, colouring.palette[colour],
                edges);
    if (std::ranges::any_of(mesh.triangles[t].v, [&](Index v) { return touches_large[v]; })) {
      large.by_colour[colour].push_back(t);
      large.by_size[class_of(size)].push_back(t);
    }
  }
  return large;
}

/// An edge of two triangles is drawn with the first of them.
void add_edges(Canvas& canvas, const Mesh& mesh, Index t) {
  const Triangle& triangle = mesh.triangles[t];
  for (int i = 0; i < 3; ++i) {
    if (triangle.n[i] < t) continue;
    canvas.add_line(mesh.points[triangle.v[(i + 1) % 3]], mesh.points[triangle.v[(i + 2) % 3]]);
  }
}

}  // namespace

void draw_mesh(Canvas& canvas, const Mesh& mesh, const Colouring& colouring) {
  SmallTriangles small(canvas);
  const Sorted large = sorted(canvas, mesh, colouring, small);
  small.paint(canvas);
  for (std::size_t colour = 0; colour < large.by_colour.size(); ++colour) {
    const auto fill = [&] { canvas.fill(colouring.palette[colour]); };
    in_parts(
        large.by_colour[colour], [&](Index t) { canvas.add_polygon(corners_of(mesh, t)); }, fill);
  }
  for (const auto& [size, triangles] : large.by_size) {
    const double width = std::clamp(0.035 * size_of_class(size), 0.1 * canvas.unit(), 0.8 * canvas.unit());
    const auto stroke = [&, width] { canvas.stroke(edge_colour, width); };
    in_parts(
        triangles, [&](Index t) { add_edges(canvas, mesh, t); }, stroke);
  }
  draw_lines(canvas, mesh.constrained_edges, mesh.points.span());
}

}  // namespace pardel::cli
