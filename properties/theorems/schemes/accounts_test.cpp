// What the schemes count, from what a run shows and from who owns what; and what a seed draws.
#include <map>
#include <set>

#include "../../../ref/schemes/decoupling.hpp"
#include "../../../ref/schemes/independent_cavities.hpp"
#include "../../../ref/schemes/kadow.hpp"
#include "../../../ref/schemes/lattice.hpp"
#include "../../../ref/schemes/load_balancing.hpp"
#include "../../../ref/schemes/rounds.hpp"
#include "../../../ref/schemes/speculative.hpp"
#include "../../../ref/schemes/workers/territory.hpp"
#include "../../domains/domains.hpp"
#include "some_problem.hpp"

namespace pardel::properties {
namespace {

using schemes::Account;
using schemes::Candidate;
using schemes::Chosen;
using schemes::Independence;
using schemes::LinkedMesh;
using schemes::Outcome;

/// The work and the messages of one phase.
class Counted {
 public:
  void work(int worker, std::uint64_t amount) { work_[worker] += amount; }
  void send(int from, int to) {
    if (from == to) return;
    pairs_.insert({from, to});
    ++triangles_;
  }
  /// Adds the phase to the sums.
  void add_to(Account& account) const {
    std::uint64_t longest = 0;
    for (const auto& [worker, amount] : work_) longest = std::max(longest, amount);
    account.critical += longest;
    account.messages += pairs_.size();
    account.bytes += triangles_ * schemes::bytes_of_triangle;
    ++account.barriers;
  }

