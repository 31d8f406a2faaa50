// Readers and writers of what a mesher is given: a domain, caps of areas, a raster.
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "../../core/formats.hpp"
#include "temporary_folder.hpp"
#include "workload.hpp"

namespace pardel::workloads {
namespace {

/// Reads something, of which a right result has this number of items. The result is kept, so that the work does not
/// contain its destruction.
template <class Read, class Count>
Job reading(bool written, const Read& read, const Count& count, std::uint64_t items) {
  const auto result = std::make_shared<std::optional<decltype(read())>>();
  return {.work =
              [=] {
                if (!written) return false;
                result->emplace(read());
                return (*result)->ok() && count(***result) == items;
              },
          .items = items};
}

/// A closed outline with waves.
Pslg outline(const Setup& setup) {
  Pslg pslg;
  const auto n = setup.pick<Index>(8'000, 160'000);
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, radius = 1 + 0.3 * std::sin(7 * angle);
    pslg.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    pslg.segments.push_back({i, (i + 1) % n, 1});
  }
  return pslg;
}

Job write_poly_file(const Setup& setup) {
  const Pslg pslg = outline(setup);
  const auto folder = std::make_shared<TemporaryFolder>();
  return {.work = [=] { return write_poly(pslg, *folder / "d.poly").ok(); }, .items = pslg.points.size()};
}

Job read_poly_file(const Setup& setup) {
  const Pslg pslg = outline(setup);
  const auto folder = std::make_shared<TemporaryFolder>();
  const bool written = write_poly(pslg, *folder / "d.poly").ok();
  return reading(
      written, [=] { return read_pslg(*folder / "d.poly"); },
      [segments = pslg.segments.size()](const Pslg& found) {
        return found.segments.size() == segments ? found.points.size() : 0;
      },
      pslg.points.size());
}

/// Caps whose decimal numbers have all their digits.
std::vector<double> caps(const Setup& setup) {
  std::vector<double> all;
  for (int i = 1; i <= setup.pick(20'000, 400'000); ++i) all.push_back(std::numbers::pi / i);
  return all;
}

Job write_area_file(const Setup& setup) {
  const std::vector<double> all = caps(setup);
  const auto folder = std::make_shared<TemporaryFolder>();
  return {.work = [=] { return write_area(*folder / "m.area", all).ok(); }, .items = all.size()};
}

Job read_area_file(const Setup& setup) {
  const std::vector<double> all = caps(setup);
  const auto folder = std::make_shared<TemporaryFolder>();
  const bool written = write_area(*folder / "m.area", all).ok();
  return reading(
      written, [=] { return read_area(*folder / "m.area"); },
      [](const std::vector<double>& found) { return found.size(); }, all.size());
}

/// A hill, as heights with three digits after the point.
bool write_raster(const std::filesystem::path& file, int side) {
  std::ofstream out(file);
  out << "NCOLS " << side << "\nNROWS " << side << "\nXLLCORNER 0\nYLLCORNER 0\nCELLSIZE 1\n";
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double x = 2.0 * column / side - 1, y = 2.0 * row / side - 1;
      out << std::round(1e6 * std::exp(-x * x - y * y)) / 1e3 << (column + 1 < side ? ' ' : '\n');
    }
  return static_cast<bool>(out.flush());
}

Job read_asc_file(const Setup& setup) {
  const int side = setup.pick(200, 1000);
  const auto folder = std::make_shared<TemporaryFolder>();
  const bool written = write_raster(*folder / "r.asc", side);
  return reading(
      written, [=] { return read_raster(*folder / "r.asc"); }, [](const Raster& found) { return found.values.size(); },
      static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side));
}

constexpr Workload list[] = {
    {"write_poly", false, false, write_poly_file}, {"read_poly", false, false, read_poly_file},
    {"write_area", false, false, write_area_file}, {"read_area", false, false, read_area_file},
    {"read_asc", false, false, read_asc_file},
};

}  // namespace

std::span<const Workload> of_input_files() { return list; }

}  // namespace pardel::workloads
