// Domains: made of arrays, shown as arrays, validated.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <pardel/parallel/validate.hpp>

#include "arrays.hpp"
#include "bind.hpp"
#include "call.hpp"
#include "errors.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

std::vector<Segment> segments_of(const Integers& ends, const std::optional<Markers>& markers) {
  std::vector<Segment> segments;
  segments.reserve(static_cast<std::size_t>(ends.shape(0)));
  for (py::ssize_t k = 0; k < ends.shape(0); ++k)
    segments.push_back({index_of(*ends.data(k, 0)), index_of(*ends.data(k, 1)), markers ? *markers->data(k) : 0});
  return segments;
}

/// Rows of x, y, attribute and area cap. A cap that is not positive means none, as in Triangle's files.
std::vector<Region> regions_of(const Numbers& rows) {
  std::vector<Region> regions;
  for (py::ssize_t k = 0; k < rows.shape(0); ++k) {
    Region region{{*rows.data(k, 0), *rows.data(k, 1)}, *rows.data(k, 2)};
    if (const double cap = *rows.data(k, 3); !(cap <= 0)) region.max_area = cap;
    regions.push_back(region);
  }
  return regions;
}

/// The shapes have been checked.
std::shared_ptr<Pslg> make_domain(const Numbers& points, const Integers& segments,
                                  const std::optional<Markers>& markers, const Numbers& holes, const Numbers& regions,
                                  const std::optional<Markers>& point_markers, const Numbers& attributes) {
  auto domain = std::make_shared<Pslg>();
  domain->points = points_of(points);
  domain->segments = segments_of(segments, markers);
  domain->has_segment_markers = markers.has_value();
  domain->holes = points_of(holes);
  domain->regions = regions_of(regions);
  if (point_markers) domain->point_markers.assign(point_markers->data(), point_markers->data() + point_markers->size());
  domain->attributes_per_point = static_cast<std::size_t>(attributes.shape(1));
  domain->point_attributes.assign(attributes.data(), attributes.data() + attributes.size());
  return domain;
}

py::array regions_as_rows(const Pslg& domain) {
  py::array_t<double> rows({domain.regions.size(), std::size_t{4}});
  double* next = rows.mutable_data();
  for (const Region& region : domain.regions)
    for (const double number : {region.seed.x, region.seed.y, region.attribute, region.max_area}) *next++ = number;
  return rows;
}

const Pslg& domain_of(const py::object& self) { return *self.cast<const Pslg*>(); }

py::array points_view(const std::vector<Point>& points, const py::object& owner) {
  return view(points.empty() ? nullptr : &points.front().x, points.size(), 2, sizeof(Point), owner);
}

py::list problems_of(const Pslg& domain, bool convex_hull, int threads) {
  Call call;
  const std::vector<Problem> problems = call.run([&] {
    return find_problems(domain, {.convex_hull = convex_hull, .threads = threads, .go_on = call.question()});
  });
  py::list list;
  for (const Problem& problem : problems) list.append(to_tuple(problem));
  return list;
}

}  // namespace

void bind_domain(py::module_& module) {
  py::class_<Pslg, std::shared_ptr<Pslg>>(module, "Pslg")
      .def(py::init(&make_domain), py::arg("points"), py::arg("segments"), py::arg("markers").none(true),
           py::arg("holes"), py::arg("regions"), py::arg("point_markers").none(true), py::arg("attributes"))
      .def_property_readonly("points", [](const py::object& self) { return points_view(domain_of(self).points, self); })
      .def_property_readonly("holes", [](const py::object& self) { return points_view(domain_of(self).holes, self); })
      .def_property_readonly("regions", [](const py::object& self) { return regions_as_rows(domain_of(self)); })
      .def_property_readonly("segments",
                             [](const py::object& self) {
                               const std::vector<Segment>& all = domain_of(self).segments;
                               return view(all.empty() ? nullptr : as_signed(&all.front().a), all.size(), 2,
                                           sizeof(Segment), self);
                             })
      .def_property_readonly("markers",
                             [](const py::object& self) {
                               const std::vector<Segment>& all = domain_of(self).segments;
                               return view(all.empty() ? nullptr : &all.front().marker, all.size(), sizeof(Segment),
                                           self);
                             })
      .def_property_readonly("has_markers", [](const Pslg& domain) { return domain.has_segment_markers; })
      .def_property_readonly("point_markers",
                             [](const py::object& self) {
                               const std::vector<int>& all = domain_of(self).point_markers;
                               return view(all.data(), all.size(), sizeof(int), self);
                             })
      .def_property_readonly("attributes",
                             [](const py::object& self) {
                               const Pslg& domain = domain_of(self);
                               const std::size_t columns = domain.attributes_per_point;
                               return view(domain.point_attributes.data(), domain.points.size(), columns,
                                           columns * sizeof(double), self);
                             })
      .def("__eq__", [](const Pslg& a, const Pslg& b) { return a == b; });
  module.def("problems_of", &problems_of, py::arg("domain"), py::arg("convex_hull"), py::arg("threads"));
}

}  // namespace pardel::python
