#include "check_faces.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "../arithmetic/predicates.hpp"
#include "../segments/faces.hpp"
#include "convex_hull.hpp"

namespace pardel::engine {
namespace {

/// The sides of the convex hull that are not segments.
std::vector<Segment> sides_of_hull(const Pslg& pslg, const Threads& threads) {
  SparseAsk ask(threads.stop);
  const auto ends = [](const Segment& s) { return std::pair(std::min(s.a, s.b), std::max(s.a, s.b)); };
  std::vector<std::pair<Index, Index>> known;
  for (const Segment& s : pslg.segments) known.push_back(ends(s));
  std::ranges::sort(known, [&](const auto& e, const auto& f) {
    ask();
    return e < f;
  });
  const std::vector<Index> hull = convex_hull(pslg.points, threads);
  std::vector<Segment> sides;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Segment side{hull[i], hull[(i + 1) % hull.size()]};
    if (!std::ranges::binary_search(known, ends(side))) sides.push_back(side);
  }
  return sides;
}

/// Examines the seeds. `segments` can have sides of the hull after the segments of the Pslg.
class CheckSeeds {
 public:
  CheckSeeds(const Pslg& pslg, const Swept& swept, const Faces& faces, Findings& found)
      : pslg_(pslg), swept_(swept), faces_(faces), found_(found), in_domain_(faces.count(), true) {
    in_domain_[Faces::exterior] = false;
  }

  void check_holes() {
    std::vector<Index> in_faces;
    for (Index h = 0; h < pslg_.holes.size(); ++h) {
      const Index face = face_of(h, h, pslg_.holes[h], ProblemKind::hole_outside, ProblemKind::hole_on_segment);
      if (face == no_index) continue;
      if (face == Faces::exterior) {
        found_.add(ProblemKind::hole_outside, {h}, pslg_.holes[h]);
        continue;
      }
      in_domain_[face] = false;
      in_faces.push_back(h);
    }
    if (std::ranges::find(in_domain_, true) == in_domain_.end())
      found_.add(ProblemKind::no_domain, in_faces, pslg_.holes[in_faces[0]]);
  }

  void check_regions() {
    std::vector<Index> region_of(faces_.count(), no_index);
    const auto holes = static_cast<Index>(pslg_.holes.size());
    for (Index r = 0; r < pslg_.regions.size(); ++r) {
      const Point seed = pslg_.regions[r].seed;
      const Index face = face_of(holes + r, r, seed, ProblemKind::region_outside, ProblemKind::region_on_segment);
      if (face == no_index) continue;
      if (!in_domain_[face]) {
        found_.add(ProblemKind::region_outside, {r}, seed);
        continue;
      }
      if (region_of[face] != no_index) found_.add(ProblemKind::regions_share_face, {region_of[face], r}, seed);
      region_of[face] = r;
    }
  }

 private:
  /// The face that contains a seed. If the seed is unusable or on a segment, reports a problem and returns no_index.
  Index face_of(Index query, Index id, Point seed, ProblemKind outside, ProblemKind on_segment) {
    if (!is_usable(seed)) {
      found_.add(outside, {id}, seed);
      return no_index;
    }
    if (const Index s = swept_.through[query]; s != no_index) {
      found_.add(on_segment, s < pslg_.segments.size() ? std::vector{id, s} : std::vector{id}, seed);
      return no_index;
    }
    return faces_.above(swept_.below[pslg_.points.size() + query]);
  }

  const Pslg& pslg_;
  const Swept& swept_;
  const Faces& faces_;
  Findings& found_;
  std::vector<bool> in_domain_;
};

void check_faces_between(const Pslg& pslg, std::span<const Segment> segments, const Swept& swept,
                         const Threads& threads, Findings& found) {
  const Faces faces(pslg.points, segments, swept.below, threads.stop);
  if (faces.count() == 1) {
    found.add(ProblemKind::unclosed_outline, {}, pslg.points[segments[0].a]);
    return;
  }
  CheckSeeds seeds(pslg, swept, faces, found);
  seeds.check_holes();
  seeds.check_regions();
}

}  // namespace

std::vector<Point> seeds_of(const Pslg& pslg) {
  std::vector<Point> seeds = pslg.holes;
  for (const Region& region : pslg.regions) seeds.push_back(region.seed);
  return seeds;
}

void check_faces(const Pslg& pslg, bool convex_hull, const Swept& swept, const Threads& threads, Findings& found) {
  if (!convex_hull && !pslg.segments.empty()) {
    check_faces_between(pslg, pslg.segments, swept, threads, found);
    return;
  }
  if (pslg.holes.empty() && pslg.regions.empty()) return;
  std::vector<Segment> segments = pslg.segments;
  std::ranges::copy(sides_of_hull(pslg, threads), std::back_inserter(segments));
  const std::vector<Point> seeds = seeds_of(pslg);
  const Swept with_hull =
      sweep_plane({.points = pslg.points, .segments = segments, .queries = seeds, .stop = threads.stop});
  check_faces_between(pslg, segments, with_hull, threads, found);
}

}  // namespace pardel::engine
