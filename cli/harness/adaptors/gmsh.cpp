// pardel-gmsh POLY OUT.msh [MAX_AREA]: meshes a domain with Gmsh, one plane surface per face. Gmsh has bounds on edges,
// but not on angles and areas: MAX_AREA becomes the edge length of an equilateral triangle of that area.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../../core/support/output_file.hpp"
#include "../../../properties/checker/domain_faces.hpp"

namespace pardel::harness {
namespace {

namespace fs = std::filesystem;
using checker::DomainFaces;

/// A segment with a direction, and its number in the .geo: 1 + its index, negative for the reverse direction.
struct Line {
  int number = 0;
  Index from = 0, to = 0;
};
using Loop = std::vector<Line>;

/// One face of the domain.
struct Surface {
  std::vector<Loop>
      loops;  ///< the face is on their left; the outer loop is first, because Gmsh orients triangles by it
  std::vector<Index> cracks;  ///< segments with the face on both sides
  std::vector<Index> points;  ///< isolated points
};

/// Splits the boundary of a face into simple loops: follows the boundary and cuts off a loop at each vertex that it
/// meets again.
std::vector<Loop> simple_loops(const std::vector<Line>& boundary) {
  std::multimap<Index, Line> from;
  for (const Line& line : boundary) from.emplace(line.from, line);
  std::vector<Loop> loops;
  while (!from.empty()) {
    Loop path;
    for (auto next = from.begin(); next != from.end(); next = from.find(path.empty() ? no_index : path.back().to)) {
      path.push_back(next->second);
      from.erase(next);
      const Index met = path.back().to;
      const auto start = std::find_if(path.begin(), path.end(), [&](const Line& line) { return line.from == met; });
      if (start == path.end()) continue;
      loops.emplace_back(start, path.end());
      path.erase(start, path.end());
    }
  }
  return loops;
}

/// Twice the signed area of a loop, positive if it is counter-clockwise.
double doubled_area(const Loop& loop, const std::vector<Point>& points) {
  const Point origin = points[loop.front().from];  // differences avoid cancellation far from the origin
  double sum = 0;
  for (const Line& line : loop) {
    const Point p = points[line.from], q = points[line.to];
    sum += (p.x - origin.x) * (q.y - origin.y) - (q.x - origin.x) * (p.y - origin.y);
  }
  return sum;
}

/// The surfaces by face, without faces outside the domain.
std::map<Index, Surface> surfaces_of(const Pslg& pslg, const DomainFaces& domain) {
  std::map<Index, Surface> surfaces;
  std::map<Index, std::vector<Line>> boundaries;
  for (Index s = 0; s < domain.segments.size(); ++s) {
    const auto [left, right] = domain.sides[s];
    const auto [a, b, marker] = domain.segments[s];
    const int number = static_cast<int>(s) + 1;
    if (left == right) {
      if (left != no_index) surfaces[left].cracks.push_back(s);
      continue;
    }
    if (left != no_index) boundaries[left].push_back({number, a, b});
    if (right != no_index) boundaries[right].push_back({-number, b, a});
  }
  for (const auto& [face, boundary] : boundaries) {
    std::vector<Loop>& loops = surfaces[face].loops = simple_loops(boundary);
    const auto outer = std::max_element(loops.begin(), loops.end(), [&](const Loop& l, const Loop& m) {
      return doubled_area(l, pslg.points) < doubled_area(m, pslg.points);
    });
    std::iter_swap(loops.begin(), outer);
  }
  for (const auto& [point, face] : domain.isolated_points) surfaces[face].points.push_back(point);
  return surfaces;
}

std::string one_based(const std::vector<Index>& indices) {
  std::string text;
  for (const Index i : indices) text += fmt::format("{}{}", text.empty() ? "" : ", ", i + 1);
  return text;
}

std::string geometry(const Pslg& pslg, double edge) {
  const DomainFaces domain = checker::faces_of_domain(pslg, pslg.segments.empty());
  std::string text;
  for (std::size_t i = 0; i < pslg.points.size(); ++i)
    text += fmt::format("Point({}) = {{{}, {}, 0}};\n", i + 1, pslg.points[i].x, pslg.points[i].y);
  for (Index s = 0; s < domain.segments.size(); ++s) {
    if (domain.sides[s].left == no_index && domain.sides[s].right == no_index) continue;
    text += fmt::format("Line({}) = {{{}, {}}};\n", s + 1, domain.segments[s].a + 1, domain.segments[s].b + 1);
  }
  int loop_count = 0;
  for (const auto& [face, surface] : surfaces_of(pslg, domain)) {
    std::string loops;
    for (const Loop& loop : surface.loops) {
      std::string lines;
      for (const Line& line : loop) lines += fmt::format("{}{}", lines.empty() ? "" : ", ", line.number);
      text += fmt::format("Curve Loop({}) = {{{}}};\n", ++loop_count, lines);
      loops += fmt::format("{}{}", loops.empty() ? "" : ", ", loop_count);
    }
    text += fmt::format("Plane Surface({}) = {{{}}};\n", face, loops);
    if (!surface.cracks.empty())
      text += fmt::format("Curve{{{}}} In Surface{{{}}};\n", one_based(surface.cracks), face);
    if (!surface.points.empty())
      text += fmt::format("Point{{{}}} In Surface{{{}}};\n", one_based(surface.points), face);
  }
  if (edge > 0) text += fmt::format("Mesh.MeshSizeMax = {};\n", edge);
  return text;
}

int fail(const std::string& message) {
  fmt::print(stderr, "error: {}\n", message);
  return 5;
}

int run(const fs::path& poly, const fs::path& out, double max_area) {
  const Result<Pslg> pslg = read_pslg(poly);
  if (!pslg) return fail(pslg.error().message);
  const fs::path geo = fs::path(out).replace_extension(".geo");
  OutputFile file(geo);
  file.write(geometry(*pslg, std::sqrt(max_area * 4 / std::sqrt(3.0))));
  if (Status written = file.commit(); !written) return fail(written.error().message);
  execlp("gmsh", "gmsh", "-2", "-nt", "1", "-format", "msh41", "-bin", "-o", out.c_str(), geo.c_str(), nullptr);
  return fail(fmt::format("gmsh: {}", std::strerror(errno)));
}

}  // namespace
}  // namespace pardel::harness

int main(int argc, char** argv) {
  double max_area = 0;  // no bound
  if (argc == 4) std::from_chars(argv[3], argv[3] + std::strlen(argv[3]), max_area);
  if (argc < 3 || argc > 4) {
    fmt::print(stderr, "usage: pardel-gmsh POLY OUT.msh [MAX_AREA]\n");
    return 2;
  }
  return pardel::harness::run(argv[1], argv[2], max_area);
}
