// Validation: finds every problem of a Pslg. A valid Pslg becomes a ValidPslg, the type that the mesher takes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../core/pslg.hpp"
#include "../core/result.hpp"

namespace pardel {

enum class ProblemKind : std::uint8_t {
  non_finite_coordinate,
  coordinate_out_of_range,  ///< magnitude above 2^200, or below 2^-140 and not zero
  wrong_count,              ///< the number of attributes or markers does not fit the number of points
  index_out_of_range,       ///< an end of a segment is not the index of a point
  duplicate_points,
  zero_length_segment,
  duplicate_segments,
  crossing_segments,     ///< two segments cross at a point interior to both; `where` is this point, rounded
  overlapping_segments,  ///< two segments are collinear and have more than one common point
  point_on_segment,      ///< a point lies in the interior of a segment
  all_points_collinear,  ///< also reported for fewer than three points
  unclosed_outline,      ///< no segments enclose a face, so there is no domain
  no_domain,             ///< every face contains a hole
  hole_outside,          ///< the hole is in no bounded face, or exact arithmetic cannot use its coordinates
  hole_on_segment,
  region_outside,  ///< the seed is in no face of the domain, or exact arithmetic cannot use its coordinates
  region_on_segment,
  regions_share_face,  ///< two regions, consecutive among those of a face, have their seeds in the same face
  bad_region_cap,      ///< an area cap that is zero, negative or NaN
  cancelled,           ///< no problem of the Pslg: ValidateOptions::go_on ended the search; this is then the only entry
};
/// The enumerator as text: "duplicate_points".
[[nodiscard]] const char* name(ProblemKind kind);

/// How messages name points, segments, holes and regions.
struct NumbersInMessages {
  int base = 0;                             ///< the number of the first one: usually Pslg::first_id.value
  std::span<const std::uint64_t> points{};  ///< if not empty, the numbers of the points, instead of those from base on
  /// If not empty, the segments, which have no numbers: messages name their ends, "3-7".
  std::span<const Segment> unnumbered{};
};

struct Problem {
  ProblemKind kind;
  /// The points, segments, holes or regions concerned, counted from 0. The kind determines which of them:
  /// a point and a segment for point_on_segment, a hole and a segment for hole_on_segment, and so on.
  std::vector<Index> ids;
  Point where;

  /// One sentence with ids and coordinates. `base` is the id that the message gives to the first point, segment, hole
  /// or region: usually Pslg::first_id.value.
  [[nodiscard]] std::string message(int base = 0) const;
  [[nodiscard]] std::string message(const NumbersInMessages& numbers) const;
  /// The numbers in the message, in the order of `ids`: two for a segment that has none itself.
  [[nodiscard]] std::vector<std::uint64_t> numbers_of_ids(const NumbersInMessages& numbers) const;
};

/// The messages of several problems, one per line.
[[nodiscard]] std::string messages(const std::vector<Problem>& problems, int base = 0);
[[nodiscard]] std::string messages(const std::vector<Problem>& problems, const NumbersInMessages& numbers);

struct ValidateOptions {
  /// The domain is the convex hull of the points. An unclosed outline is then no problem. A Pslg without segments
  /// always describes the convex hull.
  bool convex_hull = false;
  /// The largest number of problems of each kind that is returned. The number of crossings can be quadratic. Therefore
  /// the search for crossing_segments, overlapping_segments and point_on_segment ends when one kind has this number.
  std::size_t max_problems = 10'000;
  /// The largest number of threads; 0 or less: as many as OpenMP offers. The result does not depend on it.
  int threads = 0;
  /// Called in the calling thread from time to time, about every 4 ms. Return false to end the search at once.
  std::function<bool()> go_on{};
};

/// Finds every problem, sorted by kind, then by ids. A Pslg without problems can be meshed. Exact: there is no
/// tolerance. Faces (unclosed_outline, no_domain, holes, regions) are examined only if points and segments have no
/// problem. Time: O((n + p) log n) for n points and segments and p problems.
[[nodiscard]] std::vector<Problem> find_problems(const Pslg& pslg, const ValidateOptions& options = {});

/// A Pslg that has no problems. Only validate() makes one, so a function that takes a ValidPslg need not check it.
class ValidPslg {
 public:
  [[nodiscard]] const Pslg& pslg() const& { return pslg_; }
  [[nodiscard]] Pslg pslg() && { return std::move(pslg_); }
  /// True if the domain is the convex hull: ValidateOptions::convex_hull was set, or there are no segments.
  [[nodiscard]] bool convex_hull() const { return convex_hull_; }
  /// The same points and segments, with the convex hull as the domain. This is valid too, because the edges of the hull
  /// lie outside the domain of the segments.
  [[nodiscard]] ValidPslg with_convex_hull() && { return {std::move(pslg_), true}; }

 private:
  friend Result<ValidPslg, std::vector<Problem>> validate(Pslg&& pslg, const ValidateOptions& options);
  friend Result<ValidPslg, std::vector<Problem>> validate(const Pslg& pslg, const ValidateOptions& options);
  ValidPslg(Pslg pslg, bool convex_hull) : pslg_(std::move(pslg)), convex_hull_(convex_hull) {}

  Pslg pslg_;
  bool convex_hull_;
};

/// Returns the Pslg as a ValidPslg, or its problems as find_problems() lists them. A valid `pslg` is moved from; an
/// invalid one is not changed. Takes the same time as find_problems().
///
///     Result<ValidPslg, std::vector<Problem>> domain = validate(std::move(pslg));
///     if (!domain) std::cerr << messages(domain.error(), pslg.first_id.value) << '\n';
///     else use(mesh(*domain, goal));
[[nodiscard]] Result<ValidPslg, std::vector<Problem>> validate(Pslg&& pslg, const ValidateOptions& options = {});
/// The same for a Pslg that the caller keeps. A valid Pslg is copied.
[[nodiscard]] Result<ValidPslg, std::vector<Problem>> validate(const Pslg& pslg, const ValidateOptions& options = {});

}  // namespace pardel
