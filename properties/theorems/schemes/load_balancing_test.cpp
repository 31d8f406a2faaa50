// Load balancing by tiles that migrate.
#include "../../../ref/schemes/load_balancing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "../../domains/domains.hpp"
#include "some_problem.hpp"

namespace pardel::properties {
namespace {

using schemes::Account;
using schemes::Balanced;
using schemes::BalancingTrace;
using schemes::Detection;
using schemes::LoadBalancingOptions;
using schemes::Placement;
using schemes::Victim;

constexpr const char* tiled_families =
    "lattice domains of every family without attributes, random goals up to 20.7 degrees, in half of them also small "
    "areas; 1 to 9 workers, 0 to 59 units of latency";
constexpr const char* balancing_paper = "Barker, Chernikov, Chrisochoides, Pingali 2004";

/// Any placement and any way in which tiles move. The lattice is that for nine workers.
LoadBalancingOptions some_balancing() {
  LoadBalancingOptions options;
  options.rules.victim = *rc::gen::element(Victim::nobody, Victim::random, Victim::neighbour, Victim::most_loaded);
  options.rules.tiles_moved = *rc::gen::inRange(1, 5);
  options.rules.latency = *rc::gen::inRange<std::uint64_t>(0, 60);
  options.placement = *rc::gen::element(Placement::territory, Placement::rows, Placement::one_worker);
  options.tiles_per_worker = 4;
  options.share_of_side = *rc::gen::element(0.125, 0.25, 0.5, 1.0);
  options.lattice_for_workers = 9;
  return options;
}

/// A random case. In half of them areas are small enough for many tiles to have work.
SchemeCase some_tiled_case(Exhibit& exhibit) {
  SchemeCase c = some_scheme_case(exhibit);
  const bool is_fine = *rc::gen::arbitrary<bool>();
  Point low = c.pslg.points[0], high = low;
  for (const Point p : c.pslg.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  if (is_fine) c.goal.max_area = std::min(c.goal.max_area, (high.x - low.x) * (high.y - low.y) / 250);
  return c;
}

Balanced some_balanced(const SchemeCase& c, const LoadBalancingOptions& options) {
  return required(schemes::load_balancing_with_counts(c.problem(), options));
}

PARDEL_PROPERTY(LoadBalancing, every_run_ends_with_a_certified_mesh,
                {.statement = "Wherever tiles begin and however they move, the run ends, and the checker certifies the "
                              "mesh.",
                 .source = balancing_paper,
                 .families = tiled_families}) {
  const SchemeCase c = some_tiled_case(exhibit);
  const Balanced balanced = some_balanced(c, some_balancing());
  classify(balanced.outcome.account.rounds > 0, "tiles run", 20);
  classify(balanced.counts.migrations > 0, "a tile moves", 10);
  certify(balanced.outcome.mesh, c, exhibit);
}

bool is_same_face(const schemes::Face& a, const schemes::Face& b) {
  return a.v == b.v && a.n == b.n && a.segment == b.segment && a.region == b.region;
}

/// Have the runs made the same bits with the same work?
bool are_one(const Balanced& a, const Balanced& b) {
  const schemes::LinkedMesh &one = a.outcome.mesh, &other = b.outcome.mesh;
  const Account &x = a.outcome.account, &y = b.outcome.account;
  return one.points == other.points && one.segment_of == other.segment_of &&
         std::ranges::equal(one.faces, other.faces, is_same_face) && x.insertions == y.insertions &&
         x.sequential == y.sequential && x.work == y.work && x.wasted == y.wasted && x.rounds == y.rounds;
}

PARDEL_PROPERTY(LoadBalancing, placement_changes_no_bit,
                {.statement = "The number of workers, the placement of tiles, the latency of messages, the choice of "
                              "victims and the seed change no bit of the mesh, and neither the work nor the phases.",
                 .source = "Chernikov, Chrisochoides 2004; Barker et al. 2004",
                 .families = tiled_families}) {
  SchemeCase c = some_tiled_case(exhibit);
  const LoadBalancingOptions options = some_balancing();
  LoadBalancingOptions others = some_balancing();
  others.share_of_side = options.share_of_side;
  const Balanced one = some_balanced(c, options);
  c.workers = *rc::gen::inRange(1, 10);
  c.seed += 1;
  const Balanced other = some_balanced(c, others);
  classify(one.counts.migrations != other.counts.migrations, "different migrations", 10);
  classify(one.outcome.account.rounds > 1, "several phases", 10);
  RC_ASSERT(are_one(one, other));
}

PARDEL_PROPERTY(LoadBalancing, a_tile_has_one_owner_and_runs_beside_no_neighbour,
                {.statement = "Every tile is at one worker or in flight to one. Only a worker that has it runs it, or "
                              "sends it away; no tile runs while a neighbour runs.",
                 .source = "Barker et al. 2004; Chernikov, Chrisochoides 2004",
                 .families = tiled_families}) {
  const SchemeCase c = some_tiled_case(exhibit);
  LoadBalancingOptions options = some_balancing();
  options.traces = true;
  const Balanced balanced = some_balanced(c, options);
  std::uint64_t moves = 0;
  for (const BalancingTrace& trace : balanced.traces) {
    std::vector<int> owner = trace.first_owners;
    std::vector<bool> in_flight(owner.size(), false), running(owner.size(), false);
    std::uint64_t now = 0;
    for (const BalancingTrace::Event& event : trace.events) {
      RC_ASSERT(event.time >= now && event.worker >= 0 && event.worker < c.workers);
      now = event.time;
      const auto tile = static_cast<std::size_t>(event.tile);
      const int x = event.tile % trace.per_side, y = event.tile / trace.per_side;
      RC_ASSERT(owner[tile] == event.worker);
      RC_ASSERT(in_flight[tile] == (event.what == BalancingTrace::What::arrived));
      RC_ASSERT(running[tile] == (event.what == BalancingTrace::What::ended));
      in_flight[tile] = event.what == BalancingTrace::What::left;
      running[tile] = event.what == BalancingTrace::What::begun;
      owner[tile] = event.receiver;
      if (event.what == BalancingTrace::What::left) ++moves;
      if (event.what != BalancingTrace::What::begun) continue;
      for (int other = 0; other < static_cast<int>(owner.size()); ++other)
        if (other != event.tile && std::abs(other % trace.per_side - x) <= 1 &&
            std::abs(other / trace.per_side - y) <= 1)
          RC_ASSERT(!running[static_cast<std::size_t>(other)]);
    }
    RC_ASSERT(std::ranges::count(in_flight, true) == 0 && std::ranges::count(running, true) == 0);
  }
  RC_ASSERT(moves == balanced.counts.migrations);
  classify(moves > 0, "a tile moves", 10);
}

PARDEL_PROPERTY(LoadBalancing, no_message_is_lost_and_the_end_is_true,
                {.statement = "Every message with tiles or for tiles is received. Two waves announce the end of a "
                              "phase once, when nothing is in flight and nobody has work. Messages, idle time and the "
                              "critical path are the sums of their parts.",
                 .source = "Mattern 1987; Barker et al. 2004",
                 .families = tiled_families}) {
  const SchemeCase c = some_tiled_case(exhibit);
  const LoadBalancingOptions options = some_balancing();
  const Balanced balanced = some_balanced(c, options);
  const schemes::BalancingCounts& n = balanced.counts;
  const Account& a = balanced.outcome.account;
  const auto workers = static_cast<std::uint64_t>(c.workers);
  classify(n.forwarded > 0, "a message follows a tile", 2);
  classify(n.sent > 0, "messages for tiles", 14);
  RC_ASSERT(n.sent == n.received);
  RC_ASSERT(n.false_ends == 0 && n.waves >= 2 * a.rounds);
  RC_ASSERT(a.barriers == a.rounds);
  RC_ASSERT(a.messages == n.requests + n.refusals + n.sent + n.forwarded + 2 * (workers - 1) * n.waves);
  RC_ASSERT(n.migrations == 0 || n.requests > n.refusals);
  RC_ASSERT(n.idle == workers * (a.critical - a.sequential) - a.work);
  RC_ASSERT(a.insertions == balanced.outcome.mesh.points.size() - c.pslg.points.size());
  RC_ASSERT(a.wasted <= a.work && a.set_backs == 0);
  RC_ASSERT(workers > 1 || a.messages == 0);
  // Two waves go down a binary tree and up again before the announcement.
  const auto depth = static_cast<std::uint64_t>(std::bit_width(workers) - 1);
  const auto announcement = static_cast<std::uint64_t>(std::bit_width(workers - 1));
  RC_ASSERT(a.critical - a.sequential >= a.rounds * options.rules.latency * (4 * depth + announcement));
}

/// The key, with short edges around the origin.
SchemeCase graded_key(double edge, int workers) {
  SchemeCase c;
  c.pslg = domains::key();
  c.goal.size = [edge](Point p) { return edge * (1 + 10 * std::sqrt(p.x * p.x + p.y * p.y)); };
  c.workers = workers;
  return c;
}

PARDEL_FACT(LoadBalancing, placement_changes_no_bit_of_a_graded_key,
            {.statement = "The same on a larger mesh, also where much is out of the reach of tiles.",
             .source = "Chernikov, Chrisochoides 2004; Barker et al. 2004",
             .families = "the key with edges that grow from one place, 2 to 16 workers"}) {
  for (const double share : {0.25, 1.0}) {
    LoadBalancingOptions options;
    options.lattice_for_workers = 16;
    options.share_of_side = share;
    const SchemeCase alone = graded_key(0.005, 1);
    const Balanced one = schemes::load_balancing_with_counts(alone.problem(), options).value();
    EXPECT_GE(one.outcome.account.rounds, 3U);
    for (const int workers : {2, 5, 16})
      for (const Placement placement : {Placement::territory, Placement::one_worker}) {
        const SchemeCase c = graded_key(0.005, workers);
        options.placement = placement;
        options.rules.victim = placement == Placement::territory ? Victim::nobody : Victim::random;
        EXPECT_TRUE(are_one(one, schemes::load_balancing_with_counts(c.problem(), options).value())) << workers;
        ++facts.cases;
      }
    facts.notes.push_back("Wasted work: " + std::to_string(one.outcome.account.wasted) + " of " +
                          std::to_string(one.outcome.account.work) + ".");
  }
}

PARDEL_FACT(
    LoadBalancing, idle_time_shrinks_on_a_graded_key,
    {.statement = "On a graded key whose tiles are placed row by row, workers idle less if idle ones ask others "
                  "for tiles, whomever they ask.",
     .source = balancing_paper,
     .families = "the key with edges that grow from one place, 2 to 16 workers"}) {
  for (const int workers : {2, 4, 8, 16}) {
    const SchemeCase c = graded_key(0.005, workers);
    LoadBalancingOptions options;
    options.placement = Placement::rows;
    options.lattice_for_workers = 16;
    options.rules.victim = Victim::nobody;
    const std::uint64_t without = schemes::load_balancing_with_counts(c.problem(), options)->counts.idle;
    for (const Victim victim : {Victim::random, Victim::neighbour, Victim::most_loaded}) {
      options.rules.victim = victim;
      const std::uint64_t with = schemes::load_balancing_with_counts(c.problem(), options)->counts.idle;
      EXPECT_LT(with, without) << workers;
      ++facts.cases;
      facts.notes.push_back(std::to_string(workers) + " workers, rule " + std::to_string(static_cast<int>(victim)) +
                            ": idle time " + std::to_string(with) + " instead of " + std::to_string(without) + ".");
    }
  }
}

PARDEL_FACT(LoadBalancing, one_wave_announces_the_end_too_early,
            {.statement = "A single wave that counts as many messages received as sent does not show the end: it is "
                          "announced while a worker has work or a message is in flight. Two waves are right there.",
             .source = "Mattern 1987",
             .families = "a small graded key, 2 to 16 workers, three latencies, three rules"}) {
  std::uint64_t false_ends = 0;
  for (int workers = 2; workers <= 16; ++workers)
    for (const std::uint64_t latency : {1U, 50U, 1000U})
      for (const Victim victim : {Victim::random, Victim::neighbour, Victim::most_loaded}) {
        const SchemeCase c = graded_key(0.02, workers);
        LoadBalancingOptions options;
        options.placement = Placement::one_worker;
        options.rules.latency = latency;
        options.rules.victim = victim;
        EXPECT_EQ(schemes::load_balancing_with_counts(c.problem(), options)->counts.false_ends, 0U);
        options.rules.detection = Detection::one_wave;
        false_ends += schemes::load_balancing_with_counts(c.problem(), options)->counts.false_ends;
        ++facts.cases;
      }
  EXPECT_GT(false_ends, 0U);
  facts.notes.push_back("One wave announced " + std::to_string(false_ends) + " ends too early.");
}

}  // namespace
}  // namespace pardel::properties
