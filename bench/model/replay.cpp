#include "replay.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "../../core/support/point_order.hpp"
#include "thread_time.hpp"

namespace pardel::bench {

using namespace engine;

namespace {

// The sizes of what travels (distributed/subdomain/subdomain.cpp, and distribution.cpp and vertex_data.cpp in
// distributed/meshing/). A test compares the bytes with those of real messages.
constexpr std::uint64_t bytes_of_list = 8, bytes_of_vertex = 32, bytes_of_triangle = 48, bytes_of_name = 8,
                        bytes_of_seed = 12, bytes_of_number = 8, bytes_of_answer = 8, bytes_of_rank = 4;

template <class T>
std::vector<T> without_repetitions(std::vector<T> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::uint64_t bytes_of_changes(const std::vector<TriangleId>& triangles, std::uint64_t dropped,
                               const Triangulation& t) {
  std::vector<VertexId> corners;
  for (const TriangleId id : triangles) corners.insert(corners.end(), t.slots[id].v.begin(), t.slots[id].v.end());
  const std::uint64_t vertices = without_repetitions(std::move(corners)).size();
  return 3 * bytes_of_list + bytes_of_vertex * vertices + bytes_of_triangle * triangles.size() +
         bytes_of_name * dropped;
}

}  // namespace

Replay::Replay(const Tiles& tiles, std::span<const double> work, int ranks)
    : ranks_(ranks), ownership_(tiles, work_of_tasks(tiles, work), ranks) {
  for (Index cell = 0; cell < tiles.cells(); ++cell) watchers_.push_back(ownership_.watchers_of_box(cell));
  add_exchange(Step::Kind::gaps, {}, {});
}

void Replay::add_exchange(Step::Kind kind, std::vector<double> work, const std::map<Pair, std::uint64_t>& bytes) {
  Step step{.kind = kind, .work = std::move(work)};
  if (!bytes.empty()) step.traffic.resize(static_cast<std::size_t>(ranks_));
  for (const auto& [pair, size] : bytes) {
    Traffic& out = step.traffic[static_cast<std::size_t>(pair.first)];
    Traffic& in = step.traffic[static_cast<std::size_t>(pair.second)];
    ++out.messages_out;
    out.bytes_out += size;
    ++in.messages_in;
    in.bytes_in += size;
  }
  steps_.push_back(std::move(step));
}

/// Every rank sends a message of `least` bytes to every other one, and to some of them `more`.
void Replay::add_exchange_of_all(std::uint64_t least, const std::map<Pair, std::uint64_t>& more) {
  add_exchange(Step::Kind::piece, {}, more);
  std::vector<Traffic>& traffic = steps_.back().traffic;
  traffic.resize(static_cast<std::size_t>(ranks_));
  const auto others = static_cast<std::uint32_t>(ranks_ - 1);
  for (Traffic& t : traffic) t = {others, others, t.bytes_out + least * others, t.bytes_in + least * others};
}

void Replay::sum(std::size_t values) {
  const bool is_over_cells = values == ownership_.cells() && values > 1;
  steps_.push_back(
      {.kind = is_over_cells ? Step::Kind::cell_sum : Step::Kind::sum, .bytes = sizeof(std::uint64_t) * values});
}

void Replay::deliver(const std::vector<PlannedTask>& tasks, const std::function<Index(QueuedTriangle)>& cell_with) {
  std::map<Pair, std::uint64_t> bytes;
  for (const PlannedTask& task : tasks)
    for (const QueuedTriangle seed : task.seeds) {
      const int from = ownership_.owner(cell_with(seed)), to = ownership_.owner(task.cell);
      if (from != to) bytes.try_emplace({from, to}, bytes_of_list).first->second += bytes_of_seed;
    }
  add_exchange(Step::Kind::seeds, {}, bytes);
}

void Replay::exchange_changes(const std::vector<PlannedTask>& tasks, std::span<const double> seconds,
                              const Triangulation& t, TriangleId common) {
  if (is_known_elsewhere_.size() < t.slots.size()) is_known_elsewhere_.resize(t.slots.size());
  std::vector<double> work(static_cast<std::size_t>(ranks_)), selection = work;
  std::map<Pair, Message> messages;
  std::vector<TriangleId> sent;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const int owner = ownership_.owner(tasks[i].cell);
    work[static_cast<std::size_t>(owner)] += seconds[i];
    const std::vector<int>& watchers = watchers_[tasks[i].cell];
    if (watchers.size() == 1) continue;
    std::vector<Message*> message_to;
    for (const int rank : watchers) message_to.push_back(rank == owner ? nullptr : &messages[{owner, rank}]);
    ThreadWatch watch;  // a real rank makes the same tests
    for (const TriangleId id : tasks[i].result.changed) {
      const auto& v = t.slots[id].v;
      for (std::size_t k = 0; k < watchers.size(); ++k) {
        if (message_to[k] == nullptr) continue;
        if (std::ranges::any_of(v,
                                [&](VertexId corner) { return ownership_.watches(watchers[k], t.points[corner]); })) {
          message_to[k]->triangles.push_back(id);
          sent.push_back(id);
        } else if (id < common || is_known_elsewhere_[id]) {
          ++message_to[k]->dropped;
        }
      }
    }
    selection[static_cast<std::size_t>(owner)] += watch.lap();
  }
  for (const TriangleId id : sent) is_known_elsewhere_[id] = true;
  std::map<Pair, std::uint64_t> bytes;
  for (const auto& [pair, message] : messages)
    if (!message.triangles.empty() || message.dropped > 0)
      bytes[pair] = bytes_of_changes(message.triangles, message.dropped, t);
  add_exchange(Step::Kind::changes, std::move(work), bytes);
  steps_.back().selection = std::move(selection);
}

/// The ranks that hold a triangle.
std::vector<int> Replay::holders(const Slot& slot, const Triangulation& t) const {
  std::vector<int> ranks;
  for (const VertexId v : slot.v) {
    const Point p = t.points[v];
    for (const int rank : watchers_[ownership_.cell_of(p)])
      if (ownership_.watches(rank, p)) ranks.push_back(rank);
  }
  return without_repetitions(std::move(ranks));
}

void Replay::finish(const Triangulation& t, const Subdomain& all, std::span<const Index> inserter) {
  std::vector<double> held(static_cast<std::size_t>(ranks_));  // triangles; a piece is selected among them
  std::vector<std::pair<VertexId, int>> in_piece_of_other;     // vertices, and the ranks that do not own them
  std::vector<std::pair<VertexId, int>> inserted_by_other;     // vertices, and the ranks that have not inserted them
  double count = 0;
  all.for_each_triangle([&](TriangleId id) {
    const Slot& slot = t.slots[id];
    ++count;
    std::array<Index, 3> cells{};
    std::ranges::transform(slot.v, cells.begin(), [&](VertexId v) { return ownership_.cell_of(t.points[v]); });
    if (std::ranges::all_of(cells, [&](Index cell) { return watchers_[cell].size() == 1; })) {
      ++held[static_cast<std::size_t>(ownership_.owner(cells[0]))];
      return;
    }
    for (const int rank : holders(slot, t)) ++held[static_cast<std::size_t>(rank)];
    const VertexId least = *std::ranges::min_element(
        slot.v, [&](VertexId a, VertexId b) { return lexicographically_less(t.points[a], t.points[b]); });
    const int owner = ownership_.owner(ownership_.cell_of(t.points[least]));
    for (unsigned i = 0; i < 3; ++i) {
      const VertexId v = slot.v[i];
      if (ownership_.owner(cells[i]) != owner) in_piece_of_other.emplace_back(v, owner);
      if (inserter[v] != no_index && ownership_.owner(inserter[v]) != owner) inserted_by_other.emplace_back(v, owner);
    }
  });
  held_ = static_cast<std::uint64_t>(std::accumulate(held.begin(), held.end(), 0.0));
  for (double& share : held) share /= count;
  in_piece_of_other = without_repetitions(std::move(in_piece_of_other));

  std::map<Pair, std::uint64_t> questions, answers;
  for (const auto& [v, rank] : without_repetitions(std::move(inserted_by_other))) {
    const int asked = ownership_.owner(inserter[v]);
    questions[{rank, asked}] += bytes_of_name;
    answers[{asked, rank}] += bytes_of_number;
  }
  for (auto next = in_piece_of_other.begin(); next != in_piece_of_other.end();) {
    const VertexId v = next->first;
    const auto last = std::find_if(next, in_piece_of_other.end(), [&](const auto& each) { return each.first != v; });
    // The pieces that contain the vertex: those of others, and that of its owner, which nearly always does.
    const auto pieces = static_cast<std::uint64_t>(last - next) + 1;
    const int owner = ownership_.owner(ownership_.cell_of(t.points[v]));
    for (; next != last; ++next) {
      questions[{next->second, owner}] += bytes_of_name;
      answers[{owner, next->second}] += bytes_of_answer + bytes_of_rank * pieces;
    }
  }
  // share_of_rank() of the vertices inserted by tasks, and in a submesh; questions and answers; then three sums in
  // PieceMaker and mesh_in_ranks().
  first_of_pieces_ = steps_.size();
  steps_.push_back({.kind = Step::Kind::rank_sum, .bytes = sizeof(std::uint64_t) * static_cast<std::uint64_t>(ranks_)});
  steps_.back().work = std::move(held);
  steps_.push_back({.kind = Step::Kind::rank_sum, .bytes = sizeof(std::uint64_t) * static_cast<std::uint64_t>(ranks_)});
  add_exchange_of_all(2 * bytes_of_list, questions);
  add_exchange_of_all(3 * bytes_of_list, answers);
  steps_.push_back({.kind = Step::Kind::rank_sum, .bytes = sizeof(std::uint64_t) * static_cast<std::uint64_t>(ranks_)});
  steps_.push_back({.kind = Step::Kind::sum, .bytes = sizeof(std::uint64_t)});
  steps_.push_back({.kind = Step::Kind::sum, .bytes = sizeof(std::uint64_t)});
}

void Replay::set_piece_seconds(double seconds) {
  for (double& share : steps_[first_of_pieces_].work) share *= seconds;
}

}  // namespace pardel::bench
