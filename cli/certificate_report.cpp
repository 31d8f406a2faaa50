#include "certificate_report.hpp"

#include <fmt/core.h>

#include <string>

#include "centroid.hpp"
#include "findings_text.hpp"

namespace pardel::cli {

bool may_lack_sizes(const Goal& goal, const Certificate& certificate) {
  return goal.size && certificate.violation_counts[static_cast<std::size_t>(ViolationKind::size_exceeded)] > 0;
}

Status require_sizes(const Mesh& mesh, const Goal& goal, const Certificate& certificate) try {
  if (!may_lack_sizes(goal, certificate)) return Done{};
  for (const Triangle& triangle : mesh.triangles) (void)goal.size(centroid(mesh, triangle));
  return Done{};
} catch (const Error& no_size) {
  return no_size;
}

void print_certificate(const Certificate& certificate, const std::filesystem::path& json,
                       const NumbersInWitnesses& numbers, double max_circumradius) {
  const std::string all_in = json.empty() ? "the file of --json" : json.string();
  fmt::print("{}", summary_text(certificate, numbers));
  if (certificate.valid) return;
  fmt::print(
      "{}\nnote    numbers are those of the files, or count from 0 where a file has none; triangles of a .msh count "
      "from 1; --json counts from 0\n",
      findings_text(certificate, all_in, numbers, max_circumradius));
}

}  // namespace pardel::cli
