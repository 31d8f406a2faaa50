// once: runs one workload once, and prints a line of JSON.
//
//   once                                    lists the workloads: NAME, then `gate` and `threads` where they apply
//   once NAME [--timed] [--threads N]       runs a workload, in the size that is counted or in the one that is timed
//             [--twice] [--waste N]         slows it down, for tests of those who measure it: does the work twice, or
//                                           wastes about N instructions
//
// Under valgrind only the work is counted, not the preparation of its input. Exit code 1: the work failed. 2: usage.
#include <omp.h>

#include <charconv>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <ctime>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "../../core/digest.hpp"
#include "counters.hpp"
#include "touch_memory.hpp"
#include "workload.hpp"
#ifdef PARDEL_COUNTS_INSTRUCTIONS
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_TOGGLE_COLLECT static_cast<void>(0)
#endif

namespace pardel::workloads {
namespace {

struct Call {
  const Workload* workload = nullptr;
  Setup setup;
  bool twice = false;
  std::uint64_t waste = 0;
};

/// The number of an argument; empty if it is none.
std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// What the arguments say; empty if they are wrong.
std::optional<Call> parse(int argc, char** argv) {
  Call call;
  for (const Workload& each : all())
    if (each.name == argv[1]) call.workload = &each;
  if (call.workload == nullptr) return std::nullopt;
  for (int i = 2; i < argc; ++i) {
    const std::string_view option = argv[i];
    if (option == "--timed") {
      call.setup.size = Size::timed;
    } else if (option == "--twice") {
      call.twice = true;
    } else if ((option == "--threads" || option == "--waste") && i + 1 < argc) {
      const std::optional<std::uint64_t> value = number(argv[++i]);
      if (!value) return std::nullopt;
      if (option == "--waste") {
        call.waste = *value;
      } else if (*value >= 1 && *value <= 1024) {
        call.setup.threads = static_cast<int>(*value);
      } else {
        return std::nullopt;
      }
    } else {
      return std::nullopt;
    }
  }
  return call;
}

/// Wastes about so many instructions.
[[gnu::noinline]] void planted_slowdown(std::uint64_t instructions) {
  constexpr std::uint64_t instructions_per_step = 4;
  [[maybe_unused]] volatile std::uint64_t count = 0;
  for (std::uint64_t i = 0; i < instructions / instructions_per_step; ++i) count = i;
}

std::string text(std::optional<std::uint64_t> value) { return value ? std::to_string(*value) : "null"; }

struct Cost {
  double seconds = 0, cpu_seconds = 0;  ///< of the clock; of the processors, all threads together
  std::uint64_t bytes = 0;              ///< the largest memory of the work, without the memory before it
  std::optional<std::uint64_t> cycles{};
};

void print(const Call& call, const Job& job, const Cost& cost) {
  const std::uint64_t items = job.mesh ? job.mesh().triangles.size() : job.items;
  const std::string mesh = job.mesh ? '"' + to_string(digest(job.mesh())) + '"' : "null";
  std::printf(
      "{\"workload\": \"%s\", \"threads\": %d, \"timed\": %s, \"seconds\": %.9f, \"cpu_seconds\": %.9f, "
      "\"items\": %" PRIu64 ", \"triangles\": %s, \"bytes\": %" PRIu64 ", \"cycles\": %s, \"digest\": %s}\n",
      std::string(call.workload->name).c_str(), call.setup.threads, call.setup.size == Size::timed ? "true" : "false",
      cost.seconds, cost.cpu_seconds, items, job.mesh ? "true" : "false", cost.bytes, text(cost.cycles).c_str(),
      mesh.c_str());
}

/// More than any workload uses. The host of a virtual machine may provide memory only when it is first written, which
/// can take longer than the work.
constexpr std::size_t touched_memory = std::size_t{1} << 29U;

int run(const Call& call) {
  CycleCounter cycles;  // before the first thread starts
  if (call.setup.size == Size::timed) (void)touch_memory(touched_memory);
  omp_set_num_threads(call.setup.threads);
  const Job job = call.workload->prepare(call.setup);
  const bool peak_is_known = reset_peak_memory();
  const std::uint64_t before = resident_memory();
  const std::clock_t cpu_start = std::clock();
  const auto start = std::chrono::steady_clock::now();
  cycles.start();
  CALLGRIND_TOGGLE_COLLECT;
  bool done = job.work();
  if (call.twice) done = job.work() && done;
  if (call.waste > 0) planted_slowdown(call.waste);
  CALLGRIND_TOGGLE_COLLECT;
  cycles.stop();
  Cost cost{.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            .cpu_seconds = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC,
            .cycles = cycles.cycles()};
  const std::uint64_t peak = peak_is_known ? peak_memory() : 0;
  cost.bytes = peak > before ? peak - before : 0;
  if (!done) {
    std::fprintf(stderr, "once: %s: the work failed\n", std::string(call.workload->name).c_str());
    return 1;
  }
  print(call, job, cost);
  return 0;
}

void print_list() {
  for (const Workload& each : all())
    std::printf("%s%s%s\n", std::string(each.name).c_str(), each.gated ? " gate" : "",
                each.on_more_threads ? " threads" : "");
}

}  // namespace
}  // namespace pardel::workloads

int main(int argc, char** argv) try {
  using namespace pardel::workloads;
  if (argc == 1) {
    print_list();
    return 0;
  }
  const std::optional<Call> call = parse(argc, argv);
  if (!call) {
    std::fprintf(stderr, "usage: once [WORKLOAD [--timed] [--threads N] [--twice] [--waste N]]\n");
    return 2;
  }
  return run(*call);
} catch (const std::exception& e) {
  std::fprintf(stderr, "once: %s\n", e.what());
  return 1;
}
