// The mesher: mesh, refine, repair.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <pardel/parallel/mesher.hpp>
#include <pardel/parallel/repair.hpp>
#include <pardel/parallel/report.hpp>

#include "arrays.hpp"
#include "bind.hpp"
#include "call.hpp"
#include "errors.hpp"
#include "goal.hpp"
#include "held_mesh.hpp"
#include "repaired.hpp"
#include "test_function.hpp"
#include "valid_domain.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

using Clock = std::chrono::steady_clock;

/// Arrays, because there can be millions: triangles, reasons, apexes and angles; then the names of the reasons.
py::tuple to_arrays(const std::vector<Exemption>& exempt) {
  const auto count = static_cast<py::ssize_t>(exempt.size());
  py::array_t<std::int32_t> triangles(count), apexes(count);
  py::array_t<std::uint8_t> reasons(count);
  py::array_t<double> angles(count);
  for (py::ssize_t k = 0; k < count; ++k) {
    const Exemption& each = exempt[static_cast<std::size_t>(k)];
    triangles.mutable_at(k) = static_cast<std::int32_t>(each.triangle);
    apexes.mutable_at(k) = static_cast<std::int32_t>(each.apex);  // no_index becomes -1
    reasons.mutable_at(k) = static_cast<std::uint8_t>(each.reason);
    angles.mutable_at(k) = each.angle_deg;
  }
  py::tuple names(exempt_reasons);
  for (std::size_t k = 0; k < exempt_reasons; ++k) names[k] = name(static_cast<ExemptReason>(k));
  return py::make_tuple(triangles, reasons, apexes, angles, names);
}

py::list to_list(const std::vector<Gap>& gaps) {
  py::list list;
  for (const Gap& gap : gaps)
    list.append(py::make_tuple(name(gap.kind), py::tuple(py::cast(gap.points)),
                               gap.segment == no_index ? -1 : std::int64_t{gap.segment}, gap.distance, gap.surroundings,
                               py::make_tuple(gap.where.x, gap.where.y), gap.message()));
  return list;
}

py::dict to_dict(const Report& report, const std::vector<std::string>& repairs, double validate_seconds) {
  py::dict dict;
  dict["goal_met"] = report.goal_met();
  dict["inserted"] = report.inserted;
  dict["segment_splits"] = report.segment_splits;
  dict["refused"] = report.refused;
  dict["laid"] = report.laid;
  dict["restarts"] = report.restarts;
  dict["fail_test"] = report.fail_user_test;
  dict["exempt"] = to_arrays(report.exempt);
  dict["gaps"] = to_list(report.gaps);
  dict["repairs"] = py::tuple(py::cast(repairs));
  dict["validate_seconds"] = validate_seconds;
  dict["triangulate_seconds"] = report.triangulate_seconds;
  dict["refine_seconds"] = report.refine_seconds;
  return dict;
}

/// What mesh_domain() does without the interpreter lock.
struct Made {
  Meshed meshed;
  std::shared_ptr<const Pslg> domain;
  std::vector<std::string> repairs{};
  double validate_seconds = 0;
};

struct Input {
  ValidPslg domain;
  std::vector<std::string> repairs{};
};

/// `lengths`: see repaired_with().
Input valid_input(const Pslg& domain, const Goal& goal, std::vector<double>& lengths,
                  const std::optional<RepairOptions>& how, int threads, Call& call) {
  if (how) {
    const RepairOptions options{.snap = how->snap, .convex_hull = goal.convex_hull, .go_on = call.question()};
    Repaired repaired = value_of(repaired_with(lengths, domain, options));
    return {std::move(repaired.domain), std::move(repaired.log)};
  }
  return {valid_domain(domain, {.convex_hull = goal.convex_hull, .threads = threads, .go_on = call.question()})};
}

/// The functions of the caller, null where there are none.
struct Functions {
  std::unique_ptr<SizeFunction> size;
  std::unique_ptr<TestFunction> test;
};

/// Lets the call stop the run. If the caller has functions, the run has one thread: the others would only wait for the
/// interpreter lock, and the mesh is the same.
Functions prepared(Options& options, const Sizes& sizes, py::object refine_if, Call& call) {
  options.progress = [&call](const Progress& now) { return call.go_on(now); };
  Functions functions{function_of(sizes, call, true), test_of(std::move(refine_if), call, true)};
  if (functions.size || functions.test) options.threads = 1;
  return functions;
}

