// Checks that input points are vertices, and that input segments and hull pieces are chains of edges that meet in
// common input points only.
#include <algorithm>
#include <cmath>

#include "../arithmetic/exact.hpp"
#include "../arithmetic/text.hpp"
#include "stages.hpp"

namespace pardel::checker {
namespace {

class InputVertexSearch {
 public:
  InputVertexSearch(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const NumberSet& settled)
      : subject_(subject),
        domain_(domain),
        adjacency_(adjacency),
        settled_(settled),
        points_(subject.pslg.points),
        by_number_(points_.size(), no_index) {
    const std::span<const std::uint64_t> names = subject.names.vertices;
    const std::size_t vertices = subject.mesh.points.size();
    for (std::size_t v = 0; v < vertices && number_of(names, v) < points_.size(); ++v)
      by_number_[number_of(names, v)] = static_cast<Index>(v);
  }

  [[nodiscard]] InputVertices run(StopSignal* stop) && {
    const std::span<const Point> vertices = subject_.mesh.points.span();
    if (!subject_.options.foreign || is_numbered_as_input()) {
      if (subject_.names.vertices.empty()) return InputVertices::by_index(points_.size(), vertices.size());
      return {std::move(by_number_), vertices.size()};
    }
    std::vector<Index> wanted;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (!is_elsewhere(i)) wanted.push_back(static_cast<Index>(i));
    return InputVertices::by_coordinates(points_, std::move(wanted), vertices, adjacency_, stop);
  }

 private:
  [[nodiscard]] static std::uint64_t number_of(std::span<const std::uint64_t> names, std::size_t v) {
    return names.empty() ? v : names[v];
  }
  [[nodiscard]] bool is_elsewhere(std::size_t i) const { return by_number_[i] == no_index && settled_.contains(i); }

  /// True if the vertices of the mesh begin with the input points, in their order, and each point of the domain has a
  /// triangle. Then the numbers tell which vertices are input points, also if another vertex has the same coordinates.
  [[nodiscard]] bool is_numbered_as_input() const {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Index v = by_number_[i];
      if (is_elsewhere(i)) continue;
      if (v == no_index || !(subject_.mesh.points[v] == points_[i])) return false;
      if (!adjacency_.has_triangle(v) && domain_.has_point(static_cast<Index>(i))) return false;
    }
    return true;
  }

  const Subject& subject_;
  const Domain& domain_;
  const Adjacency& adjacency_;
  const NumberSet& settled_;
  const std::vector<Point>& points_;
  Array<Index> by_number_;  ///< per input point, the vertex with its number
};

}  // namespace

InputVertices check_input_vertices(const Subject& subject, const Domain& domain, const Adjacency& adjacency,
                                   Findings& found, const NumberSet& settled) {
  const Mesh& mesh = subject.mesh;
  const auto& points = subject.pslg.points;
  const bool by_index = !subject.options.foreign && subject.names.vertices.empty();
  InputVertices inputs = by_index ? InputVertices::by_index(points.size(), mesh.points.size())
                                  : InputVertexSearch(subject, domain, adjacency, settled).run(found.stop());
  check_each(points.size(), found, [&](std::size_t i, Findings& mine) {
    const auto input = static_cast<Index>(i);
    const Index vertex = inputs.vertex(input);
    const bool needed = domain.has_point(input);
    const auto report = [&](const Witness& what) {
      mine.add(ViolationKind::missing_input_vertex, {input}, {points[i]}, "input point " + domain_number(i) + what);
    };
    if (vertex == no_index) {
      if (needed && !settled.contains(i)) report(" of the domain is not a vertex of the mesh");
    } else if (!(mesh.points[vertex] == points[i])) {
      report(" was moved or renumbered: vertex " + vertex_number(subject.names.vertex(vertex)) + " is " +
             to_text(mesh.points[vertex]));
    } else if (needed && !adjacency.has_triangle(vertex)) {
      report(" of the domain has no triangle");
    }
  });
  check_each(mesh.points.size(), found, [&](std::size_t v, Findings& mine) {
    const auto vertex = static_cast<Index>(v);
    if (!adjacency.has_triangle(vertex) && inputs.input(vertex) == no_index)
      mine.add(ViolationKind::unused_vertex, {subject.names.vertex(vertex)}, {mesh.points[v]},
               "vertex " + vertex_number(subject.names.vertex(vertex)) + " has no triangle and is not an input point");
  });
  return inputs;
}

