// The part of one rank in a refinement that begins with points divided among ranks.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "../delaunay/curve_division.hpp"
#include "../meshing/distribution.hpp"
#include "part_of_domain.hpp"

namespace pardel::engine {

/// The Communicator of such a refinement. Until the finest tiles are divided, a rank holds the triangles with a corner
/// that it owns by the division of the points; a triangle is at home where its least corner is owned.
class DividedPoints : public Distribution {
 public:
  /// `part` has to outlive the object. Its triangulation is refined, and it gets more segments.
  DividedPoints(Ranks& ranks, PartOfDomain& part, const CurveDivision& division)
      : Distribution(ranks, part.domain.triangulation),
        start_(part),
        division_(division),
        segments_(part.domain, Name::rank(ranks.rank()), part.common_segments) {}

  [[nodiscard]] bool is_input_divided() const override { return true; }
  [[nodiscard]] Box bounds_of_all(const Box& here) override { return engine::bounds_of_all(here, ranks_); }
  void begin(PhaseRunner& runner) override;
  [[nodiscard]] std::function<bool(TriangleId)> counted() const override;
  [[nodiscard]] Waiting refine_coarse(const CoarseWork& coarse) override;
  void divide(const Division& division, PhaseRunner& runner) override;

  [[nodiscard]] Index known_inputs() const override { return static_cast<Index>(start_.number.size()); }
  [[nodiscard]] InputPoint input_point(VertexId v) const override {
    return {start_.number[v], start_.marker.empty() ? 0 : start_.marker[v]};
  }
  [[nodiscard]] std::uint64_t inputs() const override { return start_.points; }
  [[nodiscard]] bool lacks_markers() const override { return has_markers_; }

 private:
  struct TravellingEntry;
  [[nodiscard]] Waiting divide_anew(const Division& division);
  [[nodiscard]] Waiting exchanged(std::vector<std::vector<TravellingEntry>> entries);
  /// They serve the assessment at the beginning; nobody tells this rank about their changes.
  void drop_halo();
  /// A point belongs to the piece of the rank that owns its cell, even if it is in no triangle.
  void send_loose_points();
  [[nodiscard]] int owner_before(VertexId v, const Triangulation& t) const { return division_.owner(t.points[v]); }
  [[nodiscard]] int home_before(TriangleId id, const Triangulation& t) const;

  PartOfDomain& start_;
  const CurveDivision& division_;
  HeldSegments segments_;
  bool has_markers_ = false;  ///< on any rank
};

}  // namespace pardel::engine
