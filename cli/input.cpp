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

/// The first number of the next line that starts with a number; `fallback` if there is no such line.
long long first_number(std::istream& in, long long fallback) {
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    if (long long value = 0; words >> value) return value;
  }
  return fallback;
}

/// The domain of a mesh: the .poly of the same name if it exists and has as many points, otherwise domain_of(mesh).
Result<Pslg> domain_with(const fs::path& file, const Mesh& mesh) {
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

bool has_own_points(const fs::path& poly) {
  std::ifstream in(poly);
  return first_number(in, 0) != 0;
}

Result<Domain> read_domain(const fs::path& file) {
  if (is_mesh_suffix(file) && file.extension() != ".node") {
    return Error{ErrorKind::usage, fmt::format("{}: expected a domain, a .poly or .node file; meshes are for "
                                               "'pardel mesh --refine' and 'pardel check'",
                                               file.string())};
  }
  Result<Pslg> pslg = read_pslg(file);
  if (!pslg) return pslg.error();
  return Domain{std::move(*pslg), file.string()};
}

Result<CoarseMesh> read_coarse_mesh(const fs::path& file) {
  Result<Mesh> mesh = read_mesh(file);
  if (!mesh) return mesh.error();
  Result<Pslg> pslg = domain_with(file, *mesh);
  if (!pslg) return pslg.error();
  CoarseMesh coarse{std::move(*mesh), {}, {std::move(*pslg), file.string()}};
  adopt_segments(coarse);
  const fs::path area = fs::path(file).replace_extension(".area");
  std::error_code ignored;
  if (fs::exists(area, ignored)) {
    if (Status read = read_caps(coarse, area); !read) return read.error();
  }
  return coarse;
}

Status read_caps(CoarseMesh& coarse, const fs::path& area) {
  Result<std::vector<double>> caps = read_area(area);
  if (!caps) return caps.error();
  if (caps->size() != coarse.mesh.triangles.size()) {
    return Error{ErrorKind::invalid_input, fmt::format("{}: {} area caps for {} triangles", area.string(), caps->size(),
                                                       coarse.mesh.triangles.size())};
  }
  coarse.max_areas = std::move(*caps);
  return Done{};
}

void adopt_segments(CoarseMesh& coarse) {
  const std::vector<Segment>& segments = coarse.domain.pslg.segments;
  coarse.mesh.constrained_edges.clear();
  coarse.mesh.constrained_edges.reserve(segments.size());
  for (Index s = 0; s < segments.size(); ++s) {
    coarse.mesh.constrained_edges.push_back({segments[s].a, segments[s].b, s, segments[s].marker});
  }
}

Result<ValidPslg> validated(Domain domain, const ValidateOptions& options) {
  Result<ValidPslg, std::vector<Problem>> valid = validate(std::move(domain.pslg), options);
  if (!valid) return problems_error(domain, valid.error());
  return std::move(valid).value();
}

Result<MaybeRepaired> validated_or_repaired(Domain domain, const ValidateOptions& options) {
  Result<ValidPslg, std::vector<Problem>> valid = validate(std::move(domain.pslg), options);
  if (valid) return MaybeRepaired{std::move(valid).value(), std::nullopt, {}};
  Result<Repaired> repaired = repair(domain.pslg);
  if (!repaired) return problems_error(domain, valid.error());
  for (const std::string& line : repaired->log) warn(fmt::format("{}: repaired: {}", domain.name, line));
  ValidPslg valid_domain =
      options.convex_hull ? std::move(repaired->domain).with_convex_hull() : std::move(repaired->domain);
  return MaybeRepaired{std::move(valid_domain), std::move(domain.pslg), std::move(repaired->point_map)};
}

const Pslg& pslg_of(const Source& source) {
  const auto* domain = std::get_if<ValidPslg>(&source);
  return domain != nullptr ? domain->pslg() : std::get<CoarseMesh>(source).domain.pslg;
}

Error problems_error(const Domain& domain, std::span<const Problem> problems) {
  const int base = domain.pslg.first_id.value;
  if (problems.size() == 1) {
    return {ErrorKind::invalid_input, fmt::format("{}: {}", domain.name, problems.front().message(base))};
  }
  std::string message = fmt::format("{}: {} problems", domain.name, problems.size());
  for (const Problem& problem : problems) message += "\n  " + problem.message(base);
  return {ErrorKind::invalid_input, message};
}

Error with_name(const Error& error, const std::string& name) {
  return error.kind == ErrorKind::invalid_input ? Error{error.kind, name + ": " + error.message} : error;
}

}  // namespace pardel::cli
