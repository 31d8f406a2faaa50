// rank_scaling: compares the ranks of an MPI job with the threads of one process, in one job. To be started by mpirun.
// Round by round, all R ranks make one mesh with one thread each, then the first rank makes it with R threads while the
// others sleep, then each rank makes a mesh of 1/R of the triangles for itself. Prints medians of the times, and of the
// ratios in a round, with intervals. See --help.
#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "../core/digest.hpp"
#include "../core/support/stopwatch.hpp"
#include "../distributed/distributed.hpp"
#include "../mpi/mpi_ranks.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/domains/dealt_domain.hpp"
#include "mpi_program.hpp"
#include "own_processor.hpp"
#include "sign_interval.hpp"
#include "tool.hpp"
#include "warm_memory.hpp"

namespace pardel::bench {
namespace {

struct Settings {
  Task task{.domain = "pipe", .goal = {}, .triangles = 10'000'000};
  std::uint64_t per_rank = 0;  ///< if not 0: this number of triangles for each rank
  int runs = 5;
  double rest = 1.5;   ///< seconds without work before each measured run
  bool parts = false;  ///< each rank begins with a part of the domain
};

/// Waits for all ranks without using the processor.
void wait_for_all() {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  for (int done = 0; done == 0;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done == 0) usleep(200);
  }
}

/// Starts the work on all ranks at the same time, and waits for all of them.
template <class Work>
void together(const Work& work) {
  wait_for_all();
  work();
  wait_for_all();
}

class Comparison {
 public:
  explicit Comparison(const Settings& settings)
      : settings_(settings), domain_(std::move(validate(make_domain(settings.task))).value()) {
    if (settings.per_rank > 0)
      settings_.task.triangles = settings.per_rank * static_cast<std::uint64_t>(ranks_.count());
  }

  int run() {
    const auto on_own_processors = [&](const auto& work) {
      together([&] {
        const OwnProcessor own(ranks_.rank(), ranks_.count());
        work();
      });
    };
    for (int round = 0; round < settings_.runs; ++round) {
      on_own_processors([&] { make_piece(); });
      together([&] {
        if (ranks_.rank() == 0) make_whole(1, ranks_.count(), whole_seconds_);
      });
      on_own_processors([&] { make_whole(ranks_.count(), 1, part_seconds_); });
    }
    print();
    return is_same_ ? 0 : 1;
  }

 private:
  /// The goal for a mesh of the task's triangles, divided by `parts`.
  [[nodiscard]] Goal goal(int parts) const {
    Task task = settings_.task;
    task.triangles /= static_cast<std::uint64_t>(parts);
    set_size(task);
    return task.goal;
  }
  /// Makes the memory for such a mesh available (warm_memory.hpp). A process of an MPI job cannot do it in a child. A
  /// run takes about 50 bytes per triangle, but the system need not give it the memory that was freed last.
  void warm(int parts) const {
    constexpr std::uint64_t bytes_per_triangle = 150;
    (void)workloads::touch_memory(bytes_per_triangle * settings_.task.triangles / static_cast<std::uint64_t>(parts));
  }

  /// A host may let a virtual machine run faster for some seconds after it has rested. Without a rest before each run,
  /// ranks began after work on all processors, and threads after work on one.
  void rest() const { usleep(static_cast<useconds_t>(1e6 * settings_.rest)); }

  void make_piece() {
    rest();
    warm(ranks_.count());
    wait_for_all();
    const Stopwatch watch;
    const Options options{.threads = 1};
    const Result<MeshPiece> piece = settings_.parts
                                        ? mesh(domains::equal_part(domain_.pslg(), ranks_), goal(1), options, ranks_)
                                        : mesh(domain_, goal(1), options, ranks_);
    if (!piece) MPI_Abort(MPI_COMM_WORLD, 1);
    refine_.push_back(piece->report.refine_seconds);
    pieces_.push_back(piece->seconds);
    own_seconds_.push_back(watch.seconds());
    triangles_ = piece->triangles;
    digest_ = digest(*piece, ranks_);
  }
  void make_whole(int parts, int threads, std::vector<double>& seconds) {
    rest();
    warm(parts);
    const Stopwatch watch;
    const Result<Meshed> whole = mesh(domain_, goal(parts), {.threads = threads});
    if (!whole) MPI_Abort(MPI_COMM_WORLD, 1);
    seconds.push_back(watch.seconds());
    if (parts == 1) is_same_ = is_same_ && digest(whole->mesh) == digest_;
  }

