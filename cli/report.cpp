#include "report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "../core/formats.hpp"
#include "beside_mesh.hpp"
#include "gaps_text.hpp"
#include "json_text.hpp"
#include "memory.hpp"
#include "names.hpp"
#include "output.hpp"
#include "plural.hpp"
#include "warnings_json.hpp"

namespace pardel::cli {
namespace {

nlohmann::ordered_json goal_json(const MeshRun& run) {
  // The JSON library writes infinity (no cap) as null.
  return {{"min_angle_deg", run.goal.min_angle_deg},
          {"max_area", run.goal.max_area},
          {"max_edge", run.goal.max_edge},
          {"region_caps", run.goal.region_caps},
          {"sizes", run.sizes.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(run.sizes.string())},
          {"sources", run.sources.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(run.sources.string())},
          {"grading", run.goal.grading},
          {"feature_size", run.goal.feature_edges},
          {"conforming", run.goal.conforming},
          {"convex_hull", run.goal.convex_hull},
          {"placement", placement_names[run.options.placement]},
          {"interior", interior_names[run.options.interior]},
          {"kept_markers", run.options.kept_markers},
          {"max_vertices", run.options.max_vertices},
          {"min_edge", run.options.min_edge}};
}

/// The index of a vertex or a triangle in the mesh, from 0; null for no_index.
nlohmann::ordered_json id_json(Index id) {
  return id == no_index ? nlohmann::ordered_json() : nlohmann::ordered_json(id);
}

nlohmann::ordered_json exemption_json(const Exemption& exemption) {
  nlohmann::ordered_json angle;
  if (exemption.apex != no_index) angle = exemption.angle_deg;
  return {{"triangle", id_json(exemption.triangle)},
          {"reason", pardel::name(exemption.reason)},
          {"apex", id_json(exemption.apex)},
          {"input_angle_deg", angle}};
}

nlohmann::ordered_json leaves_json(const Tiling& tiling) {
  nlohmann::ordered_json leaves = nlohmann::ordered_json::array();
  for (const TileLeaf& leaf : tiling.leaves) leaves.push_back({leaf.level, leaf.column, leaf.row, leaf.colour});
  return leaves;
}

/// The decomposition that was used: `automatic` has chosen one of the two others.
Decomposition decomposition_of(const MeshRun& run) {
  if (run.options.decomposition != Decomposition::automatic) return run.options.decomposition;
  return run.report.tiling.leaves.empty() ? Decomposition::lattice : Decomposition::quadtree;
}

/// The tiles, their bounds on circumradii from the theory, and the number of triangles handed on (passed to
/// another cell).
nlohmann::ordered_json decomposition_json(const MeshRun& run) {
  const Tiling& tiling = run.report.tiling;
  Sweep sum;
  for (const Sweep& sweep : tiling.sweeps) {
    sum.to_other_cells += sweep.to_other_cells;
    sum.beyond_box += sweep.beyond_box;
    sum.out_of_numbers += sweep.out_of_numbers;
    sum.against_promise += sweep.against_promise;
  }
  const double side = std::min(tiling.cell_width, tiling.cell_height);
  return {{"kind", decomposition_names[decomposition_of(run)]},
          {"columns", tiling.columns},
          {"rows", tiling.rows},
          {"cells", std::uint64_t{tiling.columns} * tiling.rows},
          {"low", {tiling.low.x, tiling.low.y}},
          {"high", {tiling.high.x, tiling.high.y}},
          {"cell_side", side},
          {"circumradius",
           {{"measured", tiling.largest_radius},
            {"by_t3", tiling.radius_by_t3},
            {"by_t3_sharp", tiling.radius_by_t3_sharp}}},
          {"cell_side_over_circumradius", side / tiling.largest_radius},
          {"inserted_before", tiling.vertices_before},
          {"handed_on",
           {{"to_other_cells", sum.to_other_cells},
            {"beyond_box", sum.beyond_box},
            {"out_of_numbers", sum.out_of_numbers},
            {"against_promise", sum.against_promise}}},
          {"thread_of_cell", tiling.thread_of_cell},
          {"leaves", leaves_json(tiling)}};
}

nlohmann::ordered_json sweeps_json(const Tiling& tiling) {
  nlohmann::ordered_json sweeps = nlohmann::ordered_json::array();
  for (const Sweep& sweep : tiling.sweeps)
    sweeps.push_back({{"columns", sweep.columns},
                      {"rows", sweep.rows},
                      {"inserted", sweep.inserted},
                      {"largest_task", sweep.largest_task},
                      {"handed_on", sweep.handed_on()},
                      {"seconds", sweep.seconds}});
  return sweeps;
}

nlohmann::ordered_json refine_json(const MeshRun& run) {
  const Report& report = run.report;
  nlohmann::ordered_json exempt = nlohmann::ordered_json::object();
  for (int i = 0; i < exempt_reasons; ++i) {
    const auto reason = static_cast<ExemptReason>(i);
    exempt[pardel::name(reason)] = report.count(reason);
  }
  nlohmann::ordered_json exemptions = nlohmann::ordered_json::array();
  for (const Exemption& exemption : report.exempt) exemptions.push_back(exemption_json(exemption));
  return {
      {"laid", report.laid},
      {"restarts", report.restarts},
      {"inserted", report.inserted},
      {"segment_splits", report.segment_splits},
      {"refused", report.refused},
      {"sweeps", sweeps_json(report.tiling)},
      {"sweeps_checked", run.sweeps_checked ? nlohmann::ordered_json(*run.sweeps_checked) : nlohmann::ordered_json()},
      {"exempt", exempt},
      {"exemptions", exemptions}};
}

nlohmann::ordered_json ranks_json(const RanksOfRun& ranks) {
  return {{"count", ranks.triangles.size()},
          {"pieces", ranks.pieces},
          {"input", ranks.divided ? "parts" : "whole"},
          {"triangles", ranks.triangles},
          {"peak_rss_bytes", ranks.peak_memory}};
}

/// Of this process, or of the rank that has used most.
std::uint64_t most_memory(const MeshRun& run) {
  return run.ranks ? std::ranges::max(run.ranks->peak_memory) : peak_memory();
}

/// `asked_for`: the user wants equilateral triangles, not only a good mesh.
std::string filling_text(const Report& report, bool asked_for) {
  if (report.laid == 0 && asked_for)
    return "note    the interior is refined: equilateral triangles do not fit, or do not make the mesh smaller\n";
  if (report.laid == 0) return {};
  return fmt::format("laid    {}{}\n", plural(report.laid, "equilateral triangle"),
                     report.restarts > 0 ? fmt::format(", after {}", plural(report.restarts, "restart")) : "");
}

std::string names_text(const std::vector<GroupName>& names) {
  std::vector<std::string> texts;
  for (const GroupName& name : names) texts.push_back(text_of(name));
  return names.empty() ? "" : fmt::format("names   {}\n", fmt::join(texts, ", "));
}

nlohmann::ordered_json names_json(const std::vector<GroupName>& names) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const GroupName& name : names)
    list.push_back({{name.of == GroupName::Of::marker ? "marker" : "region", name.value}, {"name", name.name}});
  return list;
}

}  // namespace

