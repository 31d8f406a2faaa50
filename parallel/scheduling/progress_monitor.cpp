#include "progress_monitor.hpp"

#include <algorithm>

#include "limits.hpp"

namespace pardel::engine {

void ProgressMonitor::start(double estimate, std::uint64_t vertices, std::uint64_t triangles) {
  estimate_ = estimate;
  if (options_.max_vertices > 0) estimate_ = std::min(estimate_, 2.0 * static_cast<double>(options_.max_vertices));
  vertices_ = vertices;
  triangles_ = triangles;
}

void ProgressMonitor::phase_ended(std::uint64_t vertices, std::uint64_t triangles) {
  vertices_ = vertices;
  triangles_ = triangles;
  made_ = 0;
  report(/*thread=*/0, 0);
}

bool ProgressMonitor::report(int thread, std::uint64_t vertices_made) {
  made_ += 2 * vertices_made;
  // The number of vertices never decreases, and tasks never report more vertices than exist. The mesh alone therefore
  // determines if this limit is exceeded, although the times of the reports depend on the threads.
  if (outgrows_memory(vertices_ + made_.load() / 2, options_)) cancel();
  if (cancelled()) return false;
  if (thread == 0 && options_.progress) {
    // The sum may shrink at the end of a phase, because the split of a boundary edge makes one triangle, not two.
    shown_ = std::max(shown_, triangles_ + made_.load());
    if (!options_.progress({shown_, estimate_})) cancel();
  }
  return !cancelled();
}

}  // namespace pardel::engine
