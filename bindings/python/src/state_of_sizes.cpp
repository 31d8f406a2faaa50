#include "state_of_sizes.hpp"

#include <pybind11/stl.h>

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "arrays.hpp"
#include "call.hpp"
#include "errors.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

constexpr int form = 1;

void check_form(const py::tuple& state, const char* what) {
  if (const int found = state[0].cast<int>(); found != form)
    throw Failure{{ErrorKind::usage, std::string(what) + " was pickled by a later version of pardel, in form " +
                                         std::to_string(found) + "; this one reads form " + std::to_string(form)}};
}

/// The rows of a list of plain values, each of which consists of doubles.
template <class Row>
py::array_t<double> rows_of(const std::vector<Row>& rows) {
  static_assert(std::is_trivially_copyable_v<Row> && sizeof(Row) % sizeof(double) == 0);
  constexpr std::size_t columns = sizeof(Row) / sizeof(double);
  py::array_t<double> array({static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(columns)});
  if (!rows.empty()) std::memcpy(array.mutable_data(), rows.data(), rows.size() * sizeof(Row));
  return array;
}

template <class Row>
std::vector<Row> rows_in(const py::handle& array) {
  const auto numbers = array.cast<Numbers>();
  std::vector<Row> rows(static_cast<std::size_t>(numbers.nbytes()) / sizeof(Row));
  if (!rows.empty()) std::memcpy(static_cast<void*>(rows.data()), numbers.data(), rows.size() * sizeof(Row));
  return rows;
}

using OnMarkers = std::vector<std::tuple<int, double, std::size_t>>;
using InRegions = std::vector<std::tuple<double, double, std::size_t>>;

py::list to_list(const std::vector<cli::DrawnPolygon>& polygons) {
  py::list list;
  for (const cli::DrawnPolygon& polygon : polygons) {
    py::list rings;
    for (const std::vector<Point>& ring : polygon.rings) rings.append(rows_of(ring));
    list.append(py::make_tuple(*polygon.length, rings));
  }
  return list;
}

std::vector<cli::DrawnPolygon> polygons_in(const py::handle& list) {
  std::vector<cli::DrawnPolygon> polygons;
  for (const py::handle item : list) {
    const auto row = item.cast<py::tuple>();
    polygons.emplace_back().length = row[0].cast<double>();
    for (const py::handle ring : row[1]) polygons.back().rings.push_back(rows_in<Point>(ring));
  }
  return polygons;
}

}  // namespace

py::tuple state_of_raster(const Raster& raster) {
  return py::make_tuple(form, raster.columns, raster.rows, raster.first.x, raster.first.y, raster.step_x, raster.step_y,
                        rows_of(raster.values));
}

std::shared_ptr<Raster> raster_of_state(const py::tuple& state) {
  check_form(state, "the raster");
  return std::make_shared<Raster>(Raster{state[1].cast<Index>(),
                                         state[2].cast<Index>(),
                                         {state[3].cast<double>(), state[4].cast<double>()},
                                         state[5].cast<double>(),
                                         state[6].cast<double>(),
                                         rows_in<double>(state[7])});
}

py::tuple state_of_places(const Places& places) {
  OnMarkers markers;
  for (const SizeRules::OnMarker& rule : places.rules.markers)
    markers.emplace_back(rule.marker, rule.length, rule.line);
  InRegions regions;
  for (const SizeRules::InRegion& rule : places.rules.regions)
    regions.emplace_back(rule.attribute, rule.length, rule.line);
  return py::make_tuple(form, places.name, rows_of(places.rules.points), markers, regions,
                        rows_of(places.drawn.sources), to_list(places.polygons));
}

std::shared_ptr<Places> places_of_state(const py::tuple& state) {
  check_form(state, "the sources");
  Places places{.name = state[1].cast<std::string>()};
  std::vector<SizeSource> sources = rows_in<SizeSource>(state[5]);
  if (std::vector<cli::DrawnPolygon> polygons = polygons_in(state[6]); polygons.empty())
    places.drawn.sources = std::move(sources);
  else
    places = Call().run([&] { return places_of(std::move(polygons), std::move(sources), places.name); });
  places.rules.points = rows_in<SizeRules::AtPoint>(state[2]);
  for (const auto& [marker, length, line] : state[3].cast<OnMarkers>())
    places.rules.markers.push_back({marker, length, line});
  for (const auto& [attribute, length, line] : state[4].cast<InRegions>())
    places.rules.regions.push_back({attribute, length, line});
  return std::make_shared<Places>(std::move(places));
}

}  // namespace pardel::python
