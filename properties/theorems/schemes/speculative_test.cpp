// Speculative insertion with set-backs.
#include "../../../ref/schemes/speculative.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <map>

#include "some_problem.hpp"

namespace pardel::properties {
namespace {

using schemes::Account;
using schemes::LinkedMesh;
using schemes::Locked;
using schemes::Precedence;
using schemes::Schedule;
using schemes::Speculation;
using schemes::SpeculativeOptions;

/// Any schedule, and a rule that says who gives up.
SpeculativeOptions some_speculative_options() {
  return {.schedule = *rc::gen::element(Schedule::round_robin, Schedule::random, Schedule::adversary),
          .precedence = *rc::gen::element(Precedence::lower_worker, Precedence::older_insertion)};
}

Speculation some_speculation(const SchemeCase& c) {
  return {some_start(c), c.problem(), some_speculative_options().precedence, Locked::cavity_and_ring};
}

/// A worker that is not idle, drawn at random.
int some_worker(const Speculation& run, const SchemeCase& c, generators::Random& random) {
  std::vector<int> busy;
  for (int w = 0; w < c.workers; ++w)
    if (!run.is_idle(w)) busy.push_back(w);
  return random.one_of(busy);
}

bool is_unchanged(const schemes::Face& a, const schemes::Face& b) {
  return a.v == b.v && a.n == b.n && a.segment == b.segment && a.region == b.region;
}

std::vector<int> all_holders(const Speculation& run) {
  std::vector<int> all;
  for (Index t = 0; t < run.mesh().faces.size(); ++t) all.push_back(run.holder(t));
  return all;
}

/// Ruppert's algorithm with a queue of bad triangles. A place in the queue is of a bad triangle only, so the order is
/// not that of refine_sequentially().
LinkedMesh refined_from_a_queue(schemes::Start start) {
  LinkedMesh& mesh = start.mesh;
  std::deque<Index> bad;
  const auto add_if_bad = [&](Index t) {
    if (schemes::needs_work(mesh, t, start.bounds)) bad.push_back(t);
  };
  for (Index t = 0; t < mesh.faces.size(); ++t) add_if_bad(t);
  while (!bad.empty()) {
    const Index t = bad.front();
    bad.pop_front();
    if (!mesh.in_use(t)) continue;
    const auto insertion = schemes::insertion_for(mesh, t, start.bounds);
    if (!insertion) continue;
    std::ranges::for_each(schemes::carry_out(mesh, *insertion), add_if_bad);
    if (!insertion->cavity.contains(t)) bad.push_back(t);
  }
  schemes::compact(mesh);
  return std::move(start.mesh);
}

PARDEL_PROPERTY(Speculative, every_schedule_ends_with_a_certified_mesh,
                {.statement = "With a rule that says who gives up, every schedule ends, and the checker certifies the "
                              "mesh.",
                 .source = "Nave, Chrisochoides, Chew 2002; Chrisochoides, Nave 2003",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const SpeculativeOptions options = some_speculative_options();
  const schemes::Outcome outcome = required(schemes::speculative(c.problem(), options));
  classify(outcome.account.set_backs > 0, "an insertion is set back", 20);
  classify(options.schedule == Schedule::adversary, "an adversary", 20);
  certify(outcome.mesh, c, exhibit);
}

PARDEL_PROPERTY(Speculative, one_worker_runs_ruppert_s_algorithm,
                {.statement = "One worker makes the mesh of Ruppert's algorithm with a queue of bad triangles, bit for "
                              "bit, and has no set-back and no message; its critical path is its work.",
                 .source = "Ruppert 1995; Nave, Chrisochoides, Chew 2002",
                 .families = scheme_families}) {
  SchemeCase c = some_scheme_case(exhibit);
  c.workers = 1;
  const schemes::Outcome outcome = required(schemes::speculative(c.problem(), some_speculative_options()));
  const LinkedMesh expected = refined_from_a_queue(some_start(c));
  classify(outcome.account.insertions > 0, "something is inserted", 50);
  RC_ASSERT(outcome.mesh.points == expected.points);
  RC_ASSERT(std::ranges::equal(outcome.mesh.faces, expected.faces, is_unchanged));
  const Account& account = outcome.account;
  RC_ASSERT(account.set_backs == 0 && account.messages == 0 && account.bytes == 0);
  RC_ASSERT(account.critical == account.sequential + account.work);
  RC_ASSERT(account.most_held == outcome.mesh.faces.size());
}

PARDEL_PROPERTY(
    Speculative, a_set_back_leaves_nothing_behind,
    {.statement =
         "An insertion that is set back leaves the mesh and the locks of all others as they were, "
         "keeps no lock, and is tried again. None is that writes. Without another worker in the way no insertion is "
         "set back.",
     .source = "Nave, Chrisochoides, Chew 2002 (rollback)",
     .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  Speculation run = some_speculation(c);
  bool met = false, taken_away = false;
  for (generators::Random random(c.seed); !run.is_over();) {
    const int w = some_worker(run, c, random);
    const int loser = run.would_set_back(w);
    const std::uint64_t set_backs = run.account().set_backs;
    if (loser == schemes::no_worker) {
      run.step(w);
      RC_ASSERT(run.account().set_backs == set_backs);
      continue;
    }
    (loser == w ? met : taken_away) = true;
    const LinkedMesh before = run.mesh();
    const std::vector<int> held = all_holders(run);
    RC_ASSERT(!run.will_change_the_mesh(loser));
    run.step(w);
    RC_ASSERT(run.account().set_backs == set_backs + 1);
    RC_ASSERT(run.held(loser).empty() && !run.is_idle(loser));
    RC_ASSERT(run.mesh().points == before.points);
    RC_ASSERT(std::ranges::equal(run.mesh().faces, before.faces, is_unchanged));
    for (Index t = 0; t < held.size(); ++t)
      if (held[t] != w && held[t] != loser) RC_ASSERT(run.holder(t) == held[t]);
  }
  classify(met, "a worker gives up", 20);
  classify(taken_away, "a lock is taken away", 20);
}

PARDEL_PROPERTY(Speculative, only_locked_triangles_change,
                {.statement = "Every triangle that a worker's step changes, corners or neighbours, was locked by this "
                              "worker; every lock is held by the worker that lists it, once.",
                 .source = "Nave, Chrisochoides, Chew 2002; Chrisochoides, Nave 2003",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  Speculation run = some_speculation(c);
  bool together = false;
  for (generators::Random random(c.seed); !run.is_over();) {
    const int w = some_worker(run, c, random);
    const std::size_t points = run.points();
    if (!run.will_change_the_mesh(w)) {
      run.step(w);
      RC_ASSERT(run.points() == points);
      continue;
    }
    const std::vector<int> before = all_holders(run);
    const std::vector<schemes::Face> faces = run.mesh().faces;
    run.step(w);
    RC_ASSERT(run.points() == points + 1);
    std::size_t locks = 0;
    for (int v = 0; v < c.workers; ++v) {
      locks += run.held(v).size();
      together = together || (v != w && !run.held(v).empty());
      for (const Index t : run.held(v)) RC_ASSERT(run.holder(t) == v);
    }
    RC_ASSERT(std::ranges::count_if(before, [&](int v) { return v != schemes::no_worker && v != w; }) ==
              static_cast<std::ptrdiff_t>(locks));
    for (Index t = 0; t < faces.size(); ++t)
      if (!is_unchanged(faces[t], run.mesh().faces[t])) RC_ASSERT(before[t] == w);
  }
  classify(together, "others hold locks meanwhile", 20);
}

PARDEL_PROPERTY(Speculative, the_account_follows_from_what_was_done,
                {.statement = "Insertions, work and messages are those of the steps: a step is a unit of work, a lock "
                              "on a triangle of others costs a request, an answer and a release, a lock taken away and "
                              "a bad triangle of others one message each. Without set-backs, waste is the search of "
                              "circumcentres that encroach. No critical path is shorter than the work of all divided "
                              "among all.",
                 .source = "Nave, Chrisochoides, Chew 2002",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  Speculation run = some_speculation(c);
  const schemes::Start start = some_start(c);
  const schemes::Territory territory(start.mesh, start.bounds, c.workers);
  std::uint64_t steps = 0, ends_with_changes = 0;
  std::vector<std::uint64_t> of_worker(static_cast<std::size_t>(c.workers), 0);
  for (generators::Random random(c.seed); !run.is_over(); ++steps) {
    const int w = some_worker(run, c, random);
    ++of_worker[static_cast<std::size_t>(w)];
    const bool changes = run.will_change_the_mesh(w);
    const std::uint64_t ends = run.counts().remote_ends;
    run.step(w);
    if (changes) ends_with_changes += run.counts().remote_ends - ends;
  }
  const schemes::SpeculativeCounts counts = run.counts();
  const schemes::Outcome outcome = std::move(run).outcome();
  const Account& a = outcome.account;
  classify(counts.late > 0, "an encroachment is found late", 20);
  classify(a.set_backs > 0, "an insertion is set back", 20);
  RC_ASSERT(a.insertions == outcome.mesh.points.size() - c.pslg.points.size());
  RC_ASSERT(counts.steps == steps && a.work == steps && a.wasted <= a.work);
  RC_ASSERT(a.set_backs > 0 || (counts.late > 0) == (a.wasted > 0));
  RC_ASSERT(a.wasted >= a.set_backs + 2 * counts.late);
  RC_ASSERT(a.messages == 2 * counts.remote_asks + counts.remote_ends + counts.taken_away + counts.handed_on);
  // A request has 8 bytes. A triangle comes with an answer, goes back if it was changed, and is handed on if it is bad.
  RC_ASSERT(a.bytes == 8 * (counts.remote_asks + counts.taken_away + counts.remote_ends - ends_with_changes) +
                           schemes::bytes_of_triangle * (counts.remote_asks + counts.handed_on + ends_with_changes));
  RC_ASSERT(a.most_held == schemes::most_owned(outcome.mesh, territory));
  classify(counts.handed_on > 0, "a bad triangle is handed on", 10);
  RC_ASSERT(counts.remote_ends <= counts.remote_asks && counts.taken_away <= a.set_backs);
  RC_ASSERT(a.before == a.sequential && a.barriers == 0);
  RC_ASSERT(a.critical >= a.before + *std::ranges::max_element(of_worker));
  RC_ASSERT(a.critical <= a.sequential + a.work);
}

PARDEL_PROPERTY(Speculative, a_lock_is_taken_after_its_release,
                {.statement = "The clock of a worker that takes a lock is beyond the clock of the worker that had it "
                              "before at its release. Clocks never go back; the critical path ends with the last.",
                 .source = "ref/schemes/speculative/worker.hpp",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  Speculation run = some_speculation(c);
  std::map<Index, std::uint64_t> released;
  bool waits = false;
  std::uint64_t last = run.account().critical;
  for (generators::Random random(c.seed); !run.is_over();) {
    const int w = some_worker(run, c, random);
    const std::vector<int> before = all_holders(run);
    const std::uint64_t clock = run.clock(w);
    run.step(w);
    RC_ASSERT(run.clock(w) > clock);
    last = std::max(last, run.clock(w));
    for (Index t = 0; t < run.mesh().faces.size(); ++t) {
      const int now = run.holder(t), then = t < before.size() ? before[t] : schemes::no_worker;
      if (now == then) continue;
      if (now == schemes::no_worker) {
        released[t] = run.clock(then);
        continue;
      }
      RC_ASSERT(run.clock(now) > released[t]);
      waits = waits || released[t] > clock;
    }
  }
  classify(waits, "a worker waits for a lock", 10);
  RC_ASSERT(std::move(run).outcome().account.critical == last);
}

/// A square with a bound on areas.
SchemeCase bounded_square(double max_area, int workers) {
  SchemeCase c;
  c.pslg.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  c.goal.max_area = max_area;
  c.workers = workers;
  return c;
}

PARDEL_FACT(Speculative, without_precedence_a_schedule_never_ends,
            {.statement = "If whoever meets a lock gives up, and nothing decides who goes first, there is a schedule "
                          "in which workers set each other back for ever, although each has its turn again and again. "
                          "Both rules of precedence end under the same adversary.",
             .source = "Nave, Chrisochoides, Chew 2002 (livelock)",
             .families = "a square with a bound on areas, two workers, 1,000,000 steps"}) {
  const SchemeCase c = bounded_square(0.5, 2);
  SpeculativeOptions options{.schedule = Schedule::adversary, .precedence = Precedence::nobody};
  options.most_steps = 1'000'000;
  const auto endless = schemes::speculative(c.problem(), options);
  ASSERT_FALSE(endless);
  EXPECT_EQ(endless.error().kind, ErrorKind::resources);
  for (const Precedence rule : {Precedence::lower_worker, Precedence::older_insertion}) {
    options.precedence = rule;
    options.most_steps = 10'000;
    EXPECT_TRUE(schemes::speculative(c.problem(), options));
  }
  facts.cases = 3;
}

PARDEL_FACT(Speculative, locks_on_the_cavity_alone_do_not_keep_the_mesh_delaunay,
            {.statement = "If insertions lock their cavities but not the triangles around them, two whose cavities "
                          "touch both end, and the mesh is not Delaunay; with the ring, the same run ends certified.",
             .source = "Nave, Chrisochoides, Chew 2002; properties/THEORY.md, T1-iff",
             .families = "a square with a bound on areas, four workers, one after the other"}) {
  const SchemeCase c = bounded_square(2, 4);
  for (const Locked locked : {Locked::cavity, Locked::cavity_and_ring}) {
    const auto outcome = schemes::speculative(c.problem(), {.locked = locked});
    ASSERT_TRUE(outcome);
    EXPECT_EQ(check(c.pslg, schemes::to_mesh(outcome->mesh, c.pslg), c.goal).valid, locked == Locked::cavity_and_ring);
    ++facts.cases;
  }
}

}  // namespace
}  // namespace pardel::properties
