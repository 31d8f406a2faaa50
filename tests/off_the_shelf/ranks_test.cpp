// Ranks that share the tasks of a sequential mesher make the mesh of one process.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <bit>
#include <optional>

#include "../../core/digest.hpp"
#include "../../distributed/mesh_with_mesher_in_ranks.hpp"
#include "../../off_the_shelf/schemes/refine_with_mesher.hpp"
#include "../../off_the_shelf/subdomains/share_attempts.hpp"
#include "../../parallel/scheduling/progress_monitor.hpp"
#include "../../properties/theorems/framework/local_ranks.hpp"
#include "bad_meshers.hpp"
#include "some_run.hpp"

namespace pardel::properties {
namespace {

/// What the ranks have made.
struct MadeInRanks {
  Digest digest;
  MesherReport mesher;  ///< of the first rank
  Report report;
};

MadeInRanks run_in_ranks(const Problem& problem, SubdomainMesher& mesher, const MesherOptions& how, int count) {
  const auto valid = validate(problem.pslg, {.convex_hull = problem.goal.convex_hull});
  RC_ASSERT(valid.ok());
  MadeInRanks made;
  on_ranks(count, [&](Ranks& ranks) {
    const Result<PieceWithMesher> result =
        mesh_with_mesher(*valid, problem.goal, mesher, how, {.threads = 1 + ranks.rank() % 2}, ranks);
    if (!result) throw Stopped{result.error()};
    const Digest whole = digest(result->piece, ranks);
    if (ranks.rank() == 0) made = {whole, result->mesher, result->piece.report};
  });
  return made;
}

/// Counts the calls of a mesher. Every answer to an odd number of triangles ends at a limit.
class CountingMesher final : public SubdomainMesher {
 public:
  CountingMesher(BreachKind mistake, unsigned every) : mesher_(mistake, every) {}
  [[nodiscard]] MesherAbilities abilities() const override { return mesher_.abilities(); }
  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    ++calls;
    RefinedSubdomain answer = mesher_.refine(subdomain);
    if (answer.ending == RefinedSubdomain::Ending::finished && subdomain.triangles.size() % 2 == 1)
      answer.ending = RefinedSubdomain::Ending::limit;
    return answer;
  }
  std::atomic<std::uint64_t> calls{0};

