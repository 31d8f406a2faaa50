#include "verdict.hpp"

#include <algorithm>
#include <utility>

namespace pardel::checker {

Certificate empty_certificate(const Pslg& pslg, const Goal& goal) {
  Certificate certificate;
  certificate.goal = goal;
  for (const Region& region : pslg.regions)
    if (goal.region_caps) certificate.region_caps.push_back(region.max_area);
  certificate.angle_histogram.assign(18, 0);
  return certificate;
}

void set_verdict(Certificate& certificate, Findings found) {
  certificate.violation_counts = found.counts();
  certificate.valid = !certificate.cancelled &&
                      std::ranges::all_of(certificate.violation_counts, [](auto count) { return count == 0; });
  certificate.violations = std::move(found).sorted();
}

}  // namespace pardel::checker
