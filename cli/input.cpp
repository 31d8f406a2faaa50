#include "input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

#include "../core/formats.hpp"
#include "../core/support/byte_order_mark.hpp"
#include "../core/support/open_file.hpp"
#include "domain_of_mesh.hpp"
#include "domain_or_mesh.hpp"
#include "exit_code.hpp"
#include "faces.hpp"
#include "follow_edges.hpp"
#include "plural.hpp"
#include "read_geojson.hpp"
#include "suffix.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

/// The first number of the next line that starts with a number; `fallback` if there is no such line.
long long first_number(std::istream& in, long long fallback) {
  for (std::string line; std::getline(in, line);) {
    const std::string_view text = without_byte_order_mark(line);
    std::istringstream words(std::string(text.substr(0, text.find('#'))));
    if (long long value = 0; words >> value) return value;
  }
  return fallback;
}

/// A .poly that was written with a mesh of second order refers to the nodes of the .node, of which the reader of the
/// mesh has removed the middles of edges. It has read the segments from the same .poly.
void remove_middles(Pslg& pslg, const Mesh& mesh) {
  take_points(pslg, mesh);
  pslg.segments = to_edge_set(mesh.constrained_edges).edges;
}

struct PolyBeside {
  std::optional<Pslg> pslg;  ///< none if there is no .poly, or an unused one
  std::string note;          ///< why it is not used
};
/// The .poly beside a mesh in Triangle's files, if it has as many points as the mesh, or if it was written with it.
Result<PolyBeside> poly_beside(const fs::path& file, const Mesh& mesh) {
  const fs::path poly = fs::path(file).replace_extension(".poly");
  const bool triangle_files = file.extension() == ".node" || file.extension() == ".ele";
  std::error_code ignored;
  if (!triangle_files || !fs::exists(poly, ignored)) return PolyBeside{};
  Result<Pslg> pslg = read_pslg(poly);
  if (!pslg) return pslg.error();
  if (pslg->points.size() > mesh.points.size() && !has_own_points(poly)) remove_middles(*pslg, mesh);
  if (pslg->points.size() == mesh.points.size()) return PolyBeside{std::move(*pslg), {}};
  if (!has_own_points(poly)) return PolyBeside{};  // read_mesh() has read its segments
  return PolyBeside{
      {},
      fmt::format("{}: note: not used, because it has {} for a mesh with {}", poly.string(),
                  plural(pslg->points.size(), "point"), plural(mesh.points.size(), "vertex", "vertices"))};
}

/// The .poly, or else the outline of the mesh.
Result<Pslg> domain_or_outline(std::optional<Pslg> poly, const fs::path& file, const Mesh& mesh) {
  if (poly) return std::move(*poly);
  Result<Pslg> outline = domain_of(mesh);
  if (!outline) return with_name(outline.error(), file.string());
  return outline;
}

/// The edges of the mesh as segments, each once.
std::vector<Segment> edges_as_segments(const Mesh& mesh) {
  EdgeSet all = to_edge_set(mesh.constrained_edges);
  all.finish();
  return std::move(all.edges);
}

Error no_domain(const fs::path& file) {
  return {ErrorKind::usage, fmt::format("{}: expected a domain, a .poly, .node or .geojson file; meshes are for "
                                        "'pardel mesh --refine' and 'pardel check'",
                                        file.string())};
}

}  // namespace

Status check_standard_input(std::span<const fs::path> inputs) {
  if (std::ranges::count_if(inputs, is_standard_input) < 2) return Done{};
  return Error{ErrorKind::usage, "-: only one input can come from standard input"};
}

bool has_own_points(const fs::path& poly) {
  std::ifstream in(poly);
  return first_number(in, 0) != 0;
}

Result<Domain> read_domain(const fs::path& file) {
  if (is_geojson(file)) {
    Result<Pslg> drawn = read_geojson(file);
    if (!drawn) return drawn.error();
    return Domain{std::move(*drawn), file.string()};
  }
  if (!is_domain_suffix(file) && !mesh_format(file))
    return unknown_format(file, "a domain", ".poly, .node, .geojson and .json");
  if (!is_domain_suffix(file)) return no_domain(file);
  if (file.has_extension()) {
    Result<Pslg> pslg = read_pslg(file);
    if (!pslg) return pslg.error();
    return Domain{std::move(*pslg), file.string()};
  }
  Result<std::variant<Pslg, Mesh>> read = read_domain_or_mesh(file);
  if (!read) return read.error();
  auto* pslg = std::get_if<Pslg>(&*read);
  if (pslg == nullptr) return no_domain(file);
  return Domain{std::move(*pslg), file.string()};
}

Result<Pslg> domain_with(const fs::path& file, const Mesh& mesh) {
  Result<PolyBeside> poly = poly_beside(file, mesh);
  if (!poly) return poly.error();
  return domain_or_outline(std::move(poly->pslg), file, mesh);
}

