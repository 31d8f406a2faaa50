// The checker.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <pardel/properties/checker/check.hpp>

#include "bind.hpp"
#include "call.hpp"
#include "errors.hpp"
#include "goal.hpp"
#include "held_mesh.hpp"
#include "test_function.hpp"
#include "valid_domain.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

py::tuple coordinates(Point p) { return py::make_tuple(p.x, p.y); }

py::list to_list(const std::vector<Violation>& violations) {
  py::list list;
  for (const Violation& violation : violations) {
    py::list places;
    for (const Point p : violation.where) places.append(coordinates(p));
    list.append(py::make_tuple(name(violation.kind), py::tuple(py::cast(violation.ids)), py::tuple(places),
                               violation.message()));
  }
  return list;
}

py::dict counts_by_kind(const std::vector<std::uint64_t>& counts) {
  py::dict dict;
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (counts[k] > 0) dict[name(static_cast<ViolationKind>(k))] = counts[k];
  return dict;
}

py::dict extremes(const Certificate& certificate) {
  py::dict dict;
  const auto add = [&](const char* name, const Extreme& extreme) {
    if (extreme.triangle == no_index) return;
    dict[name] = py::make_tuple(extreme.value, extreme.triangle, coordinates(extreme.where));
  };
  add("min_angle", certificate.min_angle_deg);
  add("max_angle", certificate.max_angle_deg);
  add("max_area", certificate.max_area);
  add("max_edge", certificate.max_edge);
  add("min_edge", certificate.min_edge);
  add("max_circumradius", certificate.max_circumradius);
  add("max_radius_edge_ratio", certificate.max_radius_edge_ratio);
  return dict;
}

py::dict to_dict(const Certificate& certificate) {
  py::dict dict;
  dict["valid"] = certificate.valid;
  dict["violations"] = to_list(certificate.violations);
  dict["violation_counts"] = counts_by_kind(certificate.violation_counts);
  dict["not_checked"] = py::tuple(py::cast(certificate.not_checked));
  dict["extremes"] = extremes(certificate);
  dict["vertices"] = certificate.vertices;
  dict["triangles"] = certificate.triangles;
  dict["constrained_edges"] = certificate.constrained_edges;
  dict["area"] = certificate.area;
  dict["justified"] = certificate.justified.size();
  dict["equilateral"] = certificate.equilateral;
  dict["decided_exactly"] = certificate.decided_exactly;
  dict["angle_histogram"] = py::tuple(py::cast(certificate.angle_histogram));
  dict["digest"] = to_string(certificate.digest);
  dict["text"] = to_text(certificate);
  return dict;
}

py::dict check_mesh(const Pslg& domain, const HeldMesh& held, const Goal& goal, const Sizes& sizes,
                    double max_circumradius, std::size_t max_violations, py::object refine_if) {
  Call call;
  const std::unique_ptr<SizeFunction> function = function_of(sizes, call, false);
  const std::unique_ptr<TestFunction> test = test_of(std::move(refine_if), call, false);
  const Certificate certificate = call.run([&] {
    // The domain with the sizes at its points has to be triangulated. One that is not valid says nothing about a mesh.
    const ValidPslg valid = valid_domain(domain, {.convex_hull = goal.convex_hull, .go_on = call.question()});
    if (function && has_indices_in_range(held.any())) function->evaluate_in_triangles(held.any());
    const Goal complete = with_test(with_sizes(goal, sizes, function.get(), &valid, {}), test.get());
    const bool is_own = held.domain() != nullptr && !held.any().origin.empty() && *held.domain() == domain;
    const CheckOptions options{.max_violations = max_violations,
                               .max_circumradius = max_circumradius,
                               .foreign = !is_own,
                               .go_on = call.question()};
    if (is_own || held.any().origin.empty()) return check(domain, held.any(), complete, options);
    Mesh of_another_domain = held.any();
    of_another_domain.origin.clear();
    for (ConstrainedEdge& edge : of_another_domain.constrained_edges) edge.segment = no_index;
    return check(domain, of_another_domain, complete, options);
  });
  return to_dict(certificate);
}

}  // namespace

void bind_checker(py::module_& module) {
  module.def("check", &check_mesh, py::arg("domain"), py::arg("mesh"), py::arg("goal"), py::arg("sizes"),
             py::arg("max_circumradius"), py::arg("max_violations"), py::arg("refine_if") = py::none());
}

}  // namespace pardel::python
