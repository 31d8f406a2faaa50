// NumPy arrays into arrays of the library, and back.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <pardel/core/pslg.hpp>
#include <span>
#include <vector>

namespace pardel::python {

/// Coordinates and other real numbers, row by row. Another layout or type of numbers is converted first.
using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;
using Integers = pybind11::array_t<std::int64_t, pybind11::array::c_style | pybind11::array::forcecast>;
using Markers = pybind11::array_t<std::int32_t, pybind11::array::c_style | pybind11::array::forcecast>;

/// Copies the rows of an array of shape (n, 2).
void copy_points(const Numbers& from, Point* to);
[[nodiscard]] std::vector<Point> points_of(const Numbers& numbers);

/// no_index for a number that is no Index.
[[nodiscard]] constexpr Index index_of(std::int64_t number) {
  return number < 0 || number >= std::int64_t{no_index} ? no_index : static_cast<Index>(number);
}

/// A read-only NumPy array on memory of the library, which `owner` keeps alive: no copy. `step`: the bytes from row
/// to row, which is more than a row has if the memory is a part of larger records.
template <class T>
pybind11::array view(const T* first, std::size_t rows, std::size_t columns, std::size_t step,
                     const pybind11::object& owner) {
  namespace py = pybind11;
  static const T none{};
  py::array array(py::dtype::of<T>(), {rows, columns}, {step, sizeof(T)}, first == nullptr ? &none : first, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}
template <class T>
pybind11::array view(const T* first, std::size_t rows, std::size_t step, const pybind11::object& owner) {
  namespace py = pybind11;
  static const T none{};
  py::array array(py::dtype::of<T>(), {rows}, {step}, first == nullptr ? &none : first, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// Indices as NumPy's users expect them: int32, with -1 for none. The bytes of an Index are the same.
[[nodiscard]] inline const std::int32_t* as_signed(const Index* first) {
  return reinterpret_cast<const std::int32_t*>(first);
}
[[nodiscard]] inline pybind11::array_t<std::int32_t> copy_of(std::span<const Index> indices) {
  return pybind11::array_t<std::int32_t>(static_cast<pybind11::ssize_t>(indices.size()), as_signed(indices.data()));
}

}  // namespace pardel::python
