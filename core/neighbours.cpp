#include "neighbours.hpp"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <vector>

#include "support/exception_of.hpp"
#include "support/stop_signal.hpp"

namespace pardel {
namespace {

/// Side 3t + i is the edge opposite corner i of triangle t.
struct Ends {
  Index low;
  Index high;
};

Ends ends_of(const Array<Triangle>& triangles, Index side) {
  const auto& v = triangles[side / 3].v;
  const auto [low, high] = std::minmax(v[(side + 1) % 3], v[(side + 2) % 3]);
  return {low, high};
}

/// Joins the sides of a mesh in which each edge has at most one triangle on each side, as in a mesh of triangles that
/// all turn the same way. Each pair consists of a side that rises, from its lower to its higher end, and one that
/// falls. Only the rising sides are sorted by their lower ends, with a counting sort; the falling sides look for them.
class PairedSides {
 public:
  PairedSides(Array<Triangle>& triangles, std::size_t points, StopSignal* stop)
      : triangles_(triangles), points_(points), stop_(stop) {}

  /// False if the mesh has no such form. Then the neighbours have no meaning.
  bool join() {
    sort_rising();
    ask();
    if (!are_rising_distinct()) return false;
    ask();
    if (!join_falling()) return false;
    ask();
    return is_each_joined_once();
  }

 private:
  struct Rising {
    Index high;
    Index side;
  };
  void ask() const {
    if (stop_ != nullptr) stop_->ask();
  }

  static constexpr int most_threads = 8;
  static constexpr std::size_t least_parallel = 1 << 15;
  /// The threads take blocks of this size. One that other work of the machine holds up leaves more to the others.
  static constexpr std::size_t block = 1 << 13;

  [[nodiscard]] int threads() const {
    return triangles_.size() < least_parallel ? 1 : std::min(omp_get_max_threads(), most_threads);
  }

  /// Calls visit(place, counts, high, side) for all sides. If the side rises and its lower end is from `first` to
  /// `last` - 1, counts is 1 and the place is this end. Otherwise counts is 0 and the place is `spare_place`. There are
  /// no branches, because a processor would guess every other one wrong.
  template <class Visit>
  void visit_rising(std::size_t first, std::size_t last, std::size_t spare_place, const Visit& visit) const {
    const std::size_t length = last - first;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& v = triangles_[t].v;
      for (int i = 0; i < 3; ++i) {
        const Index from = v[i == 2 ? 0 : i + 1], to = v[i == 0 ? 2 : i - 1];
        const Index counts = static_cast<Index>(from < to) & static_cast<Index>(from - first < length);
        visit(counts != 0 ? from : spare_place, counts, to, static_cast<Index>(3 * t + i));
      }
    }
  }

  /// Each thread sorts the sides with lower ends in its own range of points. So there is one order for any number of
  /// threads, and no two threads write to one place.
  void sort_rising() {
    const int n = threads();
    constexpr std::size_t apart = 16;  // places of different threads are in different cache lines
    const auto range = [&](int k) { return points_ * static_cast<std::size_t>(k) / static_cast<std::size_t>(n); };
    const auto spare_place = [&](int k) { return points_ + 1 + apart * static_cast<std::size_t>(k); };
    start_.resize(spare_place(n), 0);
#pragma omp parallel for num_threads(n) schedule(static, 1)
    for (int k = 0; k < n; ++k)
      visit_rising(range(k), range(k + 1), spare_place(k),
                   [&](std::size_t place, Index counts, Index, Index) { start_[place] += counts; });
    ask();
    std::size_t sum = 0;
    for (std::size_t p = 0; p <= points_; ++p) start_[p] = static_cast<Index>(sum += start_[p]);
    for (int k = 0; k < n; ++k) start_[spare_place(k)] = static_cast<Index>(sum + static_cast<std::size_t>(k));
    rising_.resize_uninitialised(sum + static_cast<std::size_t>(n));
#pragma omp parallel for num_threads(n) schedule(static, 1)
    for (int k = 0; k < n; ++k)
      visit_rising(range(k), range(k + 1), spare_place(k),
                   [&](std::size_t place, Index counts, Index high, Index side) {
                     start_[place] -= counts;
                     rising_[start_[place]] = {high, side};
                   });
  }

  [[nodiscard]] std::span<const Rising> rising_from(std::size_t low) const {
    return rising_.span().subspan(start_[low], start_[low + 1] - start_[low]);
  }

  /// False if two rising sides have the same ends, or if there are too many at one point to compare them quickly.
  [[nodiscard]] bool are_rising_distinct() const {
    std::atomic<bool> distinct = true;
#pragma omp parallel for num_threads(threads()) schedule(dynamic, block)
    for (std::size_t p = 0; p < points_; ++p) {
      const auto sides = rising_from(p);
      bool fine = sides.size() <= most_at_a_point;
      for (std::size_t i = 0; fine && i < sides.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) fine = fine && sides[i].high != sides[j].high;
      if (!fine) distinct = false;
    }
    return distinct;
  }

