// How tiles move: who is asked, who gives tiles away, and what arrives.
#include <utility>

#include "../workers/random.hpp"
#include "balancer.hpp"

namespace pardel::schemes {

int Balancer::victim_of(int w) {
  const auto workers = static_cast<int>(workers_.size());
  Worker& me = workers_[at(w)];
  ++me.asked;
  switch (rules_.victim) {
    case Victim::random: {
      const std::uint64_t drawn =
          random_number(random_number(rules_.seed + static_cast<std::uint64_t>(w)) + counts_.requests);
      return (w + 1 + static_cast<int>(drawn % static_cast<std::uint64_t>(workers - 1))) % workers;
    }
    case Victim::neighbour: {
      const auto step = static_cast<int>((me.asked + 1) / 2 % static_cast<std::uint64_t>(workers));
      return (w + (me.asked % 2 == 1 ? step : workers - step)) % workers;
    }
    case Victim::most_loaded: {
      int most = w;
      for (int v = 0; v < workers; ++v)
        if (v != w && workers_[at(v)].load > (most == w ? 0 : workers_[at(most)].load)) most = v;
      return most;
    }
    case Victim::nobody:
      break;
  }
  return w;
}

void Balancer::ask(int w) {
  Worker& me = workers_[at(w)];
  if (rules_.victim == Victim::nobody || workers_.size() == 1 || me.asks) return;
  me.asks = true;
  const int victim = victim_of(w);
  if (victim == w) return post({.kind = Kind::try_again, .from = w, .to = w}, rules_.latency + 1);
  ++counts_.requests;
  send({.kind = Kind::request, .from = w, .to = victim}, bytes_of_head);
}

/// Barker et al.: the heaviest tiles that have not begun move. Only a worker that runs a tile gives others
/// away. If idle ones did, tiles that wait for their neighbours would go to and fro between them.
void Balancer::answer(int w, int asker) {
  Worker& me = workers_[at(w)];
  Event event{.kind = Kind::tiles, .from = w, .to = asker};
  std::uint64_t bytes = bytes_of_head;
  const std::size_t most = me.running < 0 ? 0 : static_cast<std::size_t>(rules_.tiles_moved);
  while (!me.waiting.empty() && event.moved.size() < most) {
    const int k = me.waiting.rbegin()->second;
    Tile& tile = tiles_[at(k)];
    stop_waiting(me, k);
    me.ready.erase({lattice_.colour(k), k});
    me.gone_to[k] = asker;
    tile.owner = asker;
    tile.in_flight = true;
    bytes += bytes_of_triangle * tile.size;
    event.moved.push_back(k);
    ++counts_.migrations;
    note(BalancingTrace::What::left, k, w, asker);
  }
  if (event.moved.empty()) {
    ++counts_.refusals;
    return send({.kind = Kind::refusal, .from = w, .to = asker}, bytes_of_head);
  }
  ++me.sent;
  ++counts_.sent;
  ++in_flight_;
  send(std::move(event), bytes);
}

void Balancer::take(const Event& event) {
  const int w = event.to;
  Worker& me = workers_[at(w)];
  me.asks = false;
  me.pause = 0;
  ++me.received;
  ++counts_.received;
  --in_flight_;
  for (const int k : event.moved) {
    Tile& tile = tiles_[at(k)];
    tile.in_flight = false;
    me.gone_to.erase(k);
    note(BalancingTrace::What::arrived, k, w, w);
    wait(me, k);
    if (tile.awaited == 0) me.ready.insert({lattice_.colour(k), k});
    for (Event& each : std::exchange(tile.early, {})) receive_for_tile(std::move(each));
  }
}

}  // namespace pardel::schemes
