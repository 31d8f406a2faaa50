#include "tile_hues.hpp"

#include <fmt/core.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "../core/formats.hpp"
#include "../parallel/report.hpp"
#include "centroid.hpp"

namespace pardel::cli {
namespace {

Error unfit(const std::filesystem::path& report, const std::string& why) {
  return {ErrorKind::invalid_input, report.string() + ": " + why};
}

/// Throws nlohmann::json::exception if a key is missing or a value has a wrong type.
Result<Tiling> tiling_of(const nlohmann::json& json, const Mesh& mesh, const std::filesystem::path& report) {
  if (json.at("schema") != "pardel.report/1") return unfit(report, "the schema is not pardel.report/1");
  if (const auto triangles = json.at("mesh").at("triangles").get<std::size_t>(); triangles != mesh.triangles.size())
    return unfit(report, fmt::format("this is the report of a mesh of {} triangles, and the mesh to draw has {}",
                                     triangles, mesh.triangles.size()));
  const nlohmann::json& cut = json.at("decomposition");
  const auto columns = cut.at("columns").get<Index>(), rows = cut.at("rows").get<Index>();
  const auto low = cut.at("low").get<std::array<double, 2>>(), high = cut.at("high").get<std::array<double, 2>>();
  auto threads = cut.at("thread_of_cell").get<std::vector<std::int16_t>>();
  if (!(low[0] < high[0] && low[1] < high[1]) || threads.empty() || threads.size() != std::uint64_t{columns} * rows)
    return unfit(report, "the lattice in the report is not valid");
  Tiling tiling;
  tiling.columns = columns;
  tiling.rows = rows;
  tiling.low = {low[0], low[1]};
  tiling.high = {high[0], high[1]};
  tiling.thread_of_cell = std::move(threads);
  for (const nlohmann::json& leaf : cut.value("leaves", nlohmann::json::array())) {
    const auto numbers = leaf.get<std::array<std::uint32_t, 4>>();
    tiling.leaves.push_back({numbers[0], numbers[1], numbers[2], numbers[3]});
  }
  if (!tiling.leaves.empty() && tiling.leaves.size() != tiling.thread_of_cell.size())
    return unfit(report, "the quadtree in the report is not valid");
  return tiling;
}

Result<Tiling> read_tiling(const Mesh& mesh, const std::filesystem::path& report) {
  std::ifstream in(report);
  if (!in) return Error{ErrorKind::io, "cannot read " + report.string()};
  try {
    return tiling_of(nlohmann::json::parse(in), mesh, report);
  } catch (const nlohmann::json::parse_error& error) {
    return unfit(report, fmt::format("invalid JSON at byte {}", error.byte));
  } catch (const nlohmann::json::exception&) {
    return unfit(report, "this is not a report of pardel mesh --json, or one of an earlier version, without a lattice");
  }
}

/// One of twelve hues. The hues of cells that share a side or a corner differ by at least 60 degrees.
std::uint16_t hue_of_tile(const Tiling& tiling, Index cell) {
  // A leaf of a quadtree has its colour's third of the circle of hues, and a part of it that depends on its place.
  if (!tiling.leaves.empty()) {
    const TileLeaf& leaf = tiling.leaves[cell];
    return static_cast<std::uint16_t>((leaf.colour * 60 + (leaf.column + 2 * leaf.row + leaf.level) % 4 * 15) % 360);
  }
  return static_cast<std::uint16_t>((3 * (cell % tiling.columns) + 5 * (cell / tiling.columns)) % 12 * 30);
}

std::uint16_t hue_of_cell(const Tiling& tiling, Index cell, HueBy by) {
  switch (by) {
    case HueBy::tile:
      return hue_of_tile(tiling, cell);
    case HueBy::phase:
      return hue_of_phase(static_cast<int>(tiling.colour_of(cell)));
    case HueBy::thread:
      return tiling.thread_of_cell[cell] < 0 ? no_hue : hue_of_thread(tiling.thread_of_cell[cell]);
  }
  return no_hue;
}

}  // namespace

std::uint16_t hue_of_phase(int phase) { return static_cast<std::uint16_t>((90 * phase + 30) % 360); }

// Steps of the golden angle keep the hues of the first few threads far apart.
std::uint16_t hue_of_thread(int thread) { return static_cast<std::uint16_t>((210 + thread % 360 * 137) % 360); }

Result<std::vector<std::uint16_t>> tile_hues(const Mesh& mesh, const std::filesystem::path& report, HueBy by) {
  const Result<Tiling> tiling = read_tiling(mesh, report);
  if (!tiling) return tiling.error();
  std::vector<std::uint16_t> hues;
  hues.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) hues.push_back(hue_of_cell(*tiling, tiling->cell_of(centroid(mesh, t)), by));
  return hues;
}

}  // namespace pardel::cli