namespace {

void report_broken(Index s, const Subject& subject, const Domain& domain, Findings& found) {
  const Segment& segment = domain.segments()[s];
  const Witness what = domain.is_hull_piece(s) ? "the hull edge" : "segment " + domain_number(s);
  found.add(ViolationKind::broken_segment,
            domain.is_hull_piece(s) ? std::vector<Index>{segment.a, segment.b} : std::vector<Index>{s},
            {subject.pslg.points[segment.a], subject.pslg.points[segment.b]},
            what + " from point " + domain_number(segment.a) + " to " + domain_number(segment.b) +
                " is not covered by a chain of mesh edges within the rounding distance");
}

void report_off_segment(const std::vector<ChainEdge>& chain, const Subject& subject, const Domain& domain,
                        Findings& found) {
  const Point a = subject.mesh.points[chain.front().from];
  const Point b = subject.mesh.points[chain.back().to];
  const Units tolerance = domain.tolerance(chain.front().segment);
  const double allowed =
      (tolerance.x * std::abs(b.y - a.y) + tolerance.y * std::abs(b.x - a.x)) / std::hypot(b.x - a.x, b.y - a.y);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Point p = subject.mesh.points[chain[i].from];
    const Index vertex = subject.names.vertex(chain[i].from);
    if (!exactly::line_offset_exceeds(p, a, b, tolerance)) continue;
    found.add(ViolationKind::chain_off_segment, {vertex, chain[i].segment}, {p},
              "vertex " + vertex_number(vertex) + " on segment " + domain_number(chain[i].segment) +
                  ": its squared distance from the segment is " + exactly::squared_line_distance_text(p, a, b) +
                  ", more than the square of " + to_text(allowed));
  }
}

/// The segment other than that of the chain whose chain passes the vertex where this edge of the chain begins; no_index
/// if there is none, or if the vertex is an input point. `is_near`: per segment, whether it has a chain within the
/// tolerance. Others are reported anyway.
Index met_by(const ChainEdge& edge, const Chains& chains, const InputVertices& inputs,
             const std::vector<char>& is_near) {
  const Index other = inputs.input(edge.from) == no_index ? chains.segment_of[edge.from] : no_index;
  return other == no_index || is_near[other] == 0 ? no_index : other;
}

void report_meeting(const ChainEdge& edge, Index other, const Subject& subject, const Domain& domain, Findings& found) {
  const Index vertex = subject.names.vertex(edge.from);
  found.add(ViolationKind::chains_meet, {vertex, other, edge.segment}, {subject.mesh.points[edge.from]},
            "vertex " + vertex_number(vertex) + " is no input point, but the edges on " + segment_text(domain, other) +
                " and those on " + segment_text(domain, edge.segment) + " meet there");
}

}  // namespace

Witness segment_text(const Domain& domain, Index segment) {
  return domain.is_hull_piece(segment) ? "the hull" : "segment " + domain_number(segment);
}

Chains check_segments(const Subject& subject, const Domain& domain, const Adjacency& adjacency,
                      const InputVertices& inputs, const Scan& scan, Findings& found) {
  Chains chains;
  chains.segment_of.resize(subject.mesh.points.size(), no_index);
  chains.on_chain.resize(subject.mesh.triangles.size(), 0);
  const std::size_t segments = domain.segments().size();
  const MeshEdges mesh{subject.mesh.points.span(), adjacency, MarkedEdges(subject.mesh, adjacency, scan, found.stop())};

  // Chains are found in blocks of segments, each block on all threads. Only the chains of one block are stored twice.
  constexpr std::size_t block = 4096;
  std::vector<std::vector<ChainEdge>> walked(std::min(block, segments));
  std::vector<char> is_near(segments, 0);
  for (std::size_t first = 0; first < segments; first += block) {
    const std::size_t size = std::min(block, segments - first);
    check_each(size, found, [&](std::size_t i, Findings& mine) {
      const auto s = static_cast<Index>(first + i);
      walked[i].clear();
      if (!domain.has(s)) return;
      walked[i] = find_chain(s, domain, mesh, inputs, Strictness::exact, found.stop());
      is_near[s] = walked[i].empty() ? 0 : 1;
      if (!walked[i].empty()) return;
      walked[i] = find_chain(s, domain, mesh, inputs, Strictness::loose, found.stop());
      if (walked[i].empty())
        report_broken(s, subject, domain, mine);
      else
        report_off_segment(walked[i], subject, domain, mine);
    });
    SparseAsk ask(found.stop());
    for (std::size_t i = 0; i < size; ++i) {
      const auto s = static_cast<Index>(first + i);
      if (walked[i].empty() && domain.has(s)) chains.broken.push_back(s);
      const auto meets = [&](const ChainEdge& edge) { return met_by(edge, chains, inputs, is_near) != no_index; };
      if (is_near[s] != 0 && std::ranges::any_of(walked[i], meets)) {
        // Without a list of constrained edges, a chain can take edges of a segment that nearly coincides with its own.
        auto apart = find_chain(s, domain, mesh, inputs, Strictness::exact, found.stop(), chains.segment_of.span());
        if (!apart.empty()) walked[i] = std::move(apart);
        for (const ChainEdge& edge : walked[i])
          if (meets(edge)) report_meeting(edge, met_by(edge, chains, inputs, is_near), subject, domain, found);
      }
      for (const ChainEdge& edge : walked[i]) {
        ask();
        chains.edges.push_back(edge);
        if (inputs.input(edge.from) == no_index) chains.segment_of[edge.from] = s;
        for (const TriangleEdge side : {edge.left, edge.right})
          if (side.exists())
            chains.on_chain[side.triangle] = static_cast<std::uint8_t>(chains.on_chain[side.triangle] | 1 << side.edge);
      }
    }
  }
  check_chain_order(subject, domain, chains, inputs, found);
  return chains;
}

}  // namespace pardel::checker