void count_input(const Pslg& input, MeshRun& run) {
  run.points = input.points.size();
  run.segments = input.segments.size();
  run.holes = input.holes.size();
  run.regions = input.regions.size();
}

void describe_goal(const Goal& goal, std::span<const Region> regions, bool expects_hull, MeshRun& run) {
  const auto has_cap = [](const Region& region) { return std::isfinite(region.max_area); };
  run.goal = goal;
  run.region_caps_unused = !goal.region_caps && std::ranges::any_of(regions, has_cap);
  run.hull_by_default = !expects_hull && !run.refined && run.segments == 0;
}

std::string to_json(const MeshRun& run) {
  const MeshStatistics& mesh = run.statistics;
  const Seconds& s = run.seconds;
  nlohmann::ordered_json json = {
      {"schema", "pardel.report/1"},
      {"version", PARDEL_VERSION},
      {"file", run.name},
      {"input", {{"points", run.points}, {"segments", run.segments}, {"holes", run.holes}, {"regions", run.regions}}},
      {"points_outside", run.points_outside},
      {"warnings", warnings_json(run.warnings, 0)},
      {"goal", goal_json(run)},
      {"threads", omp_get_max_threads()},
      {"decomposition", decomposition_json(run)},
      {"seconds",
       {{"read", s.read},
        {"validate", s.validate},
        {"triangulate", s.triangulate},
        {"refine", s.refine},
        {"check", s.check},
        {"write", s.write},
        {"statistics", s.statistics},
        {"total", s.total}}},
      {"mesh",
       {{"vertices", mesh.vertices},
        {"triangles", mesh.triangles},
        {"min_angle_deg", mesh.min_angle_deg},
        {"max_angle_deg", mesh.max_angle_deg},
        {"max_circumradius", mesh.max_circumradius},
        {"area", mesh.area}}},
      {"names", names_json(run.names)},
      {"refine", refine_json(run)},
      {"gaps", gaps_json(run.report.gaps, 0)},
      {"goal_met", run.report.goal_met()},
      {"peak_rss_bytes", most_memory(run)},
      {"digest", to_string(run.digest)}};
  if (run.large) json["warnings"].push_back(warning_json(*run.large));
  if (run.ranks && run.ranks->divided) json["warnings"] = json["gaps"] = nullptr;
  if (run.ranks) json["ranks"] = ranks_json(*run.ranks);
  if (run.mesher) json["mesher"] = mesher_json(*run.mesher);
  if (run.certificate) json["certificate"] = nlohmann::ordered_json::parse(to_json(*run.certificate));
  return json_text(json);
}

