#include "goal.hpp"

#include <cmath>
#include <pardel/parallel/sizes.hpp>

#include "arrays.hpp"
#include "bind.hpp"
#include "errors.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

std::vector<double> lengths_of(const Numbers& numbers) { return {numbers.data(), numbers.data() + numbers.size()}; }

template <class Enumerator>
Enumerator choice(const std::string& word, std::initializer_list<std::pair<const char*, Enumerator>> words,
                  const char* option) {
  std::string all;
  for (const auto& [name, value] : words) {
    if (word == name) return value;
    all += (all.empty() ? "" : ", ") + std::string(name);
  }
  throw Failure{{ErrorKind::usage, std::string(option) + " is '" + word + "'; it must be one of " + all}};
}

void set_placement(Options& options, const std::string& word) {
  options.placement = choice<Placement>(word,
                                        {{"circumcentre", Placement::circumcentre},
                                         {"off_centre", Placement::off_centre},
                                         {"search", Placement::search},
                                         {"automatic", Placement::automatic}},
                                        "placement");
}

void set_interior(Options& options, const std::string& word) {
  options.interior = choice<Interior>(
      word, {{"refine", Interior::refine}, {"fill", Interior::fill}, {"automatic", Interior::automatic}}, "interior");
}

}  // namespace

std::unique_ptr<SizeFunction> function_of(const Sizes& sizes, Call& call, bool is_asked_by_one_thread) {
  if (!sizes.function) return nullptr;
  return std::make_unique<SizeFunction>(sizes.function, sizes.takes, call, is_asked_by_one_thread);
}

Goal with_sizes(Goal goal, const Sizes& sizes, SizeFunction* function, const ValidPslg* domain,
                const Options& options) {
  const bool limits_gradation = std::isfinite(goal.grading);
  if (function != nullptr) {
    if (function->wants_announcements()) {
      function->expect_announcements();
      goal.before_sizes = [function](std::span<const Point> places) { function->announce(places); };
      goal.size = [function](Point place) { return function->at_announced(place); };
    } else {
      goal.size = [function](Point place) { return function->at(place); };
    }
  } else if (sizes.mesh) {
    const Mesh& mesh = sizes.mesh->usable();
    goal.size = value_of(interpolated_size(mesh, sizes.lengths, options));
    if (limits_gradation) goal.sources = value_of(size_sources(mesh, sizes.lengths, goal.grading));
  } else if (sizes.raster) {
    goal.size = value_of(interpolated_size(*sizes.raster, "the raster of the sizes"));
    if (limits_gradation) goal.sources = value_of(size_sources(*sizes.raster, goal.grading));
  } else if (!sizes.lengths.empty() && domain != nullptr) {
    goal.size = value_of(interpolated_size(*domain, sizes.lengths, options));
    if (limits_gradation) goal.sources = value_of(size_sources(*domain, sizes.lengths, goal.grading, options));
  }
  if (sizes.places && domain != nullptr) add_places(*sizes.places, *domain, goal);
  return goal;
}

void bind_goal(py::module_& module) {
  py::class_<Goal>(module, "Goal")
      .def(py::init<>())
      .def_readwrite("min_angle", &Goal::min_angle_deg)
      .def_readwrite("max_area", &Goal::max_area)
      .def_readwrite("max_edge", &Goal::max_edge)
      .def_readwrite("region_caps", &Goal::region_caps)
      .def_readwrite("grading", &Goal::grading)
      .def_readwrite("feature_edges", &Goal::feature_edges)
      .def_readwrite("conforming", &Goal::conforming)
      .def_readwrite("convex_hull", &Goal::convex_hull);
  py::class_<Options>(module, "Options")
      .def(py::init<>())
      .def_readwrite("threads", &Options::threads)
      .def_readwrite("max_vertices", &Options::max_vertices)
      .def_readwrite("max_memory", &Options::max_memory)
      .def_readwrite("min_edge", &Options::min_edge)
      .def_readwrite("no_boundary_splits", &Options::no_boundary_splits)
      .def_readwrite("no_segment_splits", &Options::no_segment_splits)
      .def("set_placement", &set_placement, py::arg("word"))
      .def("set_interior", &set_interior, py::arg("word"));
  py::class_<Sizes>(module, "Sizes")
      .def(py::init<>())
      .def_static(
          "at_points", [](const Numbers& lengths) { return Sizes{lengths_of(lengths)}; }, py::arg("lengths"))
      .def_static(
          "on_mesh",
          [](const std::shared_ptr<HeldMesh>& mesh, const Numbers& lengths) {
            return Sizes{lengths_of(lengths), mesh};
          },
          py::arg("mesh"), py::arg("lengths"))
      .def_static(
          "of_function",
          [](py::object function, bool takes_numbers) {
            return Sizes{{}, {}, std::move(function), takes_numbers ? Takes::numbers : Takes::arrays};
          },
          py::arg("function"), py::arg("takes_numbers"))
      .def_static(
          "on_raster", [](const std::shared_ptr<Raster>& raster) { return Sizes{.raster = raster}; }, py::arg("raster"))
      .def(
          "set_places", [](Sizes& sizes, const std::shared_ptr<Places>& places) { sizes.places = places; },
          py::arg("places"));
}

}  // namespace pardel::python
