// The fixed workloads that bench/gate, bench/track and bench/compare run. A workload has one input, in two sizes, so
// all commits and all machines do the same work. The list is in workloads.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "../../core/mesh.hpp"

namespace pardel::workloads {

/// The two sizes of a workload.
enum class Size : std::uint8_t {
  counted,  ///< some tens of millions of instructions, which valgrind counts in some seconds
  timed,    ///< some hundredths or tenths of a second, so that a clock can measure it
};

struct Setup {
  Size size = Size::counted;
  int threads = 1;  ///< >= 1

  /// The value for this size.
  template <class T>
  [[nodiscard]] T pick(T counted, T timed) const {
    return size == Size::counted ? counted : timed;
  }
};

/// A workload whose input is prepared.
struct Job {
  /// Does the work, which alone is measured. Returns false if the work fails. May be called again.
  std::function<bool()> work;
  /// After the work: the mesh that it made, checked, wrote or read. Empty if the work has no mesh.
  std::function<const Mesh&()> mesh{};
  /// The number of things that a work without a mesh computes.
  std::uint64_t items = 0;
};

struct Workload {
  std::string_view name;
  bool gated;            ///< bench/gate compares its instructions with bench/gate.json
  bool on_more_threads;  ///< it can run on several threads
  Job (*prepare)(const Setup&);
};

/// All workloads. The gated ones come first.
[[nodiscard]] std::span<const Workload> all();

// The parts of the list, by subject.
[[nodiscard]] Job mixed_predicates(const Setup& setup);
[[nodiscard]] std::span<const Workload> of_predicates();
[[nodiscard]] std::span<const Workload> of_meshes();
[[nodiscard]] std::span<const Workload> of_small_meshes();
[[nodiscard]] std::span<const Workload> of_files();
[[nodiscard]] std::span<const Workload> of_input_files();

}  // namespace pardel::workloads
