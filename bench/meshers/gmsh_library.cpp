// SPDX-License-Identifier: GPL-2.0-or-later
#include "gmsh_library.hpp"

#include <gmsh.h>

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "../../core/support/doubled_area.hpp"
#include "bounds.hpp"

namespace pardel::bench {
namespace {

using Side = std::pair<Index, Index>;

/// The parts of a subdomain that are connected across edges, with their borders.
class Outlines {
 public:
  struct Component {
    std::vector<std::vector<Side>> loops;  ///< the outer one first
    std::vector<Side> inner_edges;
    std::set<Index> inner_points;
  };

  explicit Outlines(const Subdomain& subdomain) : subdomain_(subdomain), component_(subdomain.triangles.size()) {
    for (Index t = 0; t < subdomain.triangles.size(); ++t)
      for (unsigned i = 0; i < 3; ++i) triangle_at_[side(t, i)] = t;
    std::iota(component_.begin(), component_.end(), Index{0});
    for (const auto& [s, t] : triangle_at_)
      if (const auto across = triangle_at_.find({s.second, s.first}); across != triangle_at_.end())
        component_[root_of(t)] = root_of(across->second);
  }

  [[nodiscard]] std::vector<Component> components() {
    std::map<Index, Component> found;
    std::set<Side> traced;
    for (const auto& [s, t] : triangle_at_) {
      Component& component = found[root_of(t)];
      component.inner_points.insert(s.first);
      if (is_border(s) && !traced.contains(s)) {
        std::vector<Side> loop{s};
        for (Side next = next_on_border(s); next != s; next = next_on_border(next)) loop.push_back(next);
        traced.insert(loop.begin(), loop.end());
        component.loops.push_back(std::move(loop));
      }
    }
    for (const SubdomainEdge& e : subdomain_.edges)
      if (e.inside) found[root_of(triangle_at_.at({e.a, e.b}))].inner_edges.emplace_back(e.a, e.b);
    std::vector<Component> all;
    for (auto& [root, component] : found) {
      for (auto& loop : component.loops) {
        if (area_of(loop) > 0) std::swap(loop, component.loops.front());
        for (const Side& s : loop) component.inner_points.erase(s.first);
      }
      for (const Side& s : component.inner_edges)
        for (const Index end : {s.first, s.second}) component.inner_points.erase(end);
      all.push_back(std::move(component));
    }
    return all;
  }

 private:
  [[nodiscard]] Side side(Index t, unsigned i) const {
    const auto& v = subdomain_.triangles[t];
    return {v[i], v[(i + 1) % 3]};
  }
  [[nodiscard]] bool is_border(Side s) const { return !triangle_at_.contains({s.second, s.first}); }
  Index root_of(Index t) {
    while (component_[t] != t) t = component_[t] = component_[component_[t]];
    return t;
  }
  /// The first border side that begins where this one ends, turning inside the subdomain.
  [[nodiscard]] Side next_on_border(Side s) const {
    while (true) {
      const Index t = triangle_at_.at(s);
      unsigned i = 0;
      while (side(t, i).first != s.second) ++i;
      const Side next = side(t, i);
      if (is_border(next)) return next;
      s = {next.second, next.first};
    }
  }
  [[nodiscard]] double area_of(const std::vector<Side>& loop) const {
    const Point origin = subdomain_.points[loop.front().first];
    double twice_area = 0;
    for (const Side& s : loop)
      twice_area += doubled_area(origin, subdomain_.points[s.first], subdomain_.points[s.second]);
    return twice_area;
  }

  const Subdomain& subdomain_;
  std::map<Side, Index> triangle_at_;
  std::vector<Index> component_;
};

int tag_of(Index point) { return static_cast<int>(point) + 1; }

/// Makes Gmsh's geometry of the subdomain.
class Geometry {
 public:
  explicit Geometry(const Subdomain& subdomain) {
    for (Index p = 0; p < subdomain.points.size(); ++p)
      gmsh::model::geo::addPoint(subdomain.points[p].x, subdomain.points[p].y, 0, 0, tag_of(p));
    const std::vector<Outlines::Component> components = Outlines(subdomain).components();
    std::vector<std::vector<int>> inner_lines;
    for (const Outlines::Component& component : components) {
      std::vector<int> loops;
      for (const auto& loop : component.loops) loops.push_back(gmsh::model::geo::addCurveLoop(lines(loop)));
      surfaces_.push_back(gmsh::model::geo::addPlaneSurface(loops));
      inner_lines.push_back(lines(component.inner_edges));
    }
    gmsh::model::geo::synchronize();
    for (const auto& [ends, line] : line_between_) gmsh::model::mesh::setTransfiniteCurve(line, 2);
    for (std::size_t i = 0; i < components.size(); ++i) {
      std::vector<int> points;
      for (const Index p : components[i].inner_points) points.push_back(tag_of(p));
      gmsh::model::mesh::embed(0, points, 2, surfaces_[i]);
      gmsh::model::mesh::embed(1, inner_lines[i], 2, surfaces_[i]);
    }
  }

