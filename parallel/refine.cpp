#include "refine.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "../core/mutants.hpp"
#include "parallel_for.hpp"
#include "task.hpp"

namespace pardel {
namespace {

/// What quality alone makes of a triangle of the input, at the very least.
constexpr double triangles_per_input_triangle = 1.7;
/// A vertex makes two triangles; a fifth to spare.
constexpr double insertions_per_triangle = 0.6;
/// From one lattice to the next finer one, the side of a cell shrinks by this factor.
constexpr Index levels_apart = 4;
/// A level splits what is longer than this part of the next finer level's cell: shorter triangles have
/// cavities that fit that level's boxes.
constexpr double long_in_finer_cells = 0.25;

Box bounds_of(std::span<const Point> points) {
  Box box{INFINITY, INFINITY, -INFINITY, -INFINITY};
  for (const Point p : points) {
    box.min_x = std::min(box.min_x, p.x);
    box.min_y = std::min(box.min_y, p.y);
    box.max_x = std::max(box.max_x, p.x);
    box.max_y = std::max(box.max_y, p.y);
  }
  return box;
}

/// The lattices from one cell to the finest, which has about this many, coarse to fine.
std::vector<Lattice> lattices(Box bounds, double tiles) {
  const double width = bounds.max_x - bounds.min_x, height = bounds.max_y - bounds.min_y;
  const double longer = std::max(width, height), shorter = std::max(std::min(width, height), longer * 1e-3);
  constexpr double most_along = 4096;
  auto along = static_cast<Index>(std::clamp(std::sqrt(std::max(tiles, 1.0) * longer / shorter), 1.0, most_along));
  std::vector<Lattice> result;
  while (along > 1) {
    result.push_back(Lattice::over(bounds, along));
    along = (along + levels_apart - 1) / levels_apart;
  }
  result.push_back(Lattice::over(bounds, 1));
  std::reverse(result.begin(), result.end());
  return result;
}

/// A task to be: a cell with what waits for it.
struct Job {
  Index cell = 0;
  std::vector<Queued> seeds;
  std::vector<Queued> outsiders;  ///< seeds whose triangles do not lie in the box
  double insertions = 0;          ///< expected
  Supply supply;
  TaskResult result;
};

class Refinement {
 public:
  Refinement(Triangulation& t, const Lines& lines, const Criteria& criteria, const Options& options)
      : t_(t),
        criteria_(criteria),
        options_(options),
        judge_(t, lines, criteria, options),
        threads_(std::max(1, options.threads)),
        vertices_(static_cast<Index>(t.points.size()), most_vertices(t, options)),
        triangles_(static_cast<Index>(t.slots.size()), max_triangles) {
    for (int i = 0; i < threads_; ++i) tasks_.push_back(std::make_unique<Task>(t, judge_, criteria, options.min_edge));
  }

  void run() {
    Pending pending = everything_bad();
    const Box bounds = bounds_of(t_.points.span());
    const std::vector<Lattice> levels = lattices(
        bounds, options_.decomposition == Decomposition::none ? 1 : pending.estimate / options_.triangles_per_tile);
    estimate_ = pending.estimate;
    triangles_before_ = triangles_.in_use();
    deferred_ = std::move(pending.triangles);

    // Down: what is long at a level is split there; what gets short enough waits for a finer one.
    for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
      const double longest = long_in_finer_cells * levels[level + 1].side();
      sweep_to_fixpoint(levels[level], std::exchange(deferred_, {}), {longest * longest});
    }
    // At the finest, everywhere the shorter half of the work comes before the longer: points put in for long
    // triangles would only be in the way of those that short ones need anyway. Tiles that finish one by one cannot
    // have this order by themselves, and neither has one queue over everything: it makes larger meshes.
    const Deferral longer_half{0, median_key(deferred_)};
    sweep_to_fixpoint(levels.back(), std::exchange(deferred_, {}), longer_half);
    if (!mutated("longer_half_forgotten")) sweep_to_fixpoint(levels.back(), std::exchange(deferred_, {}), {});
    // Up: what no box of a level could hold gets a larger one.
    for (std::size_t level = levels.size() - 1; level-- > 0;)
      sweep_to_fixpoint(levels[level], std::exchange(stuck_, {}), {});
    close_ranks();
    counts_.left_alone = counts_.left_alone || !stuck_.empty();  // with a point that is nowhere
  }

