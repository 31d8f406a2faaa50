// pardel-gmsh POLY OUT.msh [MAX_AREA]: has Gmsh mesh a domain, one plane surface for each of its faces. Gmsh knows
// sizes of edges, no angles and no areas: with MAX_AREA it is asked for equilateral triangles of that area.
#include <fmt/format.h>
#include <unistd.h>

#include <array>
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
#include "../../../core/output_file.hpp"
#include "../../../properties/domain.hpp"

namespace pardel::harness {
namespace {

namespace fs = std::filesystem;

/// Of one face, by index of the segment. Lines of loops are signed and count from 1, as in the .geo.
struct Surface {
  std::vector<std::vector<int>> loops;
  std::vector<Index> cracks;  ///< with the face on both sides
  std::vector<Index> points;  ///< at the end of no segment
};

/// Splits the boundary of a face, where every vertex has an even number of lines, into simple loops: walks along it
/// and cuts a loop off wherever a vertex is met again.
std::vector<std::vector<int>> simple_loops(std::span<const Segment> segments, const std::vector<Index>& boundary) {
  std::multimap<Index, Index> at;  // vertex -> segment that was not walked yet
  for (const Index s : boundary) {
    at.emplace(segments[s].a, s);
    at.emplace(segments[s].b, s);
  }
  const auto take = [&](Index vertex, Index segment) {
    const auto [begin, end] = at.equal_range(vertex);
    for (auto it = begin; it != end; ++it) {
      if (it->second != segment) continue;
      at.erase(it);
      return;
    }
  };
  std::vector<std::vector<int>> loops;
  while (!at.empty()) {
    std::vector<Index> vertices = {at.begin()->first};  // of the path; one more than lines
    std::vector<int> lines;
    for (auto next = at.find(vertices.back()); next != at.end(); next = at.find(vertices.back())) {
      const Index s = next->second;
      const bool forwards = segments[s].a == vertices.back();
      const Index to = forwards ? segments[s].b : segments[s].a;
      take(vertices.back(), s);
      take(to, s);
      lines.push_back(forwards ? static_cast<int>(s) + 1 : -static_cast<int>(s) - 1);
      const auto met = std::find(vertices.begin(), vertices.end(), to);
      const auto kept = met - vertices.begin();
      if (met == vertices.end()) {
        vertices.push_back(to);
      } else {
        loops.emplace_back(lines.begin() + kept, lines.end());
        lines.resize(static_cast<std::size_t>(kept));
        vertices.resize(static_cast<std::size_t>(kept) + 1);
      }
    }
  }
  return loops;
}

/// By face; those outside the domain are left out.
std::map<Index, Surface> surfaces_of(const Pslg& pslg, const Domain& domain) {
  std::map<Index, Surface> surfaces;
  std::map<Index, std::vector<Index>> boundaries;
  const auto segments = domain.segments();
  for (Index s = 0; s < segments.size(); ++s) {
    const Index left = domain.faces().face(s, Side::left), right = domain.faces().face(s, Side::right);
    if (left == right) {
      if (domain.inside(left)) surfaces[left].cracks.push_back(s);
      continue;
    }
    for (const Index face : {left, right}) {
      if (domain.inside(face)) boundaries[face].push_back(s);
    }
  }
  for (const auto& [face, boundary] : boundaries) surfaces[face].loops = simple_loops(segments, boundary);
  for (Index p = 0; p < pslg.points.size(); ++p) {
    if (!domain.faces().incident(p).empty()) continue;
    const Index face = domain.faces().face_at(pslg.points[p]);
    if (domain.inside(face)) surfaces[face].points.push_back(p);
  }
  return surfaces;
}

std::string one_based(const std::vector<Index>& indices) {
  std::string text;
  for (const Index i : indices) text += fmt::format("{}{}", text.empty() ? "" : ", ", i + 1);
  return text;
}

std::string geometry(const Pslg& pslg, double edge) {
  const Domain domain(pslg, pslg.segments.empty());
  std::string text;
  for (std::size_t i = 0; i < pslg.points.size(); ++i)
    text += fmt::format("Point({}) = {{{}, {}, 0}};\n", i + 1, pslg.points[i].x, pslg.points[i].y);
  for (Index s = 0; s < domain.segments().size(); ++s) {
    if (!domain.has(s)) continue;
    text += fmt::format("Line({}) = {{{}, {}}};\n", s + 1, domain.segments()[s].a + 1, domain.segments()[s].b + 1);
  }
  int loop_count = 0;
  for (const auto& [face, surface] : surfaces_of(pslg, domain)) {
    std::string loops;
    for (const std::vector<int>& loop : surface.loops) {
      text += fmt::format("Curve Loop({}) = {{{}}};\n", ++loop_count, fmt::join(loop, ", "));
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
