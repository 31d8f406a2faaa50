#include "resolve_halo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/message.hpp"
#include "../../core/support/point_order.hpp"
#include "../../core/support/without_repetitions.hpp"
#include "../../parallel/arithmetic/predicates.hpp"
#include "../../parallel/threads/parallel_arrays.hpp"
#include "own_points.hpp"

namespace pardel::engine {
namespace {

/// Three points of the rank that are not collinear or, if there are none, the two ends of its points.
std::vector<Index> spanning_points(std::span<const Point> own) {
  std::vector<Index> found;
  if (own.empty()) return found;
  const auto ends = std::ranges::minmax_element(own, lexicographically_less);
  const Point least = *ends.min, greatest = *ends.max;
  found = {static_cast<Index>(ends.min - own.begin()), static_cast<Index>(ends.max - own.begin())};
  const auto off_line = std::ranges::find_if(own, [&](const Point& p) { return orient2d(least, greatest, p) != 0; });
  if (off_line != own.end()) found.push_back(static_cast<Index>(off_line - own.begin()));
  return found;
}

/// The triangles about which one rank asks another one: a list of points, and three places in it per triangle. The
/// third is no_index for a ghost triangle.
class Questions {
 public:
  void add(const LocalDelaunay& delaunay, const LocalDelaunay::Corners& corners) {
    std::array<Index, 3> places{};
    for (unsigned i = 0; i < 3; ++i) places[i] = corners[i] == ghost ? no_index : place_of(delaunay, corners[i]);
    triangles_.push_back(places);
  }
  [[nodiscard]] Ranks::Bytes message() const {
    Writer writer;
    if (!triangles_.empty()) {
      writer.list(sites_);
      writer.list(triangles_);
    }
    return writer.take();
  }

 private:
  Index place_of(const LocalDelaunay& delaunay, VertexId v) {
    const auto [place, is_new] = place_.emplace(v, static_cast<Index>(sites_.size()));
    if (is_new) sites_.push_back(delaunay.site(v));
    return place->second;
  }

  std::vector<Site> sites_;
  std::vector<std::array<Index, 3>> triangles_;
  std::unordered_map<VertexId, Index> place_;
};

/// The corners with the ghost, if there is one, last.
LocalDelaunay::Corners corners_of(const Slot& slot) {
  if (!slot.is_ghost()) return slot.v;
  const unsigned corner = slot.corner_of(ghost);
  return {slot.from(corner), slot.to(corner), ghost};
}

/// Answers the questions of one rank.
Ranks::Bytes answer(const Ranks::Bytes& questions, LocalDelaunay& delaunay) {
  if (questions.empty()) return {};
  Reader reader(questions);
  const std::vector<Site> sites = reader.list<Site>();
  std::vector<Site> in_disks;
  for (const std::array<Index, 3>& places : reader.list<std::array<Index, 3>>()) {
    LocalDelaunay::Corners corners{ghost, ghost, ghost};
    for (unsigned i = 0; i < 3; ++i) {
      if (places[i] == no_index) continue;
      if (places[i] >= sites.size()) throw Reader::does_not_match();
      corners[i] = delaunay.vertex(sites[places[i]]);
    }
    for (const VertexId v : delaunay.neighbours_in_disk(corners)) in_disks.push_back(delaunay.site(v));
  }
  sort_by_position(in_disks);
  Writer writer;
  if (!in_disks.empty()) writer.list(in_disks);
  return writer.take();
}

class Asker {
 public:
  Asker(LocalDelaunay& delaunay, const CurveDivision& division, Ranks& ranks, const Threads& threads)
      : delaunay_(delaunay), division_(division), ranks_(ranks), threads_(threads) {}

  int run() {
    std::vector<TriangleId> asked = all_at_border();
    for (int rounds = 0;; ++rounds) {
      threads_.ask();
      std::vector<Questions> questions(static_cast<std::size_t>(ranks_.count()));
      std::uint64_t count = 0;
      for (const TriangleId id : asked) count += ask_about(id, questions);
      ranks_.add_up({&count, 1});
      if (count == 0) return rounds;
      exchange(questions);
      asked = delaunay_.take_fresh();
      sort_without_repetitions(asked);
      std::erase_if(asked, [&](TriangleId id) { return !delaunay_.has_own_corner(id); });
    }
  }

 private:
  /// The triangles with an own corner whose disks reach other ranks.
  [[nodiscard]] std::vector<TriangleId> all_at_border() const {
    const Array<Index> found = indices_where(threads_, delaunay_.triangulation().slots.size(), [&](std::size_t id) {
      return delaunay_.has_own_corner(static_cast<TriangleId>(id)) &&
             !ranks_to_ask(static_cast<TriangleId>(id)).empty();
    });
    return {found.begin(), found.end()};
  }

  [[nodiscard]] std::vector<int> ranks_to_ask(TriangleId id) const {
    const Triangulation& t = delaunay_.triangulation();
    const LocalDelaunay::Corners v = corners_of(t.slots[id]);
    const Point a = t.points[v[0]], b = t.points[v[1]];
    if (v[2] == ghost) return division_.others_in(HalfPlane{a, b}, ranks_.rank());
    const Disk disk = Disk::around(a, b, t.points[v[2]]);
    if (division_.certainly_owns(ranks_.rank(), disk)) return {};
    return division_.others_in(disk, ranks_.rank());
  }

  /// Returns the number of ranks that are asked.
  std::uint64_t ask_about(TriangleId id, std::vector<Questions>& questions) const {
    const std::vector<int> to_ask = ranks_to_ask(id);
    const LocalDelaunay::Corners corners = corners_of(delaunay_.triangulation().slots[id]);
    for (const int rank : to_ask) questions[rank].add(delaunay_, corners);
    return to_ask.size();
  }

  void exchange(const std::vector<Questions>& questions) {
    std::vector<Ranks::Bytes> messages, answers;
    for (const Questions& to_rank : questions) messages.push_back(to_rank.message());
    for (const Ranks::Bytes& message : ranks_.exchange(std::move(messages)))
      answers.push_back(answer(message, delaunay_));
    for (const Ranks::Bytes& message : ranks_.exchange(std::move(answers)))
      if (!message.empty())
        for (const Site& site : Reader(message).list<Site>()) delaunay_.vertex(site);
  }

  LocalDelaunay& delaunay_;
  const CurveDivision& division_;
  Ranks& ranks_;
  Threads threads_;
};

}  // namespace

std::vector<Site> common_sites(std::span<const Point> own, std::uint64_t first, std::uint64_t all, Ranks& ranks) {
  constexpr double sites_per_rank = 8, points_per_round = 16;
  std::size_t last_round = InsertionOrder::rounds - 1;
  for (double in_round = static_cast<double>(all); last_round > 0 && in_round > sites_per_rank * ranks.count();)
    in_round /= points_per_round, --last_round;
  std::vector<Site> known;
  for (const Index v : spanning_points(own)) known.push_back({own[v], first + v});
  for (std::size_t v = 0; v < own.size(); ++v)
    if (InsertionOrder::round_of(first + v) <= last_round) known.push_back({own[v], first + v});
  return concatenated(lists_of_all(known, ranks));
}

int resolve_halo(LocalDelaunay& delaunay, const CurveDivision& division, Ranks& ranks, const Threads& threads) {
  return Asker(delaunay, division, ranks, threads).run();
}

}  // namespace pardel::engine