std::string text_of_mesh(const MeshRun& run) {
  const MeshStatistics& mesh = run.statistics;
  std::string text =
      fmt::format("{}: {}, {}, {}, {}\n", run.name, plural(run.points, "point"), plural(run.segments, "segment"),
                  plural(run.holes, "hole"), plural(run.regions, "region"));
  if (run.hull_by_default)
    text += fmt::format(
        "note    the input has no segments, so the domain is the convex hull of its points; {} refines a mesh\n",
        run.ranks ? "'pardel mesh --refine'" : "--refine");
  if (run.region_caps_unused)
    text += fmt::format("note    the area caps of the regions are ignored{}\n",
                        run.refined ? " when a mesh is refined" : "; --regions enables them");
  text += fmt::format("mesh    {}, {}, angles {:.2f} to {:.2f} degrees, area {:.6g}\n",
                      plural(mesh.vertices, "vertex", "vertices"), plural(mesh.triangles, "triangle"),
                      mesh.min_angle_deg, mesh.max_angle_deg, mesh.area);
  text += names_text(run.names);
  text += filling_text(run.report, run.options.interior == Interior::fill);
  if (run.mesher) text += mesher_text(*run.mesher);
  if (const std::string list = reasons(run.exempt, true); !list.empty())
    text += fmt::format("exempt  {}, each at a small input angle\n", list);
  if (const std::string list = reasons(run.exempt, false); !list.empty()) text += fmt::format("missed  {}\n", list);
  if (run.sweeps_checked) text += fmt::format("sweeps  {}, the mesh was checked after each\n", *run.sweeps_checked);
  if (run.certificate) text += fmt::format("check   {}\n", run.certificate->valid ? "valid" : "NOT VALID");
  return text;
}

std::string to_text(const MeshRun& run) {
  const Seconds& s = run.seconds;
  std::string text = text_of_mesh(run);
  text += fmt::format("time    {:.3f} s (read {:.3f}, mesh {:.3f}, check {:.3f}, write {:.3f}, statistics {:.3f})\n",
                      s.total, s.read, s.validate + s.triangulate + s.refine, s.check, s.write, s.statistics);
  text += fmt::format("digest  {}\n", to_string(run.digest));
  for (const auto& file : run.outputs) text += fmt::format("wrote   {}\n", fmt::join(written_files(file), ", "));
  return text;
}

}  // namespace pardel::cli
