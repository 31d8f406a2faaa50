#include "input.hpp"

#include <fmt/core.h>

#include <fstream>
#include <sstream>
#include <utility>

#include "../core/formats.hpp"
#include "../parallel/repair.hpp"
#include "domain_of_mesh.hpp"
#include "exit_code.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

/// The first number of the next line that has one; `fallback` at the end of the file.
long long first_number(std::istream& in, long long fallback) {
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    if (long long value = 0; words >> value) return value;
  }
  return fallback;
}

/// The domain of a mesh in Triangle's files, where the .poly written with it lies beside it.
Result<Pslg> domain_beside(const fs::path& file, const Mesh& mesh) {
  const fs::path poly = fs::path(file).replace_extension(".poly");
  const bool triangle_files = file.extension() == ".node" || file.extension() == ".ele";
  std::error_code ignored;
  if (triangle_files && fs::exists(poly, ignored)) {
    Result<Pslg> pslg = read_pslg(poly);
    if (!pslg || pslg->points.size() == mesh.points.size()) return pslg;
  }
  return domain_of(mesh);
}

}  // namespace

int number_base(const fs::path& file) {
  std::ifstream in(file);
  if (first_number(in, 0) == 0 && file.extension() == ".poly")
    return number_base(fs::path(file).replace_extension(".node"));
  return first_number(in, 1) == 0 ? 0 : 1;
}

bool has_own_points(const fs::path& poly) {
  std::ifstream in(poly);
  return first_number(in, 0) != 0;
}

Result<Domain> read_domain(const fs::path& file) {
  if (is_mesh_suffix(file) && file.extension() != ".node") {
    return Error{ErrorKind::usage, fmt::format("{}: a domain is needed here, a .poly or .node file; meshes are for "
                                               "'pardel mesh --refine' and 'pardel check'",
                                               file.string())};
  }
  Result<Pslg> pslg = read_pslg(file);
  if (!pslg) return pslg.error();
  return Domain{std::move(*pslg), file.string(), number_base(file)};
}

Result<Coarse> read_coarse(const fs::path& file) {
  Result<Mesh> mesh = read_mesh(file);
  if (!mesh) return mesh.error();
  Coarse coarse;
  Result<Pslg> pslg = domain_beside(file, *mesh);
  if (!pslg) return pslg.error();
  coarse.mesh = std::move(*mesh);
  coarse.domain = {std::move(*pslg), file.string(), number_base(fs::path(file).replace_extension(".node"))};
  adopt_segments(coarse);
  const fs::path area = fs::path(file).replace_extension(".area");
  std::error_code ignored;
  if (fs::exists(area, ignored)) {
    if (Status read = read_caps(coarse, area); !read) return read.error();
  }
  return coarse;
}

Status read_caps(Coarse& coarse, const fs::path& area) {
  Result<std::vector<double>> caps = read_area(area);
  if (!caps) return caps.error();
  if (caps->size() != coarse.mesh.triangles.size()) {
    return Error{ErrorKind::invalid_input, fmt::format("{}: {} area caps for {} triangles", area.string(), caps->size(),
                                                       coarse.mesh.triangles.size())};
  }
  coarse.max_areas = std::move(*caps);
  return Done{};
}

void adopt_segments(Coarse& coarse) {
  const std::vector<Segment>& segments = coarse.domain.pslg.segments;
  coarse.mesh.constrained_edges.clear();
  coarse.mesh.constrained_edges.reserve(segments.size());
  for (Index s = 0; s < segments.size(); ++s) {
    coarse.mesh.constrained_edges.push_back({segments[s].a, segments[s].b, s, segments[s].marker});
  }
}

Result<Mended> mend(Domain domain, bool convex_hull) {
  Mended mended{std::move(domain), std::nullopt, {}};
  Pslg& pslg = mended.domain.pslg;
  if (validate(pslg, {.convex_hull = convex_hull}).empty()) return mended;
  Result<Repaired> repaired = repair(pslg, 0, mended.domain.base);
  if (!repaired) return as_in_file(repaired.error(), mended.domain, convex_hull);
  for (const std::string& line : repaired->log) warn(fmt::format("{}: repaired: {}", mended.domain.name, line));
  mended.original = std::exchange(pslg, std::move(repaired->pslg));
  mended.point_map = std::move(repaired->point_map);
  return mended;
}

Error problems_error(const Domain& domain, const std::vector<Problem>& problems) {
  if (problems.size() == 1) {
    return {ErrorKind::invalid_input, fmt::format("{}: {}", domain.name, problems.front().message(domain.base))};
  }
  std::string message = fmt::format("{}: {} problems", domain.name, problems.size());
  for (const Problem& problem : problems) message += "\n  " + problem.message(domain.base);
  return {ErrorKind::invalid_input, message};
}

Error as_in_file(const Error& error, const Domain& domain, bool convex_hull) {
  if (error.kind != ErrorKind::invalid_input) return error;
  const std::vector<Problem> problems = validate(domain.pslg, {.convex_hull = convex_hull});
  return problems.empty() ? Error{error.kind, domain.name + ": " + error.message} : problems_error(domain, problems);
}

}  // namespace pardel::cli
