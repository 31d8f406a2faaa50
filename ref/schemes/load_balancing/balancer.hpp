// Workers that exchange tiles, in virtual time: events, messages that take time, and the detection of the end.
//
// Sources: K. Barker, A. Chernikov, N. Chrisochoides, K. Pingali, "A load balancing framework for adaptive and
// asynchronous applications", IEEE TPDS 15(2), 2004 (mobile objects, messages to them, work
// stealing); F. Mattern, "Algorithms for distributed termination detection", Distributed Computing 2, 1987
// (four counters in two waves).
#pragma once

#include <functional>
#include <map>
#include <set>

#include "../workers/account.hpp"
#include "tiles.hpp"

namespace pardel::schemes {

/// Whom an idle worker asks for tiles.
enum class Victim : std::uint8_t {
  nobody,      ///< tiles stay where they are
  random,      ///< any other worker
  neighbour,   ///< the workers with the next numbers, above and below in turn
  most_loaded  ///< the one whose tiles have the most items, as a directory without delay would say
};

/// When the end of a phase is announced.
enum class Detection : std::uint8_t {
  two_waves,  ///< if as many messages were received before one wave as were sent before the next one
  one_wave    ///< too early: if one wave counts as many messages received as sent
};

struct BalancingRules {
  Victim victim = Victim::random;
  int tiles_moved = 1;         ///< at most so many tiles move for one request
  std::uint64_t latency = 50;  ///< a message takes this time to twice this time, so messages overtake each other
  Detection detection = Detection::two_waves;
  std::uint64_t seed = 1;
};

struct BalancingCounts {
  std::uint64_t requests = 0;    ///< of idle workers
  std::uint64_t refusals = 0;    ///< by workers that had no tile to spare
  std::uint64_t migrations = 0;  ///< of tiles
  std::uint64_t forwarded = 0;   ///< messages that found their tile gone
  std::uint64_t held = 0;        ///< messages that arrived before their tile
  std::uint64_t sent = 0;        ///< messages with tiles, or for tiles
  std::uint64_t received = 0;
  std::uint64_t waves = 0;
  std::uint64_t false_ends = 0;  ///< announced although a message was in flight or a worker had work
  std::uint64_t idle = 0;        ///< time in phases in which a worker did nothing, of all workers
  friend bool operator==(const BalancingCounts&, const BalancingCounts&) = default;
};

/// What happened to the tiles of one level, in the order of time.
struct BalancingTrace {
  enum class What : std::uint8_t { left, arrived, begun, ended };
  struct Event {
    What what;
    std::uint64_t time;
    int tile;
    int worker;    ///< that has the tile before and after this, or that sent or received it
    int receiver;  ///< of a tile that left; else the same worker
  };
  int per_side = 0;               ///< of the lattice
  std::vector<int> first_owners;  ///< of each tile
  std::vector<Event> events;
};

/// The phases of one level. A tile runs in a phase if it has items when the phase begins; before that it hears from all
/// neighbours of a lower colour that run in the phase. So the order in which neighbours run is known beforehand.
class Balancer {
 public:
  /// Does the work of a tile. The items for other tiles are delivered by the balancer.
  using Work = std::function<TileReport(int tile, std::vector<KnownTriangle> items)>;

  /// `owners`: the worker of each tile. `sizes`: triangles of each tile. The counts and the account are added to.
  Balancer(const TileLattice& lattice, std::vector<int> owners, std::vector<std::uint64_t> sizes, int workers,
           const BalancingRules& rules, Account& account, BalancingCounts& counts);

  /// A bad triangle of a tile, before the phase.
  void add(int tile, const KnownTriangle& item) { tiles_[at(tile)].items.push_back(item); }
  /// Runs one phase. Returns whether any tile had items. Adds what happened to the trace if there is one.
  bool run_phase(const Work& work, BalancingTrace* trace = nullptr);
  /// The worker that has the tile. A tile in flight belongs to its receiver.
  [[nodiscard]] int owner(int tile) const { return tiles_[at(tile)].owner; }

 private:
  enum class Kind : std::uint8_t { end_of_run, for_tile, request, refusal, tiles, try_again, wave_down, wave_up };
  struct Event {
    std::uint64_t time = 0, number = 0;
    Kind kind{};
    int from = 0, to = 0;                ///< workers
    int tile = -1, about = -1;           ///< for_tile: the receiver, and the neighbour that has run (-1 if not awaited)
    std::vector<KnownTriangle> items{};  ///< for_tile
    std::vector<int> moved{};            ///< tiles
    std::uint64_t sent = 0, received = 0;  ///< wave_up
  };
  struct Later {
    bool operator()(const Event& a, const Event& b) const {
      return std::pair(a.time, a.number) > std::pair(b.time, b.number);
    }
  };
  struct Tile {
    int owner = 0;
    bool in_flight = false, runs = false;  ///< runs: in this phase, and has not begun
    int awaited = 0;
    std::uint64_t size = 0;
    std::vector<KnownTriangle> items;
    std::map<int, int> known;  ///< where neighbours were last heard of
    std::vector<Event> early;  ///< messages that arrived before it
  };
  struct Worker {
    int running = -1;
    std::set<std::pair<int, int>> ready;            ///< colour and number
    std::set<std::pair<std::size_t, int>> waiting;  ///< items and number of tiles that have not begun
    std::size_t load = 0;                           ///< items of these tiles
    std::map<int, int> gone_to;                     ///< forwarding addresses
    std::uint64_t sent = 0, received = 0, pause = 0, asked = 0;
    bool asks = false, in_wave = false;
    int replies = 0;                                   ///< of a wave that are missing
    std::uint64_t sent_below = 0, received_below = 0;  ///< of the workers that have replied
  };

  /// Of a request, a refusal, a wave, and the head of any other message.
  static constexpr std::uint64_t bytes_of_head = 16;
  /// The pause after a refusal doubles up to this many latencies.
  static constexpr std::uint64_t longest_pause = 64;

  [[nodiscard]] static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  [[nodiscard]] bool begin_phase();
  void send(Event event, std::uint64_t bytes);
  void post(Event event, std::uint64_t delay);
  void handle(Event event, const Work& work);
  void wait(Worker& worker, int tile);
  void stop_waiting(Worker& worker, int tile);
  void to_tile(int w, const Tile& sender, Event event);
  void receive_for_tile(Event event);
  void deliver(const Event& event);
  void end_run(int w);
  void begin_run(int w, const Work& work);
  void ask(int w);
  [[nodiscard]] int victim_of(int w);
  void answer(int w, int asker);
  void note(BalancingTrace::What what, int tile, int worker, int receiver);
  void take(const Event& event);
  void join_wave(int w);
  void reply(int w);
  void judge();
  [[nodiscard]] bool has_ended() const;

  const TileLattice& lattice_;
  BalancingRules rules_;
  Account& account_;
  BalancingCounts& counts_;
  std::vector<Tile> tiles_;
  std::vector<Worker> workers_;
  std::vector<TileReport> reports_;  ///< of the tile that each worker runs
  std::vector<Event> events_;        ///< a heap; the next one is on top
  std::uint64_t now_ = 0, numbered_ = 0, in_flight_ = 0, received_before_ = 0, busy_ = 0;
  BalancingTrace* trace_ = nullptr;
  bool ended_ = false, has_wave_before_ = false;
};

}  // namespace pardel::schemes
