// Reading and writing files, and what the program computes from a mesh afterwards. The mesh is the pipe with 6.5
// million triangles; the files are in a temporary folder, so in the page cache after the first reading. Argument: the
// number of threads. Counters: the size of the files, the processor time of all threads in the program and in the
// system, and MB per second of time in the program.
#include <benchmark/benchmark.h>
#include <omp.h>
#include <sys/resource.h>

#include <filesystem>
#include <initializer_list>
#include <stdexcept>
#include <string>

#include "../core/digest.hpp"
#include "../core/formats.hpp"
#include "../core/neighbours.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/checker/statistics.hpp"
#include "../properties/domains/domains.hpp"
#include "workloads/temporary_folder.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;
using workloads::TemporaryFolder;

const Mesh& pipe() {
  static const Mesh made = mesh(domains::pipe(), {.max_area = 3.85e-7}, {.interior = Interior::fill})->mesh;
  return made;
}

constexpr TriangleFiles all_files{.write_edge = true, .write_neigh = true};

bool write_all(const TemporaryFolder& folder) {
  return write_triangle_files(pipe(), {}, folder / "t", all_files).ok() && write_vtu(pipe(), folder / "t.vtu").ok() &&
         write_msh(pipe(), folder / "t.msh", MshEncoding::binary).ok() &&
         write_msh(pipe(), folder / "text.msh", MshEncoding::ascii).ok();
}

/// A folder with all files.
const TemporaryFolder& folder() {
  static const TemporaryFolder made;
  static const bool complete = write_all(made);
  if (!complete) throw std::runtime_error("the files cannot be written");
  return made;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Calls work() again and again. The files are those that it reads or writes.
template <class Work>
void measure(benchmark::State& state, std::initializer_list<const char*> files, const Work& work) {
  omp_set_num_threads(static_cast<int>(state.range(0)));
  folder();
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  for (auto _ : state)
    if (!work()) return state.SkipWithError("a file cannot be written or read");
  getrusage(RUSAGE_SELF, &after);
  const auto calls = static_cast<double>(state.iterations());
  const double user = (seconds(after.ru_utime) - seconds(before.ru_utime)) / calls;
  state.counters["user"] = user;
  state.counters["system"] = (seconds(after.ru_stime) - seconds(before.ru_stime)) / calls;
  if (files.size() == 0) return;
  double size = 0;
  for (const char* file : files) size += 1e-6 * static_cast<double>(fs::file_size(folder() / file));
  state.counters["MB"] = size;
  state.counters["MB/s"] = size / user;
}

void write_node_and_others(benchmark::State& state) {
  measure(state, {"t.node", "t.ele", "t.poly", "t.edge", "t.neigh"},
          [&] { return write_triangle_files(pipe(), {}, folder() / "t", all_files).ok(); });
}
void write_vtu_file(benchmark::State& state) {
  measure(state, {"t.vtu"}, [] { return write_vtu(pipe(), folder() / "t.vtu").ok(); });
}
void write_msh_file(benchmark::State& state) {
  measure(state, {"t.msh"}, [] { return write_msh(pipe(), folder() / "t.msh", MshEncoding::binary).ok(); });
}
void write_msh_text(benchmark::State& state) {
  measure(state, {"text.msh"}, [] { return write_msh(pipe(), folder() / "text.msh", MshEncoding::ascii).ok(); });
}

void read_node(benchmark::State& state) {
  measure(state, {"t.node"}, [] { return read_pslg(folder() / "t.node").ok(); });
}
void read_node_and_others(benchmark::State& state) {
  fs::rename(folder() / "t.poly", folder() / "hidden.poly");  // without a .poly, the .edge is read
  measure(state, {"t.node", "t.ele", "t.edge", "t.neigh"}, [] { return read_mesh(folder() / "t.ele").ok(); });
  fs::rename(folder() / "hidden.poly", folder() / "t.poly");
}
void read_vtu_file(benchmark::State& state) {
  measure(state, {"t.vtu"}, [] { return read_mesh(folder() / "t.vtu").ok(); });
}
void read_msh_file(benchmark::State& state) {
  measure(state, {"t.msh"}, [] { return read_mesh(folder() / "t.msh").ok(); });
}
void read_msh_text(benchmark::State& state) {
  measure(state, {"text.msh"}, [] { return read_mesh(folder() / "text.msh").ok(); });
}

/// Every reader of meshes does this after reading.
void find_neighbours(benchmark::State& state) {
  Mesh copy = pipe();
  measure(state, {}, [&] { return rebuild_neighbours(copy.triangles, copy.points.size()) == 0; });
}
void compute_statistics(benchmark::State& state) {
  measure(state, {}, [] { return statistics(pipe()).triangles > 0; });
}
void compute_digest(benchmark::State& state) {
  measure(state, {}, [] { return digest(pipe()) != Digest(); });
}

void with_threads(benchmark::internal::Benchmark* each) {
  each->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK(write_node_and_others)->Apply(with_threads);
BENCHMARK(write_vtu_file)->Apply(with_threads);
BENCHMARK(write_msh_file)->Apply(with_threads);
BENCHMARK(write_msh_text)->Apply(with_threads);
BENCHMARK(read_node)->Apply(with_threads);
BENCHMARK(read_node_and_others)->Apply(with_threads);
BENCHMARK(read_vtu_file)->Apply(with_threads);
BENCHMARK(read_msh_file)->Apply(with_threads);
BENCHMARK(read_msh_text)->Apply(with_threads);
BENCHMARK(find_neighbours)->Apply(with_threads);
BENCHMARK(compute_statistics)->Apply(with_threads);
BENCHMARK(compute_digest)->Apply(with_threads);

}  // namespace
}  // namespace pardel

BENCHMARK_MAIN();