 private:
  /// The lines of a chain of sides, negative where the line has the other direction.
  std::vector<int> lines(const std::vector<Side>& sides) {
    std::vector<int> tags;
    for (const auto& [a, b] : sides) {
      if (const auto known = line_between_.find({b, a}); known != line_between_.end()) {
        tags.push_back(-known->second);
        continue;
      }
      const auto [line, is_new] = line_between_.try_emplace({a, b}, 0);
      if (is_new) line->second = gmsh::model::geo::addLine(tag_of(a), tag_of(b));
      tags.push_back(line->second);
    }
    return tags;
  }

  std::map<Side, int> line_between_;
  std::vector<int> surfaces_;
};

/// The answer with Gmsh's triangles. The points of the subdomain are found by their coordinates.
RefinedSubdomain read_mesh(const Subdomain& subdomain) {
  std::vector<std::size_t> tags, elements, corners;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getElementsByType(2, elements, corners);
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  RefinedSubdomain answer;
  answer.points = subdomain.points;
  std::map<std::pair<double, double>, Index> old;
  for (Index p = 0; p < subdomain.points.size(); ++p) old[{subdomain.points[p].x, subdomain.points[p].y}] = p;
  std::map<std::size_t, Index> point_of_tag;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const Point p{coordinates[3 * i], coordinates[3 * i + 1]};
    const auto known = old.find({p.x, p.y});
    point_of_tag[tags[i]] = known != old.end() ? known->second : static_cast<Index>(answer.points.size());
    if (known == old.end()) answer.points.push_back(p);
  }
  answer.edge_of_new_point.assign(answer.points.size() - subdomain.points.size(), no_index);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    std::array<Index, 3> v{};
    for (std::size_t k = 0; k < 3; ++k) v[k] = point_of_tag.at(corners[3 * i + k]);
    if (doubled_area(answer.points[v[0]], answer.points[v[1]], answer.points[v[2]]) < 0) std::swap(v[1], v[2]);
    answer.triangles.push_back(v);
  }
  return answer;
}

struct Session {
  Session() { gmsh::initialize(0, nullptr, false); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() { gmsh::finalize(); }
};

class GmshMesher final : public SubdomainMesher {
 public:
  [[nodiscard]] MesherAbilities abilities() const override {
    return {.obeys_cell = false,
            .keeps_frozen_edges = true,
            .splits_segments = false,
            .exempts_small_angles = true,
            .is_thread_safe = false};
  }

  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    try {
      const Session session;
      return mesh(subdomain);
    } catch (const std::string& what) {  // Gmsh throws these
      throw std::runtime_error(what);
    }
  }

 private:
  static RefinedSubdomain mesh(const Subdomain& subdomain) {
    constexpr double delaunay = 5;
    for (const char* const name : {"General.Terminal", "Mesh.MeshSizeExtendFromBoundary", "Mesh.MeshSizeFromPoints",
                                   "Mesh.MeshSizeFromCurvature"})
      gmsh::option::setNumber(name, 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.Algorithm", delaunay);
    const Geometry geometry(subdomain);
    const Bounds bounds(subdomain);
    gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double) { return size_at(bounds, {x, y}); });
    gmsh::model::mesh::generate(2);
    return read_mesh(subdomain);
  }

  /// Gmsh takes sizes as means, the goal as bounds.
  static double size_at(const Bounds& bounds, Point p) {
    constexpr double mean_area_of_largest = 0.7, mean_edge_of_longest = 0.8;
    const double equilateral = std::sqrt(bounds.max_area_at(p) * mean_area_of_largest * 4 / std::sqrt(3.0));
    return std::min({equilateral, mean_edge_of_longest * bounds.max_edge_at(p), 1e22});
  }
};

}  // namespace

std::unique_ptr<SubdomainMesher> gmsh_library() { return std::make_unique<GmshMesher>(); }

}  // namespace pardel::bench
