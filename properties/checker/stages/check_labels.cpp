// Checks the data that the mesh lists: constrained edges, markers, origins, regions, attributes.
#include <algorithm>
#include <functional>

#include "../../../core/support/same_attribute.hpp"
#include "../arithmetic/text.hpp"
#include "../model/attribute_ranges.hpp"
#include "stages.hpp"

namespace pardel::checker {
namespace {

/// The rule of the program Triangle: the segment's own non-zero marker, else 1 on the boundary of the domain, else 0.
int expected_marker(const Domain& domain, Index segment) {
  const int own = domain.segments()[segment].marker;
  return own != 0 ? own : domain.on_boundary(segment) ? 1 : 0;
}

/// Compares the mesh's list of constrained edges with the chains that check_segments() found.
class ConstrainedEdges {
 public:
  ConstrainedEdges(const Subject& subject, const Domain& domain, const Chains& chains, Findings& found)
      : mesh_(subject.mesh), names_(subject.names), foreign_(subject.options.foreign), domain_(domain), found_(found) {
    for (const ChainEdge& edge : chains.edges)
      expected_.push_back({std::min(edge.from, edge.to), std::max(edge.from, edge.to), edge.segment, false});
    const auto less = [](const Expected& x, const Expected& y) {
      return std::pair(x.low, x.high) < std::pair(y.low, y.high);
    };
    stoppable_sort(expected_.begin(), expected_.end(), less, found.stop());
    // A file may list constrained edges without markers.
    check_markers_ = !foreign_ || std::any_of(mesh_.constrained_edges.begin(), mesh_.constrained_edges.end(),
                                              [](const ConstrainedEdge& e) { return e.marker != 0; });
  }

  void check(const ConstrainedEdge& edge, Index position, bool is_mesh_edge) {
    const auto [low, high] = std::minmax(edge.a, edge.b);
    const auto match = std::lower_bound(
        expected_.begin(), expected_.end(), std::pair(low, high),
        [](const Expected& e, const std::pair<Index, Index>& key) { return std::pair(e.low, e.high) < key; });
    if (match == expected_.end() || match->low != low || match->high != high)
      return report(ViolationKind::wrong_constrained_edge, edge, position,
                    is_mesh_edge ? "is listed as constrained but is part of no segment"
                                 : "is listed as constrained but is no edge of the mesh");
    if (match->listed) return report(ViolationKind::wrong_constrained_edge, edge, position, "is listed twice");
    match->listed = true;
    const Index segment = domain_.is_hull_piece(match->segment) ? no_index : match->segment;
    if (edge.segment != segment && !(foreign_ && edge.segment == no_index))
      report(ViolationKind::wrong_constrained_edge, edge, position,
             "lists segment " + id_text(edge.segment) + " but is part of " + id_text(segment));
    const int marker = expected_marker(domain_, match->segment);
    if (check_markers_ && edge.marker != marker)
      report(ViolationKind::wrong_edge_marker, edge, position,
             "has marker " + to_text(edge.marker) + " instead of " + to_text(marker));
  }

  void report_unlisted() {
    for (const Expected& edge : expected_)
      if (!edge.listed)
        found_.add(ViolationKind::missing_constrained_edge,
                   {names_.vertex(edge.low), names_.vertex(edge.high), edge.segment},
                   {mesh_.points[edge.low], mesh_.points[edge.high]},
                   "edge " + names_.edge_text(edge.low, edge.high) + " is part of segment " +
                       domain_number(edge.segment) + " but is not listed as constrained");
  }

 private:
  struct Expected {
    Index low, high;
    Index segment;
    bool listed;
  };

  static Witness id_text(Index segment) { return segment == no_index ? "none" : domain_number(segment); }

  void report(ViolationKind kind, const ConstrainedEdge& edge, Index position, const Witness& what) {
    found_.add(kind, {names_.listed_edge(position), names_.vertex(edge.a), names_.vertex(edge.b)},
               {mesh_.points[edge.a], mesh_.points[edge.b]},
               "constrained edge " + to_text(names_.listed_edge(position)) + " (" + names_.edge_text(edge.a, edge.b) +
                   ") " + what);
  }

