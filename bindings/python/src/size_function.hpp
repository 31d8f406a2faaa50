// A Python function of the caller as a Goal::size.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <pardel/core/array.hpp>
#include <pardel/core/mesh.hpp>
#include <span>
#include <utility>
#include <vector>

#include "call.hpp"

namespace pardel::python {

/// How a function takes places: as an array of shape (n, 2), returning n lengths or one; or as two numbers x and y.
enum class Takes : bool { arrays, numbers };

/// An exception of the function ends the call (Call::keep_exception). Made and destroyed with the interpreter lock.
class SizeFunction {
 public:
  /// is_asked_by_one_thread: at() is only called by the thread that made the call.
  SizeFunction(pybind11::object function, Takes takes, Call& call, bool is_asked_by_one_thread)
      : function_(std::move(function)), takes_(takes), call_(call), asked_by_one_(is_asked_by_one_thread) {}
  SizeFunction(const SizeFunction&) = delete;
  SizeFunction& operator=(const SizeFunction&) = delete;

  /// Takes the interpreter lock. Thread-safe.
  [[nodiscard]] double at(Point place) const;

  /// For a function of arrays that one thread asks: call expect_announcements(), then announce() with places before
  /// at_announced() is asked about them. announce() calls the function with all of them at once. The values are kept
  /// until places that are announced later take their memory.
  [[nodiscard]] bool wants_announcements() const { return takes_ == Takes::arrays && asked_by_one_; }
  void expect_announcements();
  void announce(std::span<const Point> places);
  [[nodiscard]] double at_announced(Point place);

  /// Calls the function with the centroids of all triangles, where the checker needs its values: so an array function
  /// is called with many places at once. Afterwards at() knows these values. Takes the interpreter lock.
  /// Precondition: corners are in range.
  void evaluate_in_triangles(const Mesh& mesh);

 private:
  struct Known {
    Point place;
    double length;
  };

  [[nodiscard]] static std::size_t place_in_table(Point place);
  void remember(Point place, double length) { announced_[place_in_table(place)] = {place, length}; }
  [[nodiscard]] double call_at(Point place) const;
  [[nodiscard]] double call_with_numbers(Point place) const;
  /// The lengths at the places of an array of shape (n, 2).
  [[nodiscard]] pybind11::array_t<double> call_with_array(const pybind11::array_t<double>& places) const;
  void evaluate(std::span<Known> some) const;

  pybind11::object function_;
  Takes takes_;
  Call& call_;
  bool asked_by_one_;
  Array<Known> known_{};          ///< sorted by place
  std::vector<Known> announced_;  ///< each at its place_in_table(), which others may take
};

}  // namespace pardel::python