 private:
  std::map<int, std::uint64_t> work_;
  std::set<std::pair<int, int>> pairs_;
  std::uint64_t triangles_ = 0;
};

/// The longest chain of candidates in the order of their priorities, each of which has a place in common with the next.
std::uint64_t longest_chain(const LinkedMesh& mesh, const std::vector<Candidate>& all, Independence when) {
  std::map<Index, std::uint64_t> chain_at;
  std::uint64_t longest = 0;
  for (const std::size_t k : schemes::by_priority(all)) {
    std::set<Index> places;
    for (const Index t : all[k].insertion.cavity.triangles)
      if (when == Independence::exact)
        places.insert(t);
      else
        places.insert(mesh.faces[t].v.begin(), mesh.faces[t].v.end());
    std::uint64_t chain = 0;
    for (const Index place : places) chain = std::max(chain, chain_at[place]);
    for (const Index place : places) chain_at[place] = chain + 1;
    longest = std::max(longest, chain + 1);
  }
  return longest;
}

PARDEL_PROPERTY(SchemeAccounts, of_rounds_are_those_of_the_owners_of_points,
                {.statement = "In rounds of independent cavities, the owner of a point reads the cavity, whose "
                              "triangles their owners send, and sends the new triangles to theirs. Workers wait for "
                              "each other after both, and once for each decision of the longest chain.",
                 .source = "ref/schemes/rounds/in_rounds.hpp",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const Independence when = *rc::gen::element(Independence::closures, Independence::exact);
  const schemes::Start start = some_start(c);
  const schemes::Territory territory(start.mesh, start.bounds, c.workers);
  Account expected = start.account;
  schemes::RoundRules rules = schemes::rules_of_independent_cavities(when);
  rules.watch = [&](const LinkedMesh& mesh, const std::vector<Candidate>& all, const Chosen& chosen) {
    Counted finding, inserting;
    for (const auto& [insertion, priority] : all) {
      const int owner = territory.owner(insertion.point);
      finding.work(owner, insertion.work() + insertion.cavity.triangles.size());
      for (const Index t : insertion.cavity.triangles) finding.send(territory.owner(mesh, t), owner);
    }
    LinkedMesh changed = mesh;
    for (const std::size_t k : chosen.candidates) {
      const schemes::Insertion& insertion = all[k].insertion;
      const int owner = territory.owner(insertion.point);
      inserting.work(owner, insertion.work());
      for (const Index t : schemes::carry_out(changed, insertion)) inserting.send(owner, territory.owner(changed, t));
    }
    finding.add_to(expected);
    inserting.add_to(expected);
    expected.barriers += longest_chain(mesh, all, when);
    ++expected.rounds;
  };
  const Outcome outcome = required(schemes::refine_in_rounds(c.problem(), rules));
  const Account& a = outcome.account;
  classify(a.messages > 0, "messages are sent", 40);
  RC_ASSERT(a.critical == expected.critical);
  RC_ASSERT(a.messages == expected.messages);
  RC_ASSERT(a.bytes == expected.bytes);
  RC_ASSERT(a.rounds == expected.rounds);
  RC_ASSERT(a.barriers == expected.barriers);
  std::map<int, std::uint64_t> owned;
  for (Index t = 0; t < outcome.mesh.faces.size(); ++t) ++owned[territory.owner(outcome.mesh, t)];
  const auto most = std::ranges::max_element(owned, {}, [](const auto& entry) { return entry.second; });
  RC_ASSERT(a.most_held == most->second);
}

/// Whom the worker of a cell sends a triangle to: the workers of touching cells in whose box it has a corner.
std::set<int> receivers(const schemes::cells::PhaseRecord& record, Index cell, Index t) {
  std::set<int> found;
  for (const Index other : record.division.touching(cell))
    for (const Index v : record.mesh.faces[t].v)
      if (record.division.in_box(other, record.mesh.points[v])) found.insert(record.division.worker[other]);
  return found;
}

/// The largest number of triangles with a corner in the box of a cell of one worker.
std::uint64_t most_in_boxes(const schemes::cells::Division& division, const LinkedMesh& mesh, int workers) {
  std::vector<std::uint64_t> held(static_cast<std::size_t>(workers), 0);
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    std::set<int> holders;
    for (Index cell = 0; mesh.in_use(t) && cell < division.worker.size(); ++cell)
      for (const Index v : mesh.faces[t].v)
        if (division.in_box(cell, mesh.points[v])) holders.insert(division.worker[cell]);
    for (const int worker : holders) ++held[static_cast<std::size_t>(worker)];
  }
  return *std::ranges::max_element(held);
}

PARDEL_PROPERTY(SchemeAccounts, of_cells_have_what_others_hold_and_what_is_handed_on,
                {.statement = "After a phase over a lattice, the worker of a cell sends each new triangle once to each "
                              "worker of a touching cell in whose box it has a corner, and all that it hands on. A "
                              "worker holds the triangles with a corner in the box of one of its cells.",
                 .source = "[CC], exchange after each phase; ref/schemes/cells/sweeps.hpp",
                 .families = scheme_families}) {
  SchemeCase c = some_scheme_case(exhibit);
  const auto [left, right] = std::ranges::minmax(c.pslg.points, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(c.pslg.points, {}, &Point::y);
  c.goal.max_area = std::min(c.goal.max_area, (right.x - left.x) * (high.y - low.y) / *rc::gen::inRange(50, 250));
  Account expected;
  std::uint64_t held = 0;
  bool is_outgrown = false;
  schemes::LatticeOptions options{.cells = *rc::gen::element(16, 40, 100)};
  options.assignment = *rc::gen::element(schemes::cells::Assignment::blocks, schemes::cells::Assignment::round_robin);
  options.watch = [&](const schemes::cells::PhaseRecord& record) {
    Counted sent;
    const std::vector<int>& worker = record.division.worker;
    const auto first_new = static_cast<Index>(record.mesh.points.size() - record.insertions);
    for (Index t = 0; t < record.mesh.faces.size(); ++t) {
      if (!record.mesh.in_use(t)) continue;
      // It was made with its newest corner, by the cell of this corner.
      const Index newest = *std::ranges::max_element(record.mesh.faces[t].v);
      if (newest < first_new) continue;
      const Index cell = record.division.cell_of(record.mesh.points[newest]);
      for (const int to : receivers(record, cell, t)) sent.send(worker[cell], to);
    }
    for (const auto& [from, to] : record.handed_on) sent.send(worker[from], worker[to]);
    sent.add_to(expected);
    is_outgrown = is_outgrown || record.ends_sweep;
    held = most_in_boxes(record.division, record.mesh, c.workers);
  };
  const Outcome outcome = required(schemes::lattice(c.problem(), options));
  classify(!is_outgrown && outcome.account.messages > 0, "messages are sent", 10);
  if (is_outgrown) return;  // two cells may have changed one triangle
  RC_ASSERT(outcome.account.messages == expected.messages);
  RC_ASSERT(outcome.account.bytes == expected.bytes);
  if (outcome.account.rounds > 0) RC_ASSERT(outcome.account.most_held == held);
}

/// The square with a bound on areas, on so many workers.
template <class Run>
std::size_t different_runs(int workers, const Run& run) {
  const Pslg square = domains::square();
  Goal goal;
  goal.max_area = 1e-3;
  std::vector<std::pair<std::vector<Point>, Account>> seen;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Result<Outcome> outcome = run(schemes::Problem{square, goal, workers, seed});
    std::pair<std::vector<Point>, Account> made{std::move(outcome->mesh.points), outcome->account};
    if (std::ranges::find(seen, made) == seen.end()) seen.push_back(std::move(made));
  }
  return seen.size();
}

PARDEL_FACT(SchemeAccounts, another_seed_is_another_run,
            {.statement = "Eight seeds give at least two different runs of each scheme that draws something: in the "
                          "order of insertions, or in what is counted.",
             .source = "ref/schemes/workers/problem.hpp",
             .families = "the unit square, areas up to 1e-3, 6 workers"}) {
  using P = const schemes::Problem&;
  const auto differ = [&](const char* what, const auto& run) {
    ++facts.cases;
    EXPECT_GT(different_runs(6, run), 1U) << what;
  };
  differ("independent cavities", [](P p) { return schemes::independent_cavities(p, Independence::exact); });
  differ("rounds", [](P p) { return schemes::rounds(p); });
  differ("speculative", [](P p) { return schemes::speculative(p, {.schedule = schemes::Schedule::random}); });
  differ("decoupling", [](P p) { return schemes::decoupling(p); });
  differ("lattice", [](P p) { return schemes::lattice(p, {.cells = 64}); });
  differ("load balancing", [](P p) { return schemes::load_balancing(p); });
  schemes::KadowOptions parts;
  parts.least_to_divide = 4;
  differ("kadow", [&parts](P p) { return schemes::kadow(p, parts); });
}

}  // namespace
}  // namespace pardel::properties
