// The segments that one rank knows, and how they travel to other ranks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../../core/support/message.hpp"
#include "../../parallel/construction/domain_triangulation.hpp"
#include "../../parallel/threads/sparse_array.hpp"
#include "names.hpp"

namespace pardel::engine {

/// A rank knows all segments that end at corners of its triangles, and those that contain one of its vertices. The
/// first segments are common: all ranks know them, with the same indices.
class HeldSegments {
 public:
  /// The segments are those of the domain, to which more are added as they arrive. `common`: the number of common ones.
  HeldSegments(DomainTriangulation& domain, std::uint32_t self, Index common)
      : domain_(domain), common_(common), names_(self, common) {}

  /// Another rank has named the segment.
  void name(Index segment, Name name) { names_.bind(name, segment); }
  [[nodiscard]] Name name_of(Index segment) const { return names_.of(segment); }
  /// A domain that has the common segments, but no triangles, and no vertices.
  [[nodiscard]] DomainTriangulation domain_of_common() const;
  [[nodiscard]] const DomainSegments& segments() const { return domain_.segments; }
  [[nodiscard]] Index common() const { return common_; }

  /// An origin as it travels: of a vertex inside a segment, the name of the segment.
  [[nodiscard]] std::uint64_t travelling_origin(Index origin) const;
  /// Precondition: the segment, if there is one, has arrived.
  [[nodiscard]] Index arrived_origin(std::uint64_t origin) const;

  /// What travels with vertices.
  struct Outgoing {
    std::vector<VertexId> ends;         ///< the vertices at which segments end
    std::vector<Index> count, at_ends;  ///< for each of them, how many segments, and which
    std::vector<Index> segments;        ///< those of `at_ends`, and those that contain a vertex; without common ones
  };
  /// What travels with the corners of triangles.
  [[nodiscard]] Outgoing leaving_with(std::span<const VertexId> corners);
  /// `place_of(v)`: the place of a vertex in the message.
  template <class PlaceOf>
  void write(const Outgoing& outgoing, const PlaceOf& place_of, Writer& message) const;
  /// Takes over what write() has written. `vertices`: those of the message.
  void read(Reader& message, std::span<const VertexId> vertices);

 private:
  struct TravellingSegment;
  struct TravellingPlace {
    double distance, gap;
    std::uint64_t at_b;  ///< 1 if the apex is end b, else 0
  };
  struct TravellingClearance {
    double x, y, gap, slope;
    std::uint64_t is_passed;  ///< 1 or 0
  };
  struct TravellingEnd {
    Index vertex, count;
  };

  template <class PlaceOf>
  [[nodiscard]] TravellingSegment travelling(Index segment, const PlaceOf& place_of) const;
  void place(const TravellingSegment& arrived, std::span<const TravellingPlace> places,
             std::span<const TravellingClearance> clearances, std::span<const VertexId> vertices);

  DomainTriangulation& domain_;
  Index common_;
  Names names_;
  SparseArray<char> is_listed_;  ///< scratch memory of leaving_with()
};

struct HeldSegments::TravellingSegment {
  enum class Narrow : Index { none, at_a, at_b };
  std::uint64_t name;
  double cosine_at_a, cosine_at_b;
  Index a, b;  ///< places in the message's list of vertices
  Narrow narrow;
  Index input;
  int marker;
  Index places;              ///< the number of places beside ends
  std::uint64_t clearances;  ///< their number
};

template <class PlaceOf>
HeldSegments::TravellingSegment HeldSegments::travelling(Index segment, const PlaceOf& place_of) const {
  using Narrow = TravellingSegment::Narrow;
  const DomainSegment& s = domain_.segments[segment];
  const Narrow narrow = s.narrow_apex == no_index ? Narrow::none : s.narrow_apex == s.a ? Narrow::at_a : Narrow::at_b;
  return {Names::packed(name_of(segment)),
          s.cosine_at_a,
          s.cosine_at_b,
          place_of(s.a),
          place_of(s.b),
          narrow,
          domain_.input_segment[segment],
          s.marker,
          static_cast<Index>(domain_.segments.places_beside_ends(segment).size()),
          domain_.segments.clearances(segment).size()};
}

template <class PlaceOf>
void HeldSegments::write(const Outgoing& outgoing, const PlaceOf& place_of, Writer& message) const {
  const std::vector<Index>& segments = outgoing.segments;
  message.list_of<TravellingSegment>(segments.size(), [&](std::size_t i) { return travelling(segments[i], place_of); });
  std::vector<TravellingPlace> places;
  for (const Index s : segments)
    for (const PlaceBesideEnd& place : domain_.segments.places_beside_ends(s))
      places.push_back({place.distance, place.gap, place.apex == domain_.segments[s].b ? 1U : 0U});
  message.list(places);
  std::vector<TravellingClearance> clearances;
  for (const Index s : segments)
    for (const Clearance& c : domain_.segments.clearances(s))
      clearances.push_back({c.at.x, c.at.y, c.gap, c.slope, c.is_passed ? 1U : 0U});
  message.list(clearances);
  message.list_of<TravellingEnd>(outgoing.ends.size(), [&](std::size_t i) {
    return TravellingEnd{place_of(outgoing.ends[i]), outgoing.count[i]};
  });
  message.list_of<std::uint64_t>(outgoing.at_ends.size(),
                                 [&](std::size_t i) { return Names::packed(name_of(outgoing.at_ends[i])); });
}

}  // namespace pardel::engine
