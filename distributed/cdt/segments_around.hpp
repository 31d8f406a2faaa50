// The segments around the vertices of a rank, with what the refinement has to know about them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../../core/ranks.hpp"
#include "../../parallel/construction/hairlines.hpp"
#include "../../parallel/threads/threads.hpp"
#include "../../parallel/triangulation/domain_segments.hpp"
#include "../delaunay/own_points.hpp"
#include "../subdomain/names.hpp"
#include "given_segment.hpp"

namespace pardel::engine {

struct NamedSegment {
  GivenSegment segment;
  Name name;
};

/// The segments at the vertices of a rank's triangles. What DomainSegments tells about a segment depends on the
/// segments at its ends, and on those at the other ends of these. So a rank asks for all of them.
class SegmentsAround {
 public:
  /// Collective. `common`: the segments that all ranks have; their indices are their names. `own`: the others that end
  /// at own points, in the order of their ends; the owner of end a names them. `needed`: the positions of the vertices;
  /// own points need not be among them.
  SegmentsAround(std::span<const GivenSegment> common, std::span<const GivenSegment> own,
                 std::vector<std::uint64_t> needed, const OwnPoints& points, Ranks& ranks, const Threads& threads);

  /// Collective. Makes domain_segments() stay clear of each other at hairlines. `all`: the same on all ranks.
  void keep_clear(std::vector<Hairline> all);

  /// First the common ones, then those that this rank has named, then others; and those at the other ends of these.
  /// They have the same indices in domain_segments().
  [[nodiscard]] const std::vector<NamedSegment>& segments() const { return segments_; }
  /// The ends of the segments, in the order of their positions. These are the vertices of domain_segments().
  [[nodiscard]] const std::vector<Site>& ends() const { return ends_; }
  [[nodiscard]] const DomainSegments& domain_segments() const { return domain_segments_; }
  /// True if an end of the segment is a needed vertex or an own point. Then what domain_segments() says is right.
  [[nodiscard]] bool is_known(const GivenSegment& s) const { return is_known(s.a) || is_known(s.b); }
  /// The same for a vertex: then the segments at it are right.
  [[nodiscard]] bool is_known(const Site& end) const;

 private:
  void name_own(std::span<const GivenSegment> common, std::span<const GivenSegment> own);
  void learn_segments_around();
  [[nodiscard]] std::vector<NamedSegment> segments_at(const std::vector<std::uint64_t>& positions);
  void list_ends();
  void compute(const Threads& threads);
  [[nodiscard]] bool is_own(std::uint64_t position) const {
    return position >= first_ && position < points_.first[ranks_.rank() + 1];
  }
  /// The place of an end in ends().
  [[nodiscard]] Index index_of(const Site& end) const;
  /// The same; no_index if it is no end.
  [[nodiscard]] Index index_of(std::uint64_t position) const;
  [[nodiscard]] Array<Point> places_of_ends(const Threads& threads) const;

  const OwnPoints& points_;
  Ranks& ranks_;
  std::uint64_t first_;                ///< the position of the first own point
  std::vector<std::uint64_t> needed_;  ///< sorted
  std::vector<NamedSegment> segments_;
  std::vector<Site> ends_;
  std::vector<Index> index_of_own_;  ///< for each own point: its place in ends_, if it is an end
  DomainSegments domain_segments_;
};

}  // namespace pardel::engine
