// Validation: finds every problem of a Pslg. A valid Pslg becomes a ValidPslg, the type that the mesher takes.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "problem.hpp"

namespace pardel {

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
