#include "repair.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "decomposition/bounding_box.hpp"
#include "diagnosis/count_faces.hpp"
#include "diagnosis/narrowest_part.hpp"
#include "diagnosis/tiny_gaps.hpp"
#include "domain/repair_once.hpp"
#include "segments/snapping.hpp"
#include "sizing/guarded.hpp"
#include "triangulation/triangle_shape.hpp"

namespace pardel {

using namespace engine;

namespace {

/// Of the scale of a gap.
constexpr double default_share = 0x1p-38;

/// The smallest box that contains all segments; without segments, all points; without points, the origin.
Box box_around(const Pslg& pslg) {
  Box box = empty_box;
  for (const Segment& s : pslg.segments)
    for (const Index end : {s.a, s.b})
      if (end < pslg.points.size()) box.cover(Box::around(pslg.points[end]));
  if (box.min_x <= box.max_x) return box;
  if (pslg.points.empty()) return Box::around(Point{});
  return bounding_box(1, pslg.points.size(), [&](std::size_t i) { return pslg.points[i]; });
}

Error tangled() {
  return {ErrorKind::invalid_input,
          "Segments meet so closely that splitting them at rounded crossings makes ever more crossings; a larger "
          "snapping distance may help."};
}

Result<Repaired> result_of(Result<RepairStage> stage) {
  if (!stage) return stage.error();
  return std::move(stage->repaired);
}

/// A repair that chooses its snapping distances itself. Each of its steps continues an earlier one if there is one.
class AutomaticRepair {
 public:
  AutomaticRepair(const Pslg& pslg, bool convex_hull, StopSignal& stop)
      : pslg_(pslg), convex_hull_(convex_hull), stop_(stop) {}

  /// What fails for the Pslg may succeed for its repair. So the repair goes on until it changes nothing more, or no
  /// step fails: repairing the result again changes nothing.
  Result<Repaired> repair() {
    Result<RepairStage> stage = attempt(nullptr);
    for (int i = 0; stage && has_failed_ && i < most_attempts; ++i) {
      Result<RepairStage> next = attempt(&*stage);
      if (!next || next->repaired.domain.pslg() == stage->repaired.domain.pslg()) break;
      stage = std::move(next);
    }
    return result_of(std::move(stage));
  }

 private:
  static constexpr int most_attempts = 20;  // two were seen

  [[nodiscard]] const Pslg& begin(const RepairStage* from) const {
    return from == nullptr ? pslg_ : from->repaired.domain.pslg();
  }

  Result<RepairStage> attempt(const RepairStage* from) {
    has_failed_ = false;
    Result<RepairStage> stage = repair_roundings(from);
    if (stage) close_tiny_gaps(*stage, from);
    return stage;
  }

  std::optional<Result<RepairStage>> once(const Snapping& snapping, const RepairStage* from) {
    std::optional<Result<RepairStage>> stage = repair_once(pslg_, snapping, convex_hull_, stop_, from);
    if (!stage || !*stage)
      has_failed_ = true;
    else
      snapping_ = snapping;
    return stage;
  }

  Result<RepairStage> repair_roundings(const RepairStage* from);
  void close_tiny_gaps(RepairStage& stage, const RepairStage* from);

  const Pslg& pslg_;
  bool convex_hull_;
  StopSignal& stop_;
  Snapping snapping_ = 0;    ///< of the last step that did not fail
  bool has_failed_ = false;  ///< a step of this attempt
};

/// With the default snapping distances, or smaller ones if those fail. Smaller distances do not help against crossings
/// that become more and more; then only zero is tried.
Result<RepairStage> AutomaticRepair::repair_roundings(const RepairStage* from) {
  for (const double factor : {1.0, 0x1p-4, 0x1p-8, 0x1p-12}) {
    std::optional<Result<RepairStage>> stage = once(Snapping::share_of_scale(factor * default_share), from);
    if (!stage) break;
    if (*stage) return std::move(*stage);
  }
  return once(0, from).value_or(tangled());
}

/// Closes gaps with larger and larger snapping distances, each at its own scale, until the result has no tiny gaps.
void AutomaticRepair::close_tiny_gaps(RepairStage& stage, const RepairStage* from) {
  Snapping snapping = snapping_;
  while (widen_to_tiny_gaps(snapping, begin(from), stage.repaired.domain, stop_)) {
    std::optional<Result<RepairStage>> wider = once(snapping, from);
    if (!wider || !*wider) break;
    stage = std::move(**wider);
  }
}

}  // namespace

double default_snap(const Pslg& pslg) { return default_share * box_around(pslg).largest_magnitude(); }

double largest_default_snap(const Pslg& pslg) { return TinyDistances(pslg).largest(); }

Result<Repaired> repair(const Pslg& pslg, const RepairOptions& options) try {
  if (options.snap && !(*options.snap >= 0 && std::isfinite(*options.snap)))
    return Error{ErrorKind::usage, "the snapping distance must be zero or positive, and finite"};
  StopSignal stop(StopSignal::unless(options.go_on));
  if (const std::vector<Problem> unusable = find_unusable_values(pslg, stop); !unusable.empty())
    return Error{ErrorKind::invalid_input, messages(unusable, pslg.first_id.value)};
  if (!options.snap) return AutomaticRepair(pslg, options.convex_hull, stop).repair();
  return result_of(repair_once(pslg, *options.snap, options.convex_hull, stop).value_or(tangled()));
} catch (const Stopped& stopped) {
  return stopped.error;
}

namespace {

/// A narrow gap contains a much smaller part of the domain.
constexpr double most_change_of_area = 0.01;

double twice_area_of(const DomainTriangulation& domain) {
  const Triangulation& t = domain.triangulation;
  double sum = 0;
  for (const Slot& slot : t.slots) sum += Shape(t, slot).twice_area;
  return sum;
}

/// The number of different values.
std::size_t distinct(std::vector<Index> values) {
  std::ranges::sort(values);
  return static_cast<std::size_t>(std::unique(values.begin(), values.end()) - values.begin());
}

}  // namespace

Result<SnapEffect> effect_of_snap(const ValidPslg& domain, double snap) try {
  const Pslg& before = domain.pslg();
  const Result<DomainTriangulation> triangulated = triangulate_domain(before, domain.convex_hull());
  if (!triangulated) return triangulated.error();
  const Result<Repaired> repaired = repair(before, {.snap = snap, .convex_hull = domain.convex_hull()});
  if (!repaired)
    return repaired.error().kind == ErrorKind::invalid_input ? SnapEffect{} : Result<SnapEffect>(repaired.error());
  const Pslg& after = repaired->domain.pslg();
  const Result<DomainTriangulation> changed = triangulate_domain(after, repaired->domain.convex_hull());
  if (!changed) return changed.error();
  std::vector<Index> kept = repaired->segment_map;
  std::erase(kept, no_index);
  const double area = twice_area_of(*triangulated);
  SnapEffect effect{.succeeds = true,
                    .points = before.points.size() - distinct(repaired->point_map),
                    .segments = before.segments.size() - distinct(std::move(kept)),
                    .faces_before = count_faces(*triangulated),
                    .faces_after = count_faces(*changed),
                    .area = (twice_area_of(*changed) - area) / area};
  effect.keeps_all_parts = narrowest_part(*triangulated) > snap && after.holes.size() == before.holes.size() &&
                           after.regions.size() == before.regions.size() &&
                           std::abs(effect.area) <= most_change_of_area;
  return effect;
} catch (...) {
  return error_of_exception();
}

}  // namespace pardel