  [[nodiscard]] bool cancelled() const { return cancelled_.load(); }
  [[nodiscard]] bool out_of_triangles() const { return triangles_.available() < 2; }
  [[nodiscard]] RefineCounts counts() && { return std::move(counts_); }

 private:
  struct Pending {
    std::vector<Queued> triangles;
    double estimate = 0;
  };

  static Index most_vertices(const Triangulation& t, const Options& options) {
    const auto present = static_cast<std::uint64_t>(t.points.size());
    if (options.max_vertices == 0) return max_triangles;
    return static_cast<Index>(
        std::clamp<std::uint64_t>(options.max_vertices, present, std::max<std::uint64_t>(present, max_triangles)));
  }

  /// All triangles that ask for something, and how many triangles the result may have.
  Pending everything_bad() {
    std::vector<Pending> found(block_count(t_.slots.size()));
    std::vector<char> left_alone(found.size(), 0);
    parallel_blocks(threads_, t_.slots.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
      for (std::size_t id = first; id < last; ++id) {
        const auto triangle = static_cast<TriangleId>(id);
        found[block].estimate += std::max(triangles_per_input_triangle, wanted_by(triangle));
        const Assessment a = judge_.assess(triangle);
        if (a.need != Assessment::Need::nothing) found[block].triangles.push_back({triangle, t_.slots[triangle].v[0]});
        if (a.left_alone) left_alone[block] = 1;
      }
    });
    Pending all;
    for (const Pending& block : found) {
      all.estimate += block.estimate;
      all.triangles.insert(all.triangles.end(), block.triangles.begin(), block.triangles.end());
    }
    counts_.left_alone = std::any_of(left_alone.begin(), left_alone.end(), [](char c) { return c != 0; });
    return all;
  }

  [[nodiscard]] double wanted_by(TriangleId id) const {
    return criteria_.triangles_wanted(Shape(t_, t_.slots[id]), judge_.region_of(id));
  }

  [[nodiscard]] bool go_on() const { return !cancelled_.load(std::memory_order_relaxed) && !counts_.budget_reached; }

  /// Asked by tasks now and then; the caller hears of it on its own thread only.
  bool report(int thread, std::uint64_t vertices_made) {
    made_ += 2 * vertices_made;
    if (cancelled_.load(std::memory_order_relaxed)) return false;
    if (thread == 0 && options_.progress && !options_.progress({triangles_before_ + made_.load(), estimate_}))
      cancelled_ = true;
    return !cancelled_.load(std::memory_order_relaxed);
  }