Result<CoarseMesh> read_coarse_mesh(const fs::path& file) {
  Result<Mesh> mesh = read_mesh(file);
  if (!mesh) return mesh.error();
  Result<PolyBeside> beside = poly_beside(file, *mesh);
  if (!beside) return beside.error();
  std::optional<Pslg>& poly = beside->pslg;
  if (poly) mesh->constrained_edges = segments_as_edges(*poly);
  const Result<FollowedEdges> followed = follow_edges(*mesh, poly ? &*poly : nullptr);
  if (!followed) return with_name(followed.error(), file.string());
  const bool has_numbers = poly && followed->lines == 0;
  if (poly && followed->lines > 0) poly->segments = edges_as_segments(*mesh);
  if (poly)
    if (Status proper = check_boundary(*mesh); !proper) return with_name(proper.error(), file.string());
  Result<Pslg> domain = domain_or_outline(std::move(poly), file, *mesh);
  if (!domain) return domain.error();
  CoarseMesh coarse{
      std::move(*mesh), {}, {std::move(*domain), file.string(), {}, !has_numbers}, *followed, std::move(beside->note)};
  coarse.domain.points = coarse.mesh.numbers;
  adopt_segments(coarse);
  const fs::path area = fs::path(file).replace_extension(".area");
  std::error_code ignored;
  if (!is_standard_input(file) && fs::exists(area, ignored)) {
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

std::vector<ConstrainedEdge> segments_as_edges(const Pslg& pslg) {
  std::vector<ConstrainedEdge> edges;
  edges.reserve(pslg.segments.size());
  for (const Segment& segment : pslg.segments) edges.push_back({segment.a, segment.b, no_index, segment.marker});
  return edges;
}

void adopt_segments(CoarseMesh& coarse) {
  const std::vector<Segment>& segments = coarse.domain.pslg.segments;
  coarse.mesh.constrained_edges.clear();
  coarse.mesh.constrained_edges.reserve(segments.size());
  for (Index s = 0; s < segments.size(); ++s) {
    coarse.mesh.constrained_edges.push_back({segments[s].a, segments[s].b, s, segments[s].marker});
  }
}

Result<ValidPslg, Refusal> validated(Domain domain, const ValidateOptions& options) {
  Result<ValidPslg, std::vector<Problem>> valid = validate(std::move(domain.pslg), options);
  if (!valid) return refusal_of(domain, valid.error());
  return std::move(valid).value();
}

Result<MaybeRepaired, Refusal> validated_or_repaired(Domain domain, const RepairOptions& options, int threads,
                                                     std::string_view hull_option) {
  Result<ValidPslg, std::vector<Problem>> valid =
      validate(std::move(domain.pslg), {.convex_hull = options.convex_hull, .threads = threads});
  if (valid && options.snap == 0.0) return MaybeRepaired{std::move(valid).value(), std::nullopt, {}, {}};
  Result<Repaired> repaired = repair(valid ? valid->pslg() : domain.pslg, options);
  if (!repaired && repaired.error().kind == ErrorKind::usage) return Refusal(repaired.error());
  if (!repaired && valid) return Refusal(with_name(repaired.error(), domain.name));
  if (valid && repaired->log.empty()) return MaybeRepaired{std::move(repaired->domain), std::nullopt, {}, {}};
  if (!repaired) return refusal_of(domain, valid.error(), repaired.error(), hull_option);
  std::vector<std::string> log;
  for (const std::string& line : repaired->log) log.push_back(fmt::format("{}: repaired: {}", domain.name, line));
  Pslg original = valid ? std::move(valid).value().pslg() : std::move(domain.pslg);
  return MaybeRepaired{std::move(repaired->domain), std::move(original), std::move(repaired->point_map),
                       std::move(log)};
}

const Pslg& pslg_of(const Source& source) {
  const auto* domain = std::get_if<ValidPslg>(&source);
  return domain != nullptr ? domain->pslg() : std::get<CoarseMesh>(source).domain.pslg;
}

Result<MaybeRepaired, Refusal> valid_domain(Domain domain, bool repair, const RepairOptions& options, int threads) {
  if (repair) return validated_or_repaired(std::move(domain), options, threads);
  Result<ValidPslg, Refusal> valid =
      validated(std::move(domain), {.convex_hull = options.convex_hull, .threads = threads});
  if (!valid) return valid.error();
  return MaybeRepaired{std::move(*valid), std::nullopt, {}, {}};
}

Status check_sizes_of(const MaybeRepaired& repaired, const SizeField& sizes) {
  if (repaired.original && std::holds_alternative<PointSizes>(sizes))
    return Error{ErrorKind::usage,
                 "--sizes refers to the points of the input, which --repair changed; write the repaired domain with "
                 "'pardel doctor' and give sizes for its points"};
  return Done{};
}

std::vector<Warning> print_warnings(const ValidPslg& domain, const std::string& name, std::string_view program) {
  std::vector<Warning> warnings = find_warnings(domain);
  for (const Warning& warning : warnings)
    warn(fmt::format("{}: warning: {}", name, warning.message(domain.pslg().first_id.value)), program);
  return warnings;
}

NumbersInMessages numbers_of(const Domain& domain) {
  NumbersInMessages numbers{domain.pslg.first_id.value, domain.points.of_points};
  if (domain.has_unnumbered_segments) numbers.unnumbered = domain.pslg.segments;
  return numbers;
}

Refusal refusal_of(const Domain& domain, std::span<const Problem> problems) {
  const NumbersInMessages numbers = numbers_of(domain);
  Error error{ErrorKind::invalid_input, domain.name + ": " + problems_text(problems, numbers) +
                                            advice(domain.pslg, problems, domain.name, false)};
  return {std::move(error), problems, numbers};
}

Refusal refusal_of(const Domain& domain, std::span<const Problem> problems, const Error& why,
                   std::string_view hull_option) {
  const NumbersInMessages numbers = numbers_of(domain);
  std::string text = problems_text(problems, numbers);
  if (text.find(why.message) == std::string::npos) text += "\nthe repair ends here: " + why.message;
  text += advice(domain.pslg, problems, domain.name, true, hull_option);
  return {{ErrorKind::invalid_input, domain.name + ": " + text}, problems, numbers};
}

Error with_name(const Error& error, const std::string& name) {
  return error.kind == ErrorKind::invalid_input ? Error{error.kind, name + ": " + error.message} : error;
}

}  // namespace pardel::cli