/// snap: a distance for the repair, or None for its default.
py::tuple mesh_domain(const std::shared_ptr<Pslg>& domain, Goal goal, Options options, Sizes sizes, bool is_repaired,
                      std::optional<double> snap, py::object progress, py::object refine_if) {
  Call call(std::move(progress));
  const Functions functions = prepared(options, sizes, std::move(refine_if), call);
  std::vector<double> none;
  std::vector<double>& at_points = sizes.mesh ? none : sizes.lengths;
  std::optional<RepairOptions> how;
  if (is_repaired) how = RepairOptions{.snap = snap};

  Made made = call.run([&] {
    require(check_goal(goal, options));
    const Clock::time_point start = Clock::now();
    Input input = valid_input(*domain, goal, at_points, how, options.threads, call);
    const std::chrono::duration<double> validation = Clock::now() - start;
    goal.convex_hull = input.domain.convex_hull();
    const Goal complete =
        with_test(with_sizes(goal, sizes, functions.size.get(), &input.domain, options), functions.test.get());
    Meshed meshed = value_of(mesh(input.domain, complete, options));
    auto pslg = std::make_shared<const Pslg>(std::move(input.domain).pslg());
    return Made{std::move(meshed), std::move(pslg), std::move(input.repairs), validation.count()};
  });
  return py::make_tuple(std::make_shared<HeldMesh>(std::move(made.meshed.mesh), made.domain),
                        to_dict(made.meshed.report, made.repairs, made.validate_seconds));
}

py::tuple refine_mesh(const std::shared_ptr<HeldMesh>& coarse, const Numbers& max_areas, Goal goal, Options options,
                      const Sizes& sizes, py::object progress, py::object refine_if) {
  Call call(std::move(progress));
  const Functions functions = prepared(options, sizes, std::move(refine_if), call);
  const Mesh& mesh = coarse->usable();
  const std::span<const double> caps(max_areas.data(), static_cast<std::size_t>(max_areas.size()));
  Meshed made = call.run([&] {
    const Goal complete =
        with_test(with_sizes(goal, sizes, functions.size.get(), nullptr, options), functions.test.get());
    Meshed refined = value_of(refine(mesh, caps, complete, options));
    // They count the segments of the coarse mesh, not those of the domain.
    refined.mesh.origin.clear();
    for (ConstrainedEdge& edge : refined.mesh.constrained_edges) edge.segment = no_index;
    refined.mesh.names = mesh.names;
    return refined;
  });
  return py::make_tuple(std::make_shared<HeldMesh>(std::move(made.mesh), coarse->domain()),
                        to_dict(made.report, {}, 0));
}

py::dict repair_domain(const Pslg& domain, std::optional<double> snap, bool convex_hull) {
  Call call;
  Repaired made = call.run(
      [&] { return value_of(repair(domain, {.snap = snap, .convex_hull = convex_hull, .go_on = call.question()})); });
  py::dict dict;
  dict["log"] = py::tuple(py::cast(made.log));
  dict["snap"] = made.snap;
  dict["moved_points"] = made.moved_points.count;
  dict["bent_segments"] = made.bent_segments.count;
  dict["farthest"] = std::max(made.moved_points.distance, made.bent_segments.distance);
  dict["convex_hull"] = made.domain.convex_hull();
  dict["point_map"] = copy_of(made.point_map);
  dict["segment_map"] = copy_of(made.segment_map);
  dict["domain"] = std::make_shared<Pslg>(std::move(made.domain).pslg());
  return dict;
}

}  // namespace

void bind_mesher(py::module_& module) {
  module.def("mesh", &mesh_domain, py::arg("domain"), py::arg("goal"), py::arg("options"), py::arg("sizes"),
             py::arg("is_repaired"), py::arg("snap").none(true), py::arg("progress"),
             py::arg("refine_if") = py::none());
  module.def("refine", &refine_mesh, py::arg("coarse"), py::arg("max_areas"), py::arg("goal"), py::arg("options"),
             py::arg("sizes"), py::arg("progress"), py::arg("refine_if") = py::none());
  module.def("repair", &repair_domain, py::arg("domain"), py::arg("snap").none(true), py::arg("convex_hull"));
}

}  // namespace pardel::python
