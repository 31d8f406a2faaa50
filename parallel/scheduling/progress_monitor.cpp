#include "progress_monitor.hpp"

#include <algorithm>

#include "../threads/parallel_for.hpp"
#include "../triangulation/limits.hpp"

namespace pardel::engine {

ProgressMonitor::ProgressMonitor(const Options& options, StopSignal::Clock::duration interval)
    : options_(options), stop_([this] { return ask_caller(); }, interval) {}

Threads ProgressMonitor::threads() { return {thread_count(options_.threads, work_), &stop_}; }

void ProgressMonitor::set_aside(std::uint64_t vertices, std::uint64_t triangles) {
  vertices_aside_ = vertices;
  triangles_aside_ = triangles;
}

void ProgressMonitor::start(double estimate, std::uint64_t vertices, std::uint64_t triangles) {
  estimate_ = estimate > 0 ? estimate + static_cast<double>(triangles_aside_) : 0;
  if (options_.max_vertices > 0) estimate_ = std::min(estimate_, 2.0 * static_cast<double>(options_.max_vertices));
  vertices_ = vertices_aside_ + vertices;
  triangles_ = triangles_aside_ + triangles;
  expect(std::max(estimate_, static_cast<double>(triangles_)));
}

void ProgressMonitor::report(std::uint64_t vertices_made) {
  const std::uint64_t made = made_ += 2 * vertices_made;
  // The number of vertices never decreases, and tasks never report more vertices than exist. The mesh alone therefore
  // determines if this limit is exceeded, although the times of the reports depend on the threads.
  if (outgrows_memory(vertices_ + made / 2, options_)) stop_.stop(too_much_memory(options_));
  stop_.ask();
}

void ProgressMonitor::phase_ended(std::uint64_t vertices, std::uint64_t triangles) {
  vertices_ = vertices_aside_ + vertices;
  triangles_ = triangles_aside_ + triangles;
  made_ = 0;
  stop_.ask_now();
}

std::optional<Error> ProgressMonitor::ask_caller() {
  // The sum may shrink at the end of a phase, because the split of a boundary edge makes one triangle, not two.
  shown_ = std::max(shown_, triangles_ + made_.load());
  if (!options_.progress || options_.progress({shown_, estimate_})) return {};
  return Error{ErrorKind::cancelled, "the caller asked to stop"};
}

}  // namespace pardel::engine