  /// Replaces the seconds of this process by those of the slowest one, round by round.
  static void take_slowest(std::vector<double>& seconds) {
    MPI_Allreduce(MPI_IN_PLACE, seconds.data(), static_cast<int>(seconds.size()), MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  }

  /// The median of the ratios of all rounds: a machine that is slow for some rounds is slow for both.
  void print_ratio(const char* other, const std::vector<double>& seconds, double of_shortest) const {
    std::vector<double> ratios;
    for (std::size_t round = 0; round < seconds.size(); ++round) ratios.push_back(seconds[round] / own_seconds_[round]);
    const Interval interval = sign_interval(ratios, 0.95);
    fmt::print(
        "speed of ranks, divided by that of {}: {:.2f} (95 % confidence: {:.2f} to {:.2f}); shortest times {:.2f}\n",
        other, median(ratios), interval.low, interval.high, of_shortest);
  }

  void print() {
    take_slowest(own_seconds_);
    take_slowest(part_seconds_);
    if (ranks_.rank() != 0) return;
    const auto millions = static_cast<double>(triangles_) / 1e6;
    const double ranks = median(own_seconds_), threads = median(whole_seconds_), parts = median(part_seconds_);
    const double least_ranks = std::ranges::min(own_seconds_), least_threads = std::ranges::min(whole_seconds_),
                 least_parts = std::ranges::min(part_seconds_);
    fmt::print("{}, {:.2f} million triangles, medians of {} rounds, and the shortest; ranks begin with {}\n",
               settings_.task.domain, millions, settings_.runs,
               settings_.parts ? "parts of the domain" : "the whole domain");
    fmt::print("{} ranks of 1 thread    {:.3f} s, {:.3f} s (refine {:.3f}, pieces {:.3f})\n", ranks_.count(), ranks,
               least_ranks, median(refine_), median(pieces_));
    fmt::print("1 process, {} threads   {:.3f} s, {:.3f} s\n", ranks_.count(), threads, least_threads);
    fmt::print("{} processes, each a mesh of 1/{} of the triangles   {:.3f} s, {:.3f} s (the slowest)\n",
               ranks_.count(), ranks_.count(), parts, least_parts);
    print_ratio("threads", whole_seconds_, least_threads / least_ranks);
    print_ratio("separate processes", part_seconds_, least_parts / least_ranks);
    fmt::print("{:.2f} million triangles per second and rank\n", millions / ranks / ranks_.count());
    fmt::print(
        "for comparison, Chernikov and Chrisochoides 2004, Table 2, 14.6 million triangles on 4 processors: MPI "
        "220.3 s, OpenMP 214.1 s, speed of ranks divided by that of threads 0.97; 0.017 million triangles per "
        "second and processor\n");
    fmt::print("digests {}\n", is_same_ ? "are equal" : "DIFFER");
  }

  Settings settings_;
  mpi::MpiRanks ranks_;
  ValidPslg domain_;
  std::vector<double> refine_, pieces_, own_seconds_, whole_seconds_, part_seconds_;
  std::uint64_t triangles_ = 0;
  Digest digest_;
  bool is_same_ = true;
};

int run(int argc, char** argv) {
  Settings settings;
  CLI::App app("Compares the ranks of an MPI job with the threads of one process. Start it with mpirun -n R.");
  app.add_option("--domain", settings.task.domain, "square or pipe")->check(CLI::IsMember({"square", "pipe"}));
  CLI::Option* all = app.add_option("--triangles", settings.task.triangles, "about this number of triangles");
  app.add_option("--per-rank", settings.per_rank, "about this number of triangles for each rank (weak scaling)")
      ->excludes(all);
  app.add_option("--runs", settings.runs, "the number of rounds");
  app.add_option("--rest", settings.rest, "seconds without work before each measured run")
      ->check(CLI::Range(0.0, 60.0));
  app.add_flag("--parts", settings.parts,
               "each rank begins with a part of the domain, as pardel-mpi does if the input is large");
  CLI11_PARSE(app, argc, argv);
  return Comparison(settings).run();
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) { return pardel::bench::run_in_job(argc, argv, pardel::bench::run); }