  [[nodiscard]] unsigned median_key(const std::vector<Queued>& ids) const {
    if (ids.empty()) return BucketQueue::last;
    std::vector<unsigned> keys(ids.size());
    parallel_blocks(threads_, ids.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = first; i < last; ++i) keys[i] = judge_.assess(ids[i].id).key;
    });
    const auto middle = keys.begin() + static_cast<std::ptrdiff_t>(keys.size() / 2);
    std::nth_element(keys.begin(), middle, keys.end());
    return *middle;
  }

  void sweep_to_fixpoint(const Lattice& lattice, const std::vector<Queued>& pending, const Deferral& later) {
    constexpr Index nowhere = no_index, afterwards = no_index - 1;
    std::vector<Index> cell(pending.size());
    parallel_blocks(threads_, pending.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = first; i < last; ++i) {
        cell[i] = nowhere;
        if (!judge_.is_current(pending[i])) continue;
        const TriangleId id = pending[i].id;
        const Assessment a = judge_.assess(id);
        if (a.need != Assessment::Need::nothing)
          cell[i] = later.applies_to(a) ? afterwards : lattice.cell_of(judge_.point_for(id, a));
      }
    });
    std::vector<std::vector<Queued>> inbox(lattice.cells());
    for (std::size_t i = 0; i < pending.size(); ++i) {
      if (cell[i] == nowhere) continue;
      (cell[i] == afterwards ? deferred_ : inbox[cell[i]]).push_back(pending[i]);
    }
    const auto waiting = [&] {
      return std::any_of(inbox.begin(), inbox.end(), [](const auto& b) { return !b.empty(); });
    };
    // A triangle may ask now for a point in one cell, now for one in another, and be sent to and fro for ever: what
    // two sweeps without an insertion have tried wherever it asked to be needs a larger box.
    for (int idle = 0; idle < 2 && waiting() && go_on();) {
      idle = sweep(lattice, inbox, later) > 0 ? 0 : idle + 1;
      if (mutated("sweeps_after_the_first_skipped")) return;
    }
    for (const std::vector<Queued>& waits : inbox) stuck_.insert(stuck_.end(), waits.begin(), waits.end());
  }

  /// Four phases, one per colour. Returns the number of vertices inserted.
  std::uint64_t sweep(const Lattice& lattice, std::vector<std::vector<Queued>>& inbox, const Deferral& later) {
    const auto start = std::chrono::steady_clock::now();
    Sweep done{lattice.cells(), 0, 0, 0};
    for (unsigned colour = 0; colour < Lattice::colours && go_on(); ++colour) {
      const std::vector<double> wanted = wanted_in_cells(inbox);
      std::vector<Job> jobs;
      for (Index cell = 0; cell < lattice.cells(); ++cell)
        if (lattice.colour_of(cell) == colour && !inbox[cell].empty()) {
          jobs.emplace_back();
          jobs.back().cell = cell;
          jobs.back().seeds = std::exchange(inbox[cell], {});
          jobs.back().insertions = insertions_per_triangle * lattice.sum_over_box(cell, wanted);
        }
      phase(lattice, jobs, later);
      for (Job& job : jobs) {
        done.inserted += job.result.inserted + job.result.segment_splits;
        done.handed_on += job.result.handed_on.size();
        for (const HandedOn& h : job.result.handed_on)
          if (!mutated("hand_on_dropped")) inbox[h.cell].push_back(h.triangle);
        collect(job);
      }
      vertices_.settle();
      triangles_.settle();
      triangles_before_ = triangles_.in_use();
      made_ = 0;
    }
    done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    counts_.sweeps.push_back(done);
    if (vertices_.available() == 0) counts_.budget_reached = counts_.left_alone = true;
    if (out_of_triangles()) cancelled_ = true;
    return done.inserted;
  }

  /// Cells of one colour have disjoint boxes: their tasks run in any order, at the same time.
  void phase(const Lattice& lattice, std::vector<Job>& jobs, const Deferral& later) {
    parallel_for(threads_, jobs.size(), [&](std::size_t i, int) { admit(jobs[i], lattice.box_of(jobs[i].cell)); });
    supply(jobs);
    t_.points.resize_uninitialised(vertices_.end());
    t_.origin.resize_uninitialised(vertices_.end());
    t_.slots.resize_uninitialised(triangles_.end());
    if (!t_.region.empty()) t_.region.resize_uninitialised(triangles_.end());

    std::vector<std::size_t> largest_first(jobs.size());
    std::iota(largest_first.begin(), largest_first.end(), std::size_t{0});
    std::stable_sort(largest_first.begin(), largest_first.end(),
                     [&](std::size_t a, std::size_t b) { return jobs[a].insertions > jobs[b].insertions; });
    parallel_for(threads_, jobs.size(), [&](std::size_t i, int thread) {
      Job& job = jobs[largest_first[i]];
      if (mutated("order_depends_on_threads") && threads_ > 1) std::reverse(job.seeds.begin(), job.seeds.end());
      job.result = tasks_[static_cast<std::size_t>(thread)]->run(
          lattice, job.cell, job.seeds, later, job.supply, [&](std::uint64_t made) { return report(thread, made); });
    });
  }

  /// Numbers for each job: as many as it is expected to need, and as many again above all of these. What is not used
  /// comes back, so the second helping costs memory only where it is needed.
  void supply(std::vector<Job>& jobs) {
    std::vector<std::vector<NumberRange>> vertices(jobs.size()), triangles(jobs.size());
    for (int helping = 0; helping < 2; ++helping)
      for (std::size_t i = 0; i < jobs.size(); ++i) {
        const auto insertions = static_cast<std::size_t>(std::min(jobs[i].insertions, 1e9));
        vertices_.assign(insertions, vertices[i]);
        triangles_.assign(2 * insertions, triangles[i]);
      }
    for (std::size_t i = 0; i < jobs.size(); ++i)
      jobs[i].supply = {Numbers(std::move(vertices[i])), Numbers(std::move(triangles[i]))};
  }

  /// What the sizes ask for where the triangles lie that wait in each cell.
  [[nodiscard]] std::vector<double> wanted_in_cells(const std::vector<std::vector<Queued>>& inbox) const {
    std::vector<double> wanted(inbox.size(), 0);
    if (!criteria_.has_size()) return wanted;
    parallel_for(threads_, inbox.size(), [&](std::size_t cell, int) {
      for (const Queued q : inbox[cell])
        if (judge_.is_current(q)) wanted[cell] += wanted_by(q.id);
    });
    return wanted;
  }

  /// Keeps the seeds that are still there and whose triangles lie in the box.
  void admit(Job& job, const Box& box) const {
    constexpr double insertions_per_seed = 2.5, spare = 32;
    job.insertions += spare;
    std::erase_if(job.seeds, [&](Queued q) {
      if (!judge_.is_current(q)) return true;
      for (const VertexId v : t_.slots[q.id].v)
        if (!box.contains(t_.points[v])) {
          job.outsiders.push_back(q);
          return true;
        }
      job.insertions += insertions_per_seed;
      return false;
    });
  }

  void collect(const Job& job) {
    vertices_.take_back(job.supply.vertices);
    triangles_.take_back(job.supply.triangles);
    const TaskResult& r = job.result;
    stuck_.insert(stuck_.end(), job.outsiders.begin(), job.outsiders.end());
    if (!mutated("stuck_triangles_forgotten")) stuck_.insert(stuck_.end(), r.stuck.begin(), r.stuck.end());
    deferred_.insert(deferred_.end(), r.deferred.begin(), r.deferred.end());
    counts_.inserted += r.inserted;
    counts_.segment_splits += r.segment_splits;
    counts_.refused += r.refused;
    counts_.left_alone = counts_.left_alone || r.left_alone;
  }

  /// Moves the last vertices and triangles into the holes that unused numbers left.
  void close_ranks() {
    const std::vector<NumberMove> triangle_moves = moves_into_holes(triangles_);
    for (const NumberMove move : triangle_moves) {
      t_.move_triangle(move.from, move.to);
      if (!t_.region.empty()) t_.region[move.to] = mutated("region_left_behind") ? 0 : t_.region[move.from];
    }
    const std::size_t triangles = triangles_.in_use();
    t_.slots.resize(triangles);
    if (!t_.region.empty()) t_.region.resize(triangles);

    const std::vector<NumberMove> vertex_moves = moves_into_holes(vertices_);
    const VertexId vertices = vertices_.in_use();
    std::vector<VertexId> moved_to(t_.points.size() - vertices, no_index);
    for (const NumberMove move : vertex_moves) {
      t_.points[move.to] = t_.points[move.from];
      t_.origin[move.to] = t_.origin[move.from];
      moved_to[move.from - vertices] = move.to;
    }
    if (!vertex_moves.empty())
      parallel_blocks(threads_, triangles, [&](std::size_t first, std::size_t last, std::size_t) {
        for (std::size_t id = first; id < last; ++id)
          for (VertexId& v : t_.slots[id].v)
            if (v >= vertices) v = moved_to[v - vertices];
      });
    t_.points.resize(vertices);
    t_.origin.resize(vertices);
  }

  Triangulation& t_;
  const Criteria& criteria_;
  const Options& options_;
  Judge judge_;
  int threads_;
  std::vector<std::unique_ptr<Task>> tasks_;
  NumberLedger vertices_, triangles_;
  std::vector<Queued> stuck_, deferred_;
  RefineCounts counts_;
  double estimate_ = 0;
  std::uint64_t triangles_before_ = 0;  ///< when the last phase ended
  std::atomic<std::uint64_t> made_{0};  ///< since then, as far as tasks have told
  std::atomic<bool> cancelled_{false};
};

}  // namespace

Result<RefineCounts> refine(Triangulation& t, const Lines& lines, const Criteria& criteria, const Options& options) {
  Refinement refinement(t, lines, criteria, options);
  refinement.run();
  if (refinement.out_of_triangles())
    return Error{ErrorKind::resources, "the mesh needs more triangles than can be numbered (2^29 - 1)"};
  if (refinement.cancelled()) return Error{ErrorKind::cancelled, "the caller asked to stop"};
  return std::move(refinement).counts();
}

}  // namespace pardel