  const Mesh& mesh_;
  const Numbering& names_;
  bool foreign_;
  bool check_markers_ = true;
  const Domain& domain_;
  Findings& found_;
  std::vector<Expected> expected_;
};

void check_constrained_edges(const Subject& subject, const Domain& domain, const Adjacency& adjacency,
                             const Chains& chains, Findings& found) {
  const auto& listed = subject.mesh.constrained_edges;
  if (listed.empty() && subject.options.foreign) return;
  ConstrainedEdges edges(subject, domain, chains, found);
  SparseAsk ask(found.stop());
  for (std::size_t e = 0; e < listed.size(); ++e) {
    ask();
    const ConstrainedEdge& edge = listed[e];
    const bool is_mesh_edge = adjacency.left_of(edge.a, edge.b).exists() || adjacency.left_of(edge.b, edge.a).exists();
    edges.check(edge, static_cast<Index>(e), is_mesh_edge);
  }
  edges.report_unlisted();
}

/// The non-zero markers of the constrained edges at each vertex, as sorted pairs (vertex, marker). In a foreign mesh
/// the markers of segments outside the domain count as well.
std::vector<std::pair<Index, int>> markers_at_vertices(const Subject& subject, const Domain& domain,
                                                       const Chains& chains, const InputVertices& inputs,
                                                       StopSignal* stop) {
  std::vector<std::pair<Index, int>> markers;
  for (const ChainEdge& edge : chains.edges) {
    const int marker = expected_marker(domain, edge.segment);
    if (marker == 0) continue;
    markers.emplace_back(edge.from, marker);
    markers.emplace_back(edge.to, marker);
  }
  // Triangle marks the ends of segments before it removes the segments outside the domain.
  for (Index s = 0; subject.options.foreign && s < subject.pslg.segments.size(); ++s) {
    const Segment& segment = subject.pslg.segments[s];
    if (domain.has(s) || segment.marker == 0) continue;
    for (const Index end : {segment.a, segment.b}) {
      if (inputs.vertex(end) != no_index) markers.emplace_back(inputs.vertex(end), segment.marker);
    }
  }
  stoppable_sort(markers.begin(), markers.end(), std::less<>(), stop);
  markers.erase(std::unique(markers.begin(), markers.end()), markers.end());
  return markers;
}

/// The markers of the constrained edges at a vertex, "1 or 3", or "0"; empty if `given` is one of them.
std::string markers_instead_of(int given, Index vertex, std::span<const std::pair<Index, int>> markers) {
  auto at = std::lower_bound(markers.begin(), markers.end(), vertex,
                             [](const auto& entry, Index key) { return entry.first < key; });
  if (at == markers.end() || at->first != vertex) return given == 0 ? "" : "0";
  std::string text;
  for (; at != markers.end() && at->first == vertex; ++at) {
    if (at->second == given) return {};
    text += (text.empty() ? "" : " or ") + to_text(at->second);
  }
  return text;
}

/// The marker of a vertex is its own non-zero marker from the input, else a non-zero marker of one of the constrained
/// edges at it, else 0. (Edges on the boundary have their own marker, or 1.)
void check_vertex_markers(const Subject& subject, const Domain& domain, const Chains& chains,
                          const Adjacency& adjacency, const InputVertices& inputs, Findings& found) {
  const Mesh& mesh = subject.mesh;
  if (mesh.point_markers.empty()) return;
  const auto markers = markers_at_vertices(subject, domain, chains, inputs, found.stop());
  std::vector<char> is_marked(mesh.points.size(), 0);
  for (const auto& [vertex, marker] : markers) is_marked[vertex] = 1;
  check_each(mesh.points.size(), found, [&](std::size_t v, Findings& mine) {
    const auto vertex = static_cast<Index>(v);
    const int given = mesh.point_markers[v];
    const Index input = inputs.input(vertex);
    const bool has_own = input != no_index && input < subject.pslg.point_markers.size();
    const int own = has_own ? subject.pslg.point_markers[input] : 0;
    if (own != 0 ? given == own : (given == 0 && is_marked[v] == 0) || !adjacency.has_triangle(vertex)) return;
    const std::string expected = own != 0 ? to_text(own) : markers_instead_of(given, vertex, markers);
    if (expected.empty()) return;
    mine.add(ViolationKind::wrong_vertex_marker, {subject.names.vertex(vertex)}, {mesh.points[v]},
             "vertex " + vertex_number(subject.names.vertex(vertex)) + " has marker " + to_text(given) +
                 " instead of " + expected);
  });
}

Witness origin_text(Index origin) {
  if (origin == input_vertex) return "an input point";
  if (origin == interior_vertex) return "in the interior";
  if (origin == hull_vertex) return "on the hull";
  return "on segment " + domain_number(segment_of_origin(origin));
}

void check_origins(const Subject& subject, const Domain& domain, const Chains& chains, const InputVertices& inputs,
                   Findings& found) {
  const Mesh& mesh = subject.mesh;
  if (mesh.origin.empty()) return;
  check_each(mesh.points.size(), found, [&](std::size_t v, Findings& mine) {
    const auto vertex = static_cast<Index>(v);
    const Index segment = chains.segment_of[v];
    const Index expected = inputs.input(vertex) != no_index ? input_vertex
                           : segment == no_index            ? interior_vertex
                           : domain.is_hull_piece(segment)  ? hull_vertex
                                                            : origin_on_segment(segment);
    if (mesh.origin[v] != expected)
      mine.add(ViolationKind::wrong_origin, {subject.names.vertex(vertex)}, {mesh.points[v]},
               "vertex " + vertex_number(subject.names.vertex(vertex)) + " is listed as " +
                   origin_text(mesh.origin[v]) + " but is " + origin_text(expected));
  });
}

}  // namespace

void check_regions(const Subject& subject, const Domain& domain, std::span<const Index> faces, Findings& found) {
  const Mesh& mesh = subject.mesh;
  const auto& regions = subject.pslg.regions;
  const bool foreign = subject.options.foreign;
  if (mesh.region.empty() || (foreign && regions.empty())) return;
  check_each(mesh.region.size(), found, [&](std::size_t t, Findings& mine) {
    const Index given = mesh.region[t];
    const auto seeded = faces.empty() ? decltype(domain.regions_in(0)){} : domain.regions_in(faces[t]);
    if (seeded.empty() && (given == no_index || (foreign && mesh.region_attributes[given] == 0))) return;
    const bool right =
        given != no_index && std::any_of(seeded.begin(), seeded.end(), [&](const auto& entry) {
          const Index region = entry.second;
          return mesh.region_attributes[given] == regions[region].attribute && (foreign || given == region);
        });
    if (right) return;
    const std::string is =
        given == no_index ? "no region" : "the region attribute " + to_text(mesh.region_attributes[given]);
    const Witness belongs = seeded.empty() ? "no region"
                                           : to_text(regions[seeded[0].second].attribute) + ", that of region " +
                                                 domain_number(seeded[0].second);
    mine.add(ViolationKind::wrong_region, {subject.names.triangle(static_cast<Index>(t)), given},
             {subject.corner(mesh.triangles[t], 0), subject.corner(mesh.triangles[t], 1),
              subject.corner(mesh.triangles[t], 2)},
             "triangle " + triangle_number(subject.names.triangle(static_cast<Index>(t))) + " has " + is +
                 ", but its face has " + belongs);
  });
}

namespace {

/// The attributes of vertices that are no input points. Other meshers than pardel may interpolate across a segment.
void check_interpolated_attributes(const Subject& subject, const Domain& domain, const Chains& chains,
                                   const InputVertices& inputs, Findings& found) {
  const Mesh& mesh = subject.mesh;
  const AttributeRanges ranges(subject.pslg);
  check_each(mesh.points.size(), found, [&](std::size_t i, Findings& mine) {
    const auto v = static_cast<Index>(i);
    const Index segment = chains.segment_of[v];
    const bool is_on_segment = segment != no_index && !domain.is_hull_piece(segment) && !subject.options.foreign;
    const Segment* on = is_on_segment ? &domain.segments()[segment] : nullptr;
    const auto outside = ranges.first_outside(mesh, v, on);
    if (!outside || inputs.input(v) != no_index) return;
    const Index name = subject.names.vertex(v);
    const auto& [attribute, range] = *outside;
    mine.add(ViolationKind::wrong_attribute, {name}, {mesh.points[v]},
             "attribute " + to_text(attribute) + " of vertex " + vertex_number(name) + " is " +
                 to_text(mesh.point_attributes[i * mesh.attributes_per_point + attribute]) + ", but those of the " +
                 (is_on_segment ? "ends of segment " + domain_number(segment) : "input points") + " are between " +
                 to_text(range.least) + " and " + to_text(range.greatest));
  });
}

void check_attributes(const Subject& subject, const Domain& domain, const Chains& chains, const InputVertices& inputs,
                      Findings& found) {
  const Mesh& mesh = subject.mesh;
  const std::size_t n = mesh.attributes_per_point;
  if (n == 0 || subject.pslg.point_attributes.size() != n * subject.pslg.points.size()) return;
  SparseAsk ask(found.stop());
  for (std::size_t i = 0; i < subject.pslg.points.size(); ++i) {
    ask();
    const Index v = inputs.vertex(static_cast<Index>(i));
    if (v == no_index) continue;
    for (std::size_t k = 0; k < n; ++k) {
      const double given = mesh.point_attributes[v * n + k];
      const double belongs = subject.pslg.point_attributes[i * n + k];
      if (is_same_attribute(given, belongs)) continue;
      found.add(ViolationKind::wrong_attribute, {subject.names.vertex(v)}, {mesh.points[v]},
                "attribute " + to_text(k) + " of vertex " + vertex_number(subject.names.vertex(v)) + " is " +
                    to_text(given) + " instead of " + to_text(belongs));
    }
  }
  check_interpolated_attributes(subject, domain, chains, inputs, found);
}

}  // namespace

void check_labels(const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                  const InputVertices& inputs, Findings& found) {
  check_constrained_edges(subject, domain, adjacency, chains, found);
  check_vertex_markers(subject, domain, chains, adjacency, inputs, found);
  check_origins(subject, domain, chains, inputs, found);
  check_attributes(subject, domain, chains, inputs, found);
}

}  // namespace pardel::checker
