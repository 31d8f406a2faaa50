#include "failures.hpp"

#include <algorithm>
#include <system_error>

#include "../../core/formats.hpp"
#include "../../core/support/picture.hpp"
#include "run_cases.hpp"
#include "shrink.hpp"

namespace pardel::harness {
namespace fs = std::filesystem;
namespace {

std::string file_name(std::string kind) {
  std::replace(kind.begin(), kind.end(), ' ', '_');
  return kind;
}

/// Draws the mesh (if it can be read), the domain on top of it, and a red dot at the place of each violation.
Status draw(const Pslg& pslg, const fs::path& mesh_file, const Outcome& outcome, const fs::path& svg) {
  drawing::Picture picture;
  if (const Result<Mesh> mesh = read_mesh(mesh_file)) {
    for (const Triangle& t : mesh->triangles)
      picture.polygon({mesh->points[t.v[0]], mesh->points[t.v[1]], mesh->points[t.v[2]]}, "#eef3f8",
                      drawing::Ink::thin);
  }
  for (const Segment& s : pslg.segments) picture.line(pslg.points[s.a], pslg.points[s.b], drawing::Ink::thick);
  for (const Point& p : pslg.points) picture.dot(p, "#205090");
  for (const Point& p : pslg.holes) picture.dot(p, "#a0a0a0");
  for (const Point& p : outcome.where) picture.dot(p, "#d02020");
  return picture.write(svg);
}

Status write_failure(const ReportCard& card, FailureKind& kind, const Trials& trials, std::size_t max_runs,
                     const fs::path& folder, const fs::path& work) {
  const auto fails = [&](const LatticeDomain& domain) -> Result<bool> {
    const Result<Outcome> outcome = try_mesher(trials, domain, work);
    if (!outcome) return outcome.error();
    return outcome->has(kind.kind);
  };
  const std::size_t runs = kind.verdict == Verdict::hung ? max_runs / 10 : max_runs;
  const Result<Shrunk> shrunk = shrink(make_case(card.cases[kind.first]), runs, fails);
  if (!shrunk) return shrunk.error();

  const Pslg pslg = to_pslg(shrunk->domain);
  const fs::path poly = folder / (file_name(kind.kind) + ".poly");
  kind.smallest = {pslg.points.size(), pslg.segments.size(), pslg.holes.size(), shrunk->smallest, poly};
  const Result<Outcome> outcome = try_mesher(trials, shrunk->domain, work);
  if (!outcome) return outcome.error();
  if (Status written = write_poly(pslg, poly); !written) return written;
  if (Status drawn = draw(pslg, output_in(work, trials.mesher), *outcome, fs::path(poly).replace_extension("svg"));
      !drawn)
    return drawn;
  std::error_code ignored;
  fs::remove_all(work, ignored);
  return Done{};
}

}  // namespace

Status write_failures(ReportCard& card, const Trials& trials, std::size_t max_runs, int jobs, const fs::path& folder,
                      const fs::path& work) {
  return run_tasks(card.kinds.size(), jobs, [&](std::size_t k) {
    return write_failure(card, card.kinds[k], trials, max_runs, folder, work / ("shrink-" + std::to_string(k)));
  });
}

}  // namespace pardel::harness
