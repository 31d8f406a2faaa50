#include "lone_rank.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "../../distributed/meshing/distribution.hpp"
#include "../../parallel/scheduling/phase.hpp"
#include "../tool.hpp"
#include "thread_time.hpp"

namespace pardel::bench {

using namespace engine;

namespace {

/// The view of one rank on others that send nothing.
class SilentRanks : public Ranks {
 public:
  SilentRanks(int rank, int count) : rank_(rank), count_(count) {}
  [[nodiscard]] int rank() const override { return rank_; }
  [[nodiscard]] int count() const override { return count_; }
  [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> /*messages*/) override {
    return std::vector<Bytes>(static_cast<std::size_t>(count_));
  }
  void add_up(std::span<std::uint64_t> /*values*/) override {}

 private:
  int rank_, count_;
};

}  // namespace

LoneRank measure_lone_rank(Triangulation t, const Tiles& tiles, std::span<const double> work, const Problem& problem,
                           int ranks) {
  const Schedule schedule;
  const Assessor assessor(t, problem.segments, problem.criteria, problem.options);
  SilentRanks silent(ranks / 2, ranks);
  Distribution distribution(silent, t);
  PhaseRunner runner(t, assessor, problem.criteria, problem.options, Threads(1), schedule, distribution);
  ThreadWatch watch;
  distribution.divide_by(tiles, work, runner);
  LoneRank measured{.divide_seconds = watch.lap()};

  SeedsByCell no_seeds(tiles.cells());
  constexpr int phases = 9;
  std::vector<double> seconds;
  for (int phase = 0; phase < phases; ++phase) {
    watch.lap();
    std::vector<PlannedTask> tasks =
        runner.plan(tiles, static_cast<unsigned>(phase) % tiles.colours(), Deferrals(), no_seeds);
    distribution.exchange_changes(tasks);
    seconds.push_back(watch.lap());
  }
  measured.phase_seconds = median(seconds);
  return measured;
}

MessageCosts measure_messages(const Triangulation& t) {
  struct Side {
    explicit Side(const Triangulation& all, int rank)
        : t(all),
          vertices(static_cast<Index>(t.points.size()), max_engine_triangles),
          triangles(static_cast<Index>(t.slots.size()), max_engine_triangles),
          part(t, vertices, triangles, Name::rank(rank), {vertices.end(), triangles.end()}) {}
    Triangulation t;
    IndexAllocator vertices, triangles;
    Subdomain part;
  };
  constexpr std::size_t most = 100'000;
  Side sender(t, 0), receiver(t, 1);
  std::vector<TriangleId> ids(std::min(t.slots.size(), most));
  std::iota(ids.begin(), ids.end(), TriangleId{0});
  std::vector<double> write, read;
  constexpr int rounds = 5;
  for (int round = 0; round < rounds; ++round) {
    ThreadWatch watch;
    Writer writer;
    sender.part.write(ids, {}, writer);
    const Ranks::Bytes message = writer.take();
    const auto bytes = static_cast<double>(message.size());
    write.push_back(watch.lap() / bytes);
    receiver.part.read({&message, 1});
    read.push_back(watch.lap() / bytes);
  }
  return {median(write), median(read)};
}

}  // namespace pardel::bench
