// Rasters and places with edge lengths as plain values, for pickling. The first value of a state is the number of its
// form: a later form gets another number, and this one is still read.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <pardel/core/raster.hpp>

#include "places.hpp"

namespace pardel::python {

[[nodiscard]] pybind11::tuple state_of_raster(const Raster& raster);
[[nodiscard]] pybind11::tuple state_of_places(const Places& places);

/// What has the state. Throw a Failure (`usage`) for a form that this version does not know.
[[nodiscard]] std::shared_ptr<Raster> raster_of_state(const pybind11::tuple& state);
[[nodiscard]] std::shared_ptr<Places> places_of_state(const pybind11::tuple& state);

}  // namespace pardel::python
