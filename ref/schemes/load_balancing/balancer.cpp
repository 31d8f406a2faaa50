#include "balancer.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "../workers/random.hpp"

namespace pardel::schemes {

Balancer::Balancer(const TileLattice& lattice, std::vector<int> owners, std::vector<std::uint64_t> sizes, int workers,
                   const BalancingRules& rules, Account& account, BalancingCounts& counts)
    : lattice_(lattice),
      rules_(rules),
      account_(account),
      counts_(counts),
      tiles_(owners.size()),
      workers_(at(workers)),
      reports_(at(workers)) {
  for (std::size_t k = 0; k < tiles_.size(); ++k) {
    tiles_[k].owner = owners[k];
    tiles_[k].size = sizes[k];
  }
  now_ = account.critical;
}

/// The broadcast that begins a phase names the tiles that run, and where all are.
bool Balancer::begin_phase() {
  bool any = false;
  now_ = account_.critical;
  ended_ = has_wave_before_ = false;
  busy_ = 0;
  for (Worker& worker : workers_) worker = {};
  for (Tile& tile : tiles_) tile.runs = !tile.items.empty();
  for (int k = 0; k < lattice_.count(); ++k) {
    Tile& tile = tiles_[at(k)];
    tile.awaited = 0;
    tile.known.clear();
    if (!tile.runs) continue;
    any = true;
    for (const int n : lattice_.neighbours(k)) {
      tile.known[n] = tiles_[at(n)].owner;
      if (tiles_[at(n)].runs && lattice_.colour(n) < lattice_.colour(k)) ++tile.awaited;
    }
    Worker& worker = workers_[at(tile.owner)];
    wait(worker, k);
    if (tile.awaited == 0) worker.ready.insert({lattice_.colour(k), k});
  }
  return any;
}

void Balancer::note(BalancingTrace::What what, int tile, int worker, int receiver) {
  if (trace_ != nullptr) trace_->events.push_back({what, now_, tile, worker, receiver});
}

void Balancer::wait(Worker& worker, int tile) {
  worker.waiting.insert({tiles_[at(tile)].items.size(), tile});
  worker.load += tiles_[at(tile)].items.size();
}

void Balancer::stop_waiting(Worker& worker, int tile) {
  worker.waiting.erase({tiles_[at(tile)].items.size(), tile});
  worker.load -= tiles_[at(tile)].items.size();
}

void Balancer::post(Event event, std::uint64_t delay) {
  event.time = now_ + delay;
  event.number = ++numbered_;
  events_.push_back(std::move(event));
  std::ranges::push_heap(events_, Later{});
}

void Balancer::send(Event event, std::uint64_t bytes) {
  ++account_.messages;
  account_.bytes += bytes;
  post(std::move(event), rules_.latency + random_number(rules_.seed + numbered_) % (rules_.latency + 1));
}

bool Balancer::run_phase(const Work& work, BalancingTrace* trace) {
  trace_ = trace;
  if (!begin_phase()) return false;
  const std::uint64_t begin = now_;
  for (int w = 0; w < static_cast<int>(workers_.size()); ++w) begin_run(w, work);
  join_wave(0);
  while (!ended_) {
    std::ranges::pop_heap(events_, Later{});
    Event event = std::move(events_.back());
    events_.pop_back();
    now_ = event.time;
    handle(std::move(event), work);
  }
  events_.clear();                                               // requests and answers without tiles
  now_ += rules_.latency * std::bit_width(workers_.size() - 1);  // the announcement
  counts_.idle += (now_ - begin) * workers_.size() - busy_;
  account_.critical = now_;
  ++account_.rounds;
  ++account_.barriers;
  return true;
}

void Balancer::handle(Event event, const Work& work) {
  const int w = event.to;
  switch (event.kind) {
    case Kind::end_of_run:
      end_run(w);
      break;
    case Kind::for_tile:
      receive_for_tile(std::move(event));
      break;
    case Kind::request:
      answer(w, event.from);
      break;
    case Kind::refusal: {
      Worker& me = workers_[at(w)];
      me.pause = std::min(std::max(2 * me.pause, rules_.latency + 1), longest_pause * (rules_.latency + 1));
      post({.kind = Kind::try_again, .from = w, .to = w}, me.pause);
      break;
    }
    case Kind::try_again:
      workers_[at(w)].asks = false;
      break;
    case Kind::tiles:
      take(event);
      break;
    case Kind::wave_down:
      join_wave(w);
      break;
    case Kind::wave_up:
      workers_[at(w)].sent_below += event.sent;
      workers_[at(w)].received_below += event.received;
      --workers_[at(w)].replies;
      break;
  }
  begin_run(w, work);
  reply(w);
}

/// Takes the next tile of the lowest colour that waits for nothing, or asks for one.
void Balancer::begin_run(int w, const Work& work) {
  Worker& me = workers_[at(w)];
  if (me.running >= 0) return;
  if (me.ready.empty()) return ask(w);
  const int k = me.ready.begin()->second;
  me.ready.erase(me.ready.begin());
  Tile& tile = tiles_[at(k)];
  stop_waiting(me, k);
  tile.runs = false;
  me.running = k;
  note(BalancingTrace::What::begun, k, w, w);
  reports_[at(w)] = work(k, std::exchange(tile.items, {}));
  post({.kind = Kind::end_of_run, .from = w, .to = w}, reports_[at(w)].work);
}

/// The neighbours of a higher colour learn that the tile has run; all get their new bad triangles.
void Balancer::end_run(int w) {
  Worker& me = workers_[at(w)];
  const int k = std::exchange(me.running, -1);
  TileReport report = std::exchange(reports_[at(w)], {});
  tiles_[at(k)].size += 2 * report.insertions;
  busy_ += report.work;
  account_.work += report.work;
  account_.wasted += report.wasted;
  note(BalancingTrace::What::ended, k, w, w);
  std::map<int, std::vector<KnownTriangle>> by_tile;
  for (const auto& [tile, item] : report.handed_on) by_tile[tile].push_back(item);
  for (const int n : lattice_.neighbours(k)) {
    const bool is_awaited = tiles_[at(n)].runs && lattice_.colour(n) > lattice_.colour(k);
    auto items = by_tile.find(n);
    if (!is_awaited && items == by_tile.end()) continue;
    Event event{.kind = Kind::for_tile, .from = w, .tile = n, .about = is_awaited ? k : -1};
    if (items != by_tile.end()) event.items = std::move(items->second);
    to_tile(w, tiles_[at(k)], std::move(event));
  }
}

/// Sends an event to a neighbour of a tile that worker w has, to the place where it went from here, or was last heard
/// of.
void Balancer::to_tile(int w, const Tile& sender, Event event) {
  const Tile& tile = tiles_[at(event.tile)];
  Worker& me = workers_[at(w)];
  if (tile.owner == w && !tile.in_flight) return deliver(event);
  const auto gone = me.gone_to.find(event.tile);
  event.to = gone != me.gone_to.end() ? gone->second : sender.known.at(event.tile);
  ++me.sent;
  ++counts_.sent;
  ++in_flight_;
  const std::uint64_t bytes = bytes_of_head + bytes_of_triangle * event.items.size();
  send(std::move(event), bytes);
}

void Balancer::receive_for_tile(Event event) {
  const int w = event.to;
  Tile& tile = tiles_[at(event.tile)];
  Worker& me = workers_[at(w)];
  if (tile.owner != w) {
    ++counts_.forwarded;
    event.to = me.gone_to.at(event.tile);
    const std::uint64_t bytes = bytes_of_head + bytes_of_triangle * event.items.size();
    return send(std::move(event), bytes);
  }
  if (tile.in_flight) {
    ++counts_.held;
    tile.early.push_back(std::move(event));
    return;
  }
  ++me.received;
  ++counts_.received;
  --in_flight_;
  deliver(event);
}

void Balancer::deliver(const Event& event) {
  Tile& tile = tiles_[at(event.tile)];
  Worker& me = workers_[at(tile.owner)];
  if (tile.runs) stop_waiting(me, event.tile);
  tile.items.insert(tile.items.end(), event.items.begin(), event.items.end());
  if (tile.runs) wait(me, event.tile);
  if (event.about < 0) return;
  tile.known[event.about] = event.from;
  if (--tile.awaited == 0) me.ready.insert({lattice_.colour(event.tile), event.tile});
}

}  // namespace pardel::schemes
