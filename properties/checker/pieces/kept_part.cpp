#include "kept_part.hpp"

#include "../../../core/support/point_order.hpp"

namespace pardel::checker {

InputPlaces::InputPlaces(std::span<const Point> inputs) : sorted_(inputs.begin(), inputs.end()) {
  std::ranges::sort(sorted_, lexicographically_less);
}

bool InputPlaces::contains(Point p) const {
  const auto at = std::ranges::lower_bound(sorted_, p, lexicographically_less);
  return at != sorted_.end() && *at == p;
}

namespace {

bool has_open_test(const Scan& scan, Index t) {
  const auto at = std::ranges::lower_bound(scan.open, t, {}, &OpenTriangle::triangle);
  return at != scan.open.end() && at->triangle == t;
}

class PartMaker {
 public:
  PartMaker(const Piece& piece, const InputPlaces& inputs, const FreePoints& free, const AttributeRanges& ranges,
            std::span<const std::uint64_t> also)
      : piece_(piece), mesh_(piece.mesh()), why_(mesh_.points.size(), 0) {
    mark(inputs, free, ranges, also);
  }

  KeptPart make(NumberSet& all_settled) {
    part_.kinds = {mesh_.point_markers.empty() ? 0u : 1u, mesh_.origin.empty() ? 0u : 1u, mesh_.attributes_per_point};
    list_settled(all_settled);
    list_triangles();
    list_vertices();
    for (KeptTriangle& triangle : part_.triangles)
      for (Index& v : triangle.v) v = place_[v];
    for (const BoundaryEdge& edge : piece_.adjacency->boundary()) {
      const auto [t, side] = edge.left;
      const Index apex = piece_.adjacency->triangles()[t].v[side];
      part_.sides.push_back({place_[edge.from], place_[edge.to], place_[apex], t, static_cast<std::uint8_t>(side),
                             has_open_test(piece_.scanned, t)});
    }
    for (const ConstrainedEdge& edge : mesh_.constrained_edges)
      if (std::max(edge.a, edge.b) < mesh_.points.size())
        part_.edges.push_back({number(edge.a), number(edge.b), edge.segment, edge.marker});
    return std::move(part_);
  }

 private:
  static constexpr char special = 1, at_border = 2, also_kept = 4, corner = 8, settled = 16;

  [[nodiscard]] Index number(Index v) const { return static_cast<Index>(piece_.source->number[v]); }
  [[nodiscard]] bool has_markers() const { return mesh_.point_markers.size() == mesh_.points.size(); }
  [[nodiscard]] bool has_origins() const { return mesh_.origin.size() == mesh_.points.size(); }

  void mark(const InputPlaces& inputs, const FreePoints& free, const AttributeRanges& ranges,
            std::span<const std::uint64_t> also) {
    const Adjacency& adjacency = *piece_.adjacency;
    for_each_index(mesh_.points.size(), nullptr, [&](std::size_t i, std::size_t) {
      const auto v = static_cast<Index>(i);
      const std::uint64_t number = piece_.source->number[v];
      int why = 0;
      if (is_at_border(v, adjacency)) why |= at_border;
      if (!also.empty() && std::ranges::binary_search(also, number)) why |= also_kept;
      if ((why & also_kept) == 0 && free.is_settled(piece_, v))
        why |= settled;
      else if (!adjacency.has_triangle(v) || number < inputs.count() || inputs.contains(mesh_.points[v]) ||
               (has_markers() && mesh_.point_markers[v] != 0) ||
               (has_origins() && mesh_.origin[v] != interior_vertex) || ranges.first_outside(mesh_, v))
        why |= special;
      why_[v] = static_cast<char>(why);
    });
    for (const ConstrainedEdge& edge : mesh_.constrained_edges)
      for (const Index end : {edge.a, edge.b})
        if (end < why_.size()) why_[end] = static_cast<char>((why_[end] | special) & ~settled);
  }

  /// From here on, `why_` says only why vertices are kept.
  void list_settled(NumberSet& all_settled) {
    for (Index v = 0; v < why_.size(); ++v) {
      if ((why_[v] & settled) == 0) continue;
      all_settled.insert(number(v));
      why_[v] = static_cast<char>(why_[v] & ~settled);
    }
  }

  void list_triangles() {
    std::vector<std::vector<KeptTriangle>> parts(share_count());
    for_each_index(mesh_.triangles.size(), nullptr, [&](std::size_t t, std::size_t share) {
      const auto& v = mesh_.triangles[t].v;
      if ((why_[v[0]] | why_[v[1]] | why_[v[2]]) != 0) parts[share].push_back({v, static_cast<Index>(t)});
    });
    for (const auto& part : parts) part_.triangles.insert(part_.triangles.end(), part.begin(), part.end());
    for (const KeptTriangle& triangle : part_.triangles)
      for (const Index v : triangle.v) why_[v] = static_cast<char>(why_[v] | corner);
  }

  void list_vertices() {
    place_.resize_uninitialised(mesh_.points.size());
    const std::size_t k = mesh_.attributes_per_point;
    const bool has_attributes = mesh_.point_attributes.size() == k * mesh_.points.size();
    for (Index v = 0; v < why_.size(); ++v) {
      if (why_[v] == 0) continue;
      place_[v] = static_cast<Index>(part_.vertices.size());
      part_.vertices.push_back({mesh_.points[v], number(v), has_origins() ? mesh_.origin[v] : interior_vertex,
                                has_markers() ? mesh_.point_markers[v] : 0, (why_[v] & special) != 0,
                                (why_[v] & at_border) != 0});
      for (std::size_t i = 0; i < k; ++i)
        part_.attributes.push_back(has_attributes ? mesh_.point_attributes[v * k + i] : 0);
    }
  }

  const Piece& piece_;
  const Mesh& mesh_;
  Array<char> why_;     ///< per vertex of the piece: why it is kept
  Array<Index> place_;  ///< per vertex that is kept
  KeptPart part_;
};

}  // namespace

KeptPart part_to_keep(const Piece& piece, const InputPlaces& inputs, const FreePoints& free,
                      const AttributeRanges& ranges, NumberSet& settled, std::span<const std::uint64_t> also) {
  return PartMaker(piece, inputs, free, ranges, also).make(settled);
}

}  // namespace pardel::checker
