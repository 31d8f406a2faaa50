#include "colouring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "../../core/formats.hpp"
#include "../length.hpp"
#include "../tile_hues.hpp"

namespace pardel::cli {
namespace {

/// The lengths of the sides, in ascending order.
std::array<double, 3> sides(const Mesh& mesh, const Triangle& t) {
  const Point a = mesh.points[t.v[0]], b = mesh.points[t.v[1]], c = mesh.points[t.v[2]];
  std::array<double, 3> sorted{length(a, b), length(b, c), length(c, a)};
  std::ranges::sort(sorted);
  return sorted;
}

/// In degrees, by the law of cosines.
double smallest_angle(const Mesh& mesh, const Triangle& t) {
  const auto [a, b, c] = sides(mesh, t);
  const double cosine = ((b - a) * (b + a) + c * c) / (2 * b * c);
  return b > 0 ? std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi : 0;
}

std::uint16_t band(double value, std::size_t bands) {
  return static_cast<std::uint16_t>(std::clamp(value, 0.0, static_cast<double>(bands - 1)));
}

Colouring by_quality(const Mesh& mesh) {
  constexpr std::size_t bands = 12;
  constexpr double width = 60.0 / bands;
  Colouring result{bad_to_good(bands), {}, {"smallest angle", bad_to_good(bands), {}}};
  for (const Triangle& t : mesh.triangles) result.colour_of.push_back(band(smallest_angle(mesh, t) / width, bands));
  for (std::size_t i = 0; i <= bands; ++i)
    result.legend.labels.push_back(i % 2 == 0 ? fmt::format("{:g}°", width * static_cast<double>(i)) : "");
  return result;
}

/// Bands of equal width on a logarithmic scale.
Colouring by_size(const Mesh& mesh) {
  constexpr std::size_t bands = 16;
  Colouring result{small_to_large(bands), {}, {"longest edge", small_to_large(bands), {}}};
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Triangle& t : mesh.triangles) {
    const double size = sides(mesh, t)[2];
    low = std::min(low, size);
    high = std::max(high, size);
  }
  const bool usable = low > 0 && low <= high;
  const double first = usable ? std::log(low) : 0, width = usable ? std::max(std::log(high / low), 1e-9) / bands : 1;
  for (const Triangle& t : mesh.triangles)
    result.colour_of.push_back(band((std::log(sides(mesh, t)[2]) - first) / width, bands));
  for (std::size_t i = 0; i <= bands; ++i)
    result.legend.labels.push_back(i % 4 == 0 ? fmt::format("{:.3g}", std::exp(first + width * static_cast<double>(i)))
                                              : "");
  return result;
}

Colouring by_region(const Mesh& mesh) {
  // Hues of consecutive regions differ by the golden angle, so they are easy to distinguish.
  const auto hue = [](std::size_t i) { return static_cast<std::uint16_t>((210 + i % 360 * 137) % 360); };
  const std::size_t most_colours = std::min<std::size_t>(mesh.region_attributes.size(), 1000);
  Colouring result{{light(hue(0))}, std::vector<std::uint16_t>(mesh.triangles.size(), 0), {}};
  for (std::size_t i = 0; i < most_colours; ++i) result.palette.push_back(light(hue(i + 1)));
  if (most_colours == 0) return result;
  for (std::size_t t = 0; t < mesh.region.size(); ++t)
    if (mesh.region[t] != no_index) result.colour_of[t] = static_cast<std::uint16_t>(mesh.region[t] % most_colours + 1);
  result.legend.title = "region";
  result.legend.colours = result.palette;
  result.legend.labels = {"none"};
  for (const double attribute : mesh.region_attributes) result.legend.labels.push_back(fmt::format("{:g}", attribute));
  result.legend.labels.resize(result.palette.size());
  if (std::ranges::find(result.colour_of, 0) != result.colour_of.end()) return result;
  result.legend.colours.erase(result.legend.colours.begin());
  result.legend.labels.erase(result.legend.labels.begin());
  return result;
}

/// The colours of phases or threads. There is no legend for tiles, because their colours repeat.
Legend legend_of_work(const std::map<std::uint16_t, std::uint16_t>& hues, HueBy by) {
  Legend legend;
  if (by == HueBy::tile) return legend;
  legend.title = by == HueBy::phase ? "phase" : "thread";
  for (int n = 0; n < 360; ++n) {
    const std::uint16_t hue = by == HueBy::phase ? hue_of_phase(n) : hue_of_thread(n);
    if (!hues.contains(hue) || (by == HueBy::phase && n > 3)) continue;
    legend.colours.push_back(light(hue));
    legend.labels.push_back(fmt::format("{}", by == HueBy::phase ? n + 1 : n));
  }
  return legend;
}

Result<Colouring> by_work(const Mesh& mesh, HueBy by, const std::filesystem::path& report) {
  const Result<std::vector<std::uint16_t>> hues = tile_hues(mesh, report, by);
  if (!hues) return hues.error();
  Colouring result;
  std::map<std::uint16_t, std::uint16_t> index;  // of a hue in the palette
  for (const std::uint16_t hue : *hues) {
    const auto [place, added] = index.try_emplace(hue, static_cast<std::uint16_t>(index.size()));
    if (added) result.palette.push_back(hue == no_hue ? white : light(hue));
    result.colour_of.push_back(place->second);
  }
  result.legend = legend_of_work(index, by);
  return result;
}

}  // namespace

Result<Colouring> colouring(const Mesh& mesh, ColourBy by, const std::filesystem::path& report) {
  switch (by) {
    case ColourBy::quality:
      return by_quality(mesh);
    case ColourBy::size:
      return by_size(mesh);
    case ColourBy::region:
      return by_region(mesh);
    case ColourBy::tile:
      return by_work(mesh, HueBy::tile, report);
    case ColourBy::phase:
      return by_work(mesh, HueBy::phase, report);
    case ColourBy::thread:
      return by_work(mesh, HueBy::thread, report);
  }
  return Colouring{};
}

}  // namespace pardel::cli