 private:
  BadMesher mesher_;
};

bool same_place(Point a, Point b) {  // that of a breach can be NaN
  return std::bit_cast<std::array<std::uint64_t, 2>>(a) == std::bit_cast<std::array<std::uint64_t, 2>>(b);
}

PARDEL_PROPERTY(OffTheShelf, ranks_make_the_mesh_of_one_process,
                {.statement = "On any number of ranks the mesh is that of one process, and so is the report on the "
                              "mesher, also with a mesher that breaks the contract now and then. One rank does each "
                              "task.",
                 .source = shelf_source,
                 .families = shelf_families}) {
  const Problem problem = some_fine_problem(exhibit);
  const MesherOptions how = small_tasks(some_scheme());
  const auto mistake = static_cast<BreachKind>(*rc::gen::inRange(0, breach_kinds));
  const unsigned every = *rc::gen::element(1U, 3U, 1'000'000U);
  const int count = *rc::gen::inRange(1, 6);
  RC_TAG(every > 3 ? "no breach" : "breaches", std::to_string(count) + " ranks");
  // The mistake other_answer depends on the number of calls, which the ranks share.
  RC_PRE(mistake != BreachKind::other_answer || every > 3);
  CountingMesher alone(mistake, every), shared(mistake, every);
  const MeshedWithMesher one = run(problem, alone, how);
  const MadeInRanks many = run_in_ranks(problem, shared, how, count);
  RC_ASSERT(digest(one.mesh) == many.digest);
  RC_ASSERT(alone.calls == shared.calls);
  const MesherReport &a = one.mesher, &b = many.mesher;
  RC_ASSERT(a.tasks == b.tasks);
  RC_ASSERT(a.sweeps == b.sweeps);
  RC_ASSERT(a.phases == b.phases);
  RC_ASSERT(a.prepared == b.prepared);
  RC_ASSERT(a.inserted == b.inserted);
  RC_ASSERT(a.completed == b.completed);
  RC_ASSERT(a.flipped == b.flipped);
  RC_ASSERT(a.at_limit == b.at_limit);
  RC_ASSERT(a.breaches.count == b.breaches.count);
  for (std::size_t kind = 0; kind < breach_kinds; ++kind) {
    RC_ASSERT(a.breaches.first[kind].kind == b.breaches.first[kind].kind);
    RC_ASSERT(same_place(a.breaches.first[kind].where, b.breaches.first[kind].where));
    RC_ASSERT(a.breaches.first[kind].what == b.breaches.first[kind].what);
  }
  RC_ASSERT(one.report.inserted == many.report.inserted);
}

/// Ranks that count how often they communicate.
class CountingRanks final : public Ranks {
 public:
  explicit CountingRanks(Ranks& ranks) : ranks_(ranks) {}
  [[nodiscard]] int rank() const override { return ranks_.rank(); }
  [[nodiscard]] int count() const override { return ranks_.count(); }
  [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override {
    ++exchanges;
    return ranks_.exchange(std::move(messages));
  }
  void add_up(std::span<std::uint64_t> values) override {
    ++sums;
    ranks_.add_up(values);
  }
  std::uint64_t exchanges = 0, sums = 0;

 private:
  Ranks& ranks_;
};

PARDEL_PROPERTY(OffTheShelf, ranks_exchange_once_per_phase,
                {.statement = "While the mesher refines, the ranks communicate once in each phase, and at no other "
                              "time.",
                 .source = "the paper, section 1: structured bulk communication; docs/off-the-shelf.md",
                 .families = shelf_families}) {
  const Problem problem = some_fine_problem(exhibit);
  const MesherOptions how = small_tasks(some_scheme());
  const auto valid = validate(problem.pslg, {.convex_hull = problem.goal.convex_hull});
  RC_ASSERT(valid.ok());
  std::optional<MesherReport> first;
  std::uint64_t exchanges = 0, sums = 0;
  on_ranks(*rc::gen::inRange(2, 5), [&](Ranks& local) {
    CountingRanks ranks(local);
    const Options options{.threads = 1};
    engine::ProgressMonitor progress(options);
    auto domain = engine::triangulate_domain(valid->pslg(), valid->convex_hull(), progress.threads());
    if (!domain) throw Stopped{domain.error()};
    const auto plan = engine::plan_run(valid->pslg(), problem.goal, *domain, options, progress.threads());
    if (!plan) throw Stopped{plan.error()};
    const auto mesher = own_mesher();
    MesherReport report;
    const Status done = engine::refine_with_mesher(
        *domain, valid->pslg(), *plan, {*mesher, mesher->abilities(), how, options, {}, &ranks}, progress, report);
    if (!done) throw Stopped{done.error()};
    if (ranks.rank() != 0) return;
    first = report;
    exchanges = ranks.exchanges;
    sums = ranks.sums;
  });
  RC_ASSERT(first.has_value());
  RC_ASSERT(exchanges == first->phases);
  RC_ASSERT(sums == 0U);
  RC_TAG(first->phases > 3 ? "four phases and more" : "fewer phases");
}

/// One of two ranks, whose neighbour sends a given message.
class Neighbour final : public Ranks {
 public:
  explicit Neighbour(Bytes message) : message_(std::move(message)) {}
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int count() const override { return 2; }
  [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override {
    sent = messages.at(1);
    return {messages.at(0), message_};
  }
  void add_up(std::span<std::uint64_t> /*values*/) override {}
  Bytes sent;

 private:
  Bytes message_;
};

engine::Attempt some_attempt() {
  engine::Attempt attempt;
  attempt.answer =
      engine::VerifiedSubdomain{{{0, 0}, {1, 0}, {0, 1}}, {}, {{0, 1, 2}}, {no_index, no_index, no_index}, {0, 1, 2}};
  attempt.breach = Breach{BreachKind::lost_edge, {1, 2}, "an edge is missing"};
  attempt.mesher_seconds = 0.5;
  return attempt;
}

TEST(ShareAttempts, refuses_every_message_that_is_cut_or_continued) {
  // Two ranks have the same task numbers: the message of rank 0 about task 0 is what rank 1 says about task 1.
  std::vector<engine::Attempt> attempts{some_attempt()};
  Neighbour alone({});
  engine::share_attempts(attempts, alone);
  const Ranks::Bytes whole = alone.sent;
  ASSERT_GT(whole.size(), 100U);
  const auto receive = [](Ranks::Bytes message) {
    std::vector<engine::Attempt> two(2);
    two[0] = some_attempt();
    Neighbour neighbour(std::move(message));
    engine::share_attempts(two, neighbour);
    return two[1];
  };
  const engine::Attempt received = receive(whole);
  ASSERT_TRUE(received.answer && received.breach);
  EXPECT_EQ(received.answer->triangles, some_attempt().answer->triangles);
  EXPECT_EQ(received.answer->on_edge, some_attempt().answer->on_edge);
  EXPECT_EQ(received.breach->what, "an edge is missing");
  EXPECT_EQ(received.mesher_seconds, 0.5);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW((void)receive({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}), Stopped) << size;
  Ranks::Bytes longer = whole;
  longer.push_back(std::byte{1});
  EXPECT_THROW((void)receive(longer), Stopped);
}

}  // namespace
}  // namespace pardel::properties
