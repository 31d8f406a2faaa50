#include "size_function.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "../../../core/support/point_order.hpp"
#include "arrays.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

constexpr std::size_t places_at_once = 65'536;
constexpr int table_bits = 16;

/// As the checker computes it (properties/checker/check.hpp).
Point centroid(const Mesh& mesh, const Triangle& triangle) {
  const Point a = mesh.points[triangle.v[0]], b = mesh.points[triangle.v[1]], c = mesh.points[triangle.v[2]];
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}

/// "size returned 'long', a str; it must return " and what is needed.
std::string wrong_type(const py::object& returned, const char* needed) {
  constexpr std::size_t longest = 60;
  std::string text = py::repr(returned);
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  if (!returned.is_none()) text += ", a " + std::string(py::str(py::type::of(returned).attr("__name__")));
  return "size returned " + text + "; it must return " + needed;
}

double number_of(const py::object& value) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (number != -1 || PyErr_Occurred() == nullptr) return number;
  py::error_already_set thrown;
  if (thrown.matches(PyExc_TypeError)) {
    py::raise_from(thrown, PyExc_TypeError, wrong_type(value, "a number greater than 0").c_str());
    throw py::error_already_set();
  }
  throw thrown;
}

/// Text is no number, although NumPy would read it; nor are complex numbers, or dates.
bool may_be_numbers(const py::array& array) { return std::strchr("biufO", array.dtype().kind()) != nullptr; }

/// The numbers that a function of arrays returned.
Numbers numbers_in(const py::object& returned) {
  const auto array = py::array::ensure(returned);  // clears the error
  if (array && !returned.is_none() && may_be_numbers(array))
    if (auto numbers = Numbers::ensure(array)) return numbers;
  throw py::type_error(wrong_type(returned, "numbers greater than 0, one per place"));
}

}  // namespace

std::size_t SizeFunction::place_in_table(Point place) {
  const auto x = std::bit_cast<std::uint64_t>(place.x), y = std::bit_cast<std::uint64_t>(place.y);
  return ((x * 0x9e3779b97f4a7c15 ^ y) * 0xd6e8feb86659fd93) >> (64 - table_bits);
}

void SizeFunction::expect_announcements() { announced_.resize(std::size_t{1} << table_bits, {{NAN, NAN}, NAN}); }

void SizeFunction::announce(std::span<const Point> places) {
  call_.hold_lock();
  try {
    py::array_t<double> array({static_cast<py::ssize_t>(places.size()), py::ssize_t{2}});
    double* row = array.mutable_data();
    for (const Point place : places) {
      *row++ = place.x;
      *row++ = place.y;
    }
    const py::array_t<double> lengths = call_with_array(array);
    for (std::size_t k = 0; k < places.size(); ++k) remember(places[k], lengths.data()[k]);
  } catch (...) {
    throw call_.keep_exception();
  }
}

double SizeFunction::at(Point place) const {
  const auto known = std::lower_bound(known_.begin(), known_.end(), place,
                                      [](const Known& each, Point p) { return lexicographically_less(each.place, p); });
  if (known != known_.end() && known->place == place) return known->length;
  if (asked_by_one_) {
    call_.hold_lock();
    return call_at(place);
  }
  const py::gil_scoped_acquire acquired;
  return call_at(place);
}

double SizeFunction::at_announced(Point place) {
  const Known& here = announced_[place_in_table(place)];
  if (here.place == place) return here.length;
  const double length = at(place);
  remember(place, length);
  return length;
}

double SizeFunction::call_at(Point place) const {
  try {
    if (takes_ == Takes::numbers) return call_with_numbers(place);
    py::array_t<double> places({1, 2});
    *places.mutable_data(0, 0) = place.x;
    *places.mutable_data(0, 1) = place.y;
    return *call_with_array(places).data(0);
  } catch (...) {
    throw call_.keep_exception();
  }
}

double SizeFunction::call_with_numbers(Point place) const { return number_of(function_(place.x, place.y)); }

py::array_t<double> SizeFunction::call_with_array(const py::array_t<double>& places) const {
  const py::ssize_t count = places.shape(0);
  const py::object returned = function_(places);
  py::array_t<double> lengths(count);
  if (PyFloat_Check(returned.ptr())) {
    std::fill_n(lengths.mutable_data(), count, number_of(returned));
    return lengths;
  }
  const auto given = numbers_in(returned);
  if (given.ndim() == 0)
    std::fill_n(lengths.mutable_data(), count, *given.data());
  else if (given.ndim() == 1 && given.shape(0) == count)
    return given;
  else
    throw py::value_error("size returned an array of shape " + std::string(py::str(given.attr("shape"))) + " for " +
                          std::to_string(count) + (count == 1 ? " place" : " places") +
                          "; it must return one length per place");
  return lengths;
}

void SizeFunction::evaluate(std::span<Known> some) const {
  if (takes_ == Takes::numbers) {
    for (Known& each : some) each.length = call_with_numbers(each.place);
    return;
  }
  py::array_t<double> places({static_cast<py::ssize_t>(some.size()), py::ssize_t{2}});
  for (std::size_t k = 0; k < some.size(); ++k) {
    places.mutable_data()[2 * k] = some[k].place.x;
    places.mutable_data()[2 * k + 1] = some[k].place.y;
  }
  const py::array_t<double> lengths = call_with_array(places);
  for (std::size_t k = 0; k < some.size(); ++k) some[k].length = lengths.data()[k];
}

void SizeFunction::evaluate_in_triangles(const Mesh& mesh) {
  Array<Known> known;
  known.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles)
    if (const Point place = centroid(mesh, triangle); place == place) known.push_back({place, 0});
  std::sort(known.begin(), known.end(),
            [](const Known& a, const Known& b) { return lexicographically_less(a.place, b.place); });
  for (std::size_t first = 0; first < known.size() && call_.go_on(); first += places_at_once) {
    const py::gil_scoped_acquire acquired;
    try {
      evaluate(known.span().subspan(first, std::min(places_at_once, known.size() - first)));
    } catch (...) {
      throw call_.keep_exception();
    }
  }
  known_ = std::move(known);
}

}  // namespace pardel::python