  /// False if two falling sides without a rising one have the same ends, or if a triangle would be its own neighbour.
  bool join_falling() {
    for_each_triangle([&](Triangle& triangle) { triangle.n = {no_index, no_index, no_index}; });
    std::vector<std::vector<std::pair<Index, Index>>> alone(static_cast<std::size_t>(threads()));
    std::vector<std::exception_ptr> thrown(alone.size());
    std::vector<std::size_t> joined(alone.size(), 0);
    std::atomic<bool> fine = true;
#pragma omp parallel for num_threads(threads()) schedule(dynamic, block)
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& v = triangles_[t].v;
      for (std::size_t i = 0; i < 3; ++i) {
        const Index from = v[i == 2 ? 0 : i + 1], to = v[i == 0 ? 2 : i - 1];
        if (from < to) continue;
        const auto sides = rising_from(to);
        const auto match = std::find_if(sides.begin(), sides.end(), [=](const Rising& r) { return r.high == from; });
        const auto thread = static_cast<std::size_t>(omp_get_thread_num());
        if (match == sides.end()) {
          if (!thrown[thread]) thrown[thread] = exception_of([&] { alone[thread].emplace_back(to, from); });
          continue;
        }
        if (match->side / 3 == t) fine = false;
        ++joined[thread];
        triangles_[t].n[i] = match->side / 3;
        std::atomic_ref<Index>(triangles_[match->side / 3].n[match->side % 3])
            .store(static_cast<Index>(t), std::memory_order_relaxed);
      }
    }
    for (const std::exception_ptr& exception : thrown)
      if (exception) std::rethrow_exception(exception);
    for (std::size_t k = 1; k < alone.size(); ++k) alone[0].insert(alone[0].end(), alone[k].begin(), alone[k].end());
    std::sort(alone[0].begin(), alone[0].end());
    for (const std::size_t each : joined) joined_ += each;
    return fine && std::adjacent_find(alone[0].begin(), alone[0].end()) == alone[0].end();
  }

  /// False if two falling sides were joined to one rising side: then fewer sides than pairs of two have a neighbour.
  [[nodiscard]] bool is_each_joined_once() const {
    std::size_t with_neighbour = 0;
#pragma omp parallel for num_threads(threads()) schedule(dynamic, block) reduction(+ : with_neighbour)
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const Index n : triangles_[t].n) with_neighbour += n != no_index ? 1 : 0;
    return with_neighbour == 2 * joined_;
  }

  template <class Change>
  void for_each_triangle(const Change& change) {
#pragma omp parallel for num_threads(threads()) schedule(dynamic, block)
    for (std::size_t t = 0; t < triangles_.size(); ++t) change(triangles_[t]);
  }

  static constexpr std::size_t most_at_a_point = 64;

  Array<Triangle>& triangles_;
  std::size_t points_;
  StopSignal* stop_;
  Array<Index> start_;
  Array<Rising> rising_;
  std::size_t joined_ = 0;
};

/// For any triangles. A counting sort groups the sides by their lower end. Within a group, a table indexed by the
/// higher end finds the other side of the same edge. A second pass over the same group clears the table.
std::size_t join_any_sides(Array<Triangle>& triangles, std::size_t points, StopSignal* stop) {
  SparseAsk ask(stop);
  const auto sides = static_cast<Index>(3 * triangles.size());
  Array<Index> start(points + 1, 0);
  for (Index s = 0; s < sides; ++s) ++start[ends_of(triangles, s).low];
  for (std::size_t p = 0, sum = 0; p <= points; ++p) start[p] = static_cast<Index>(sum += start[p]);
  Array<Index> by_low_end(sides, 0);
  for (Index s = sides; s-- > 0;) by_low_end[--start[ends_of(triangles, s).low]] = s;

  Array<Index> open(points, no_index);  // indexed by the higher end: the first side of this edge, or `closed`
  constexpr Index closed = no_index - 1;
  std::size_t surplus = 0;
  for (std::size_t p = 0; p < points; ++p) {
    ask();
    const auto around = by_low_end.span().subspan(start[p], start[p + 1] - start[p]);
    for (const Index s : around) {
      Index& waiting = open[ends_of(triangles, s).high];
      triangles[s / 3].n[s % 3] = no_index;
      if (waiting == no_index) {
        waiting = s;
      } else if (waiting == closed || waiting / 3 == s / 3) {
        ++surplus;
      } else {
        triangles[s / 3].n[s % 3] = waiting / 3;
        triangles[waiting / 3].n[waiting % 3] = s / 3;
        waiting = closed;
      }
    }
    for (const Index s : around) open[ends_of(triangles, s).high] = no_index;
  }
  return surplus;
}

}  // namespace

std::size_t rebuild_neighbours(Array<Triangle>& triangles, std::size_t points, StopSignal* stop) {
  if (PairedSides(triangles, points, stop).join()) return 0;
  return join_any_sides(triangles, points, stop);
}

}  // namespace pardel
