// The mesh depends neither on the number of threads, nor on which task makes the next insertion, nor on how ranks share
// the work, nor on the delays of their messages: the same domain is meshed with one thread, with several threads, with
// interleaved tasks, and on several ranks.
#include <algorithm>
#include <string>
#include <vector>

#include "../core/digest.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/domains/dealt_domain.hpp"
#include "../properties/domains/generators/random.hpp"
#include "../properties/theorems/framework/mesh_of_ranks.hpp"
#include "fuzz_one.hpp"
#include "mesh_case.hpp"
#include "with_schedule.hpp"

namespace pardel::fuzz {
namespace {

/// The longer side of the bounding box.
double extent_of(std::span<const Point> points) {
  const auto [left, right] = std::ranges::minmax(points, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(points, {}, &Point::y);
  return std::max(right.x - left.x, high.y - low.y);
}

void compare_with_threads(const Pslg& pslg, const MeshCase& drawn, Options options) {
  options.threads = 1;
  const Result<Meshed> one = mesh(pslg, drawn.goal, options);
  options.threads = drawn.threads;
  const Result<Meshed> several = mesh(pslg, drawn.goal, options);
  if (one.ok() != several.ok()) fail("the number of threads decides whether there is an error");
  if (!one) {
    if (one.error().message != several.error().message) fail("the error depends on the number of threads");
    return;
  }
  if (digest(one->mesh) != digest(several->mesh)) fail("the mesh depends on the number of threads");
  if (one->mesh != several->mesh) fail("the numbering of the mesh depends on the number of threads");
  if (one->report.exempt != several->report.exempt) fail("the report depends on the number of threads");
}

/// Whose turn it is among the tasks of a phase. Each byte decides for one to four insertions. After the last byte the
/// sequence begins anew; in each further pass, one random number is added to all bytes.
class Turns {
 public:
  Turns(std::span<const std::uint8_t> bytes, std::uint64_t seed) : bytes_(bytes), random_(seed) {}

  std::size_t next(std::size_t tasks) {
    if (left_ == 0 || turn_ >= tasks) {
      const std::size_t at = taken_++ % (bytes_.size() + 1);
      if (at == bytes_.size()) added_ = random_.below(256);
      const std::size_t byte = ((at < bytes_.size() ? bytes_[at] : 0) + added_) % 256;
      turn_ = byte % tasks;
      left_ = 1 + byte / 64;
    }
    --left_;
    return turn_;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  generators::Random random_;
  std::size_t taken_ = 0, added_ = 0, turn_ = 0, left_ = 0;
};

/// One thread runs the tasks of a phase together, one insertion at a time. The bytes of the strokes decide whose turn
/// it is. An area bound gives the mesh some thousand triangles, so that several tasks have work.
void compare_with_interleaved_tasks(const Pslg& pslg, const MeshCase& drawn, std::span<const std::uint8_t> strokes) {
  const double extent = extent_of(pslg.points);
  const Goal goal{.min_angle_deg = drawn.goal.min_angle_deg,
                  .max_area = extent * extent / 3000,
                  .conforming = drawn.goal.conforming,
                  .convex_hull = drawn.goal.convex_hull};
  Options options{.threads = 1, .min_edge = extent / 200};
  const auto cells = static_cast<Index>(3 + drawn.seed % 5);
  options.cells = {cells, cells};
  const auto plain = refine_with_schedule(pslg, goal, options, {});
  Turns turns(strokes, drawn.seed);
  const auto other =
      refine_with_schedule(pslg, goal, options, {.next = [&](std::size_t tasks) { return turns.next(tasks); }});
  if (plain.ok() != other.ok()) fail("the order of the insertions decides whether there is an error");
  if (plain && digest(plain->mesh) != digest(other->mesh)) fail("the mesh depends on the order of the insertions");
}

/// Each rank calls make(ranks) for its piece. Together the pieces have to be the mesh.
template <class Make>
void compare_on_ranks(const Mesh& whole, int count, std::uint64_t seed_of_delays, const Make& make) {
  const std::string difference = properties::difference_on_ranks(whole, count, make, seed_of_delays);
  if (!difference.empty()) fail(difference);
}

/// The points get an attribute that is not linear.
void add_curved_attribute(Pslg& pslg) {
  pslg.attributes_per_point = 1;
  for (const Point p : pslg.points) pslg.point_attributes.push_back(p.x * p.x + p.y);
}

/// The same for ranks, which have no limit on vertices: only where the mesh keeps it anyway. If possible, also for
/// ranks of which none has all points. Half of the domains get an attribute that is not linear.
void compare_with_ranks(Pslg pslg, const MeshCase& drawn, Options options) {
  if (drawn.seed % 2 == 0 && pslg.attributes_per_point == 0) add_curved_attribute(pslg);
  Goal goal = drawn.goal;
  goal.min_angle_deg = std::min(goal.min_angle_deg, 28.0);
  options.threads = 1;
  if (const auto limited = mesh(pslg, goal, options); !limited || limited->report.count(ExemptReason::budget) > 0)
    return;
  options.max_vertices = 0;
  const Result<Meshed> whole = mesh(pslg, goal, options);
  const auto domain = validate(pslg, {.convex_hull = goal.convex_hull});
  if (!whole || !domain) fail("a valid Pslg was rejected");
  const std::uint64_t seed_of_delays = drawn.seed % 4 == 0 ? drawn.seed + 1 : 0;
  compare_on_ranks(whole->mesh, drawn.ranks, seed_of_delays,
                   [&](Ranks& ranks) { return mesh(*domain, goal, options, ranks); });
  if (can_divide_points(goal, options))
    compare_on_ranks(whole->mesh, drawn.ranks, 0,
                     [&](Ranks& ranks) { return mesh(domains::equal_part(pslg, ranks), goal, options, ranks); });
  if (drawn.seed / 8 % 2 == 0) return;
  options.interior = Interior::fill;
  const Result<Meshed> filled = mesh(*domain, goal, options);
  if (!filled) fail("a valid Pslg was rejected: " + filled.error().message);
  compare_on_ranks(filled->mesh, drawn.ranks, seed_of_delays,
                   [&](Ranks& ranks) { return mesh(*domain, goal, options, ranks); });
}

/// Each rank has a part of the points of the domain. Together they make the triangulation of one process.
void compare_triangulations(const Pslg& pslg, const MeshCase& drawn) {
  Pslg points;
  points.points = pslg.points;
  add_curved_attribute(points);
  const Result<Meshed> whole = triangulate(points);
  if (!whole) fail("the points of a valid Pslg were rejected: " + whole.error().message);
  compare_on_ranks(whole->mesh, drawn.ranks, 0, [&](Ranks& ranks) {
    return triangulate(domains::equal_part(points, ranks).points, {.threads = 1}, ranks);
  });
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  const MeshCase drawn = decode_mesh_case(bytes);
  const Prepared prepared = prepare(drawn);
  if (!prepared.usable) return -1;
  Options options = drawn.options;
  // Many tiles, so that there is something to interleave.
  options.triangles_per_tile = std::min(options.triangles_per_tile, 40U);
  options.max_vertices = std::min<std::uint64_t>(options.max_vertices, prepared.pslg.points.size() + 400);
  // First what does not depend on the time that threads take: such a find can be repeated.
  compare_with_interleaved_tasks(prepared.pslg, drawn, bytes.subspan(std::min(bytes.size(), header_bytes)));
  options.interior = drawn.seed % 3 == 0 ? Interior::fill : Interior::refine;
  compare_with_threads(prepared.pslg, drawn, options);
  options.interior = Interior::refine;
  if (drawn.seed / 16 % 2 == 0) compare_triangulations(prepared.pslg, drawn);
  if (!drawn.nudged) compare_with_ranks(prepared.pslg, drawn, options);
  return 0;
}

}  // namespace pardel::fuzz
