#include "sizes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "../core/support/name_of_triangle.hpp"
#include "../core/support/shortest.hpp"
#include "arithmetic/predicates.hpp"
#include "domain/find_problems.hpp"
#include "mesher.hpp"
#include "planning/mesh_valid.hpp"
#include "planning/region_sizes.hpp"
#include "planning/supervised.hpp"
#include "sizing/graded_size.hpp"
#include "sizing/local_bound.hpp"
#include "sizing/steep_edges.hpp"

namespace pardel {

using namespace engine;

namespace {

std::uint64_t number_of_point(const Pslg& pslg, Index point) { return number_in_file({}, pslg.first_id, point); }
std::uint64_t number_of_point(const Mesh& mesh, Index point) { return number_in_file(mesh, point); }

template <class Points>
Status check_sizes(const Points& of, std::span<const double> sizes) {
  if (sizes.size() != of.points.size())
    return Error{ErrorKind::invalid_input,
                 std::to_string(sizes.size()) + " sizes for " + std::to_string(of.points.size()) + " points"};
  for (std::size_t v = 0; v < sizes.size(); ++v)
    if (!(sizes[v] > 0 && sizes[v] < INFINITY))
      return Error{ErrorKind::invalid_input, "the size at point " +
                                                 std::to_string(number_of_point(of, static_cast<Index>(v))) +
                                                 " must be positive, not " + shortest(sizes[v])};
  return Done{};
}

/// The triangles of a background, counter-clockwise.
Result<std::vector<std::array<Index, 3>>> triangles_of_background(const Mesh& mesh) {
  if (mesh.triangles.empty()) return Error{ErrorKind::invalid_input, "the mesh of the sizes has no triangles"};
  std::vector<std::array<Index, 3>> triangles;
  for (const Triangle& triangle : mesh.triangles) {
    std::array<Index, 3> v = triangle.v;
    const auto fault = [&](const char* what) {
      return Error{
          ErrorKind::invalid_input,
          name_of_triangle(mesh, static_cast<Index>(triangles.size()), " of the mesh of the sizes") + " " + what};
    };
    if (std::ranges::any_of(v, [&](Index i) { return i >= mesh.points.size(); }))
      return fault("has a corner that does not exist");
    const double area = orient2d(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]);
    if (area == 0) return fault("is flat");
    if (area < 0) std::swap(v[0], v[1]);
    triangles.push_back(v);
  }
  return triangles;
}

/// The function that interpolates the sizes at the points of a background.
std::function<double(Point)> size_on(std::span<const Point> points, std::vector<std::array<Index, 3>> triangles,
                                     std::span<const double> sizes, bool limited, std::string name,
                                     const Threads& threads) {
  PointValues field{std::make_shared<Background>(points, std::move(triangles), threads),
                    {sizes.begin(), sizes.end()},
                    limited,
                    std::move(name)};
  return OnBackground<PointValues>{std::make_shared<const PointValues>(std::move(field))};
}

Status check_grading(double grading) {
  if (grading > 0 && grading < INFINITY) return Done{};
  return Error{ErrorKind::usage, "the limit on gradation must be finite and positive, not " + shortest(grading)};
}

/// Precondition: the Pslg is valid and check_sizes() accepts the sizes.
Result<std::function<double(Point)>> interpolate_sizes(const Pslg& pslg, std::span<const double> sizes,
                                                       bool convex_hull, const Options& options,
                                                       ProgressMonitor& progress) {
  const Result<Meshed> meshed = mesh_valid(pslg, convex_hull, nullptr, options, progress);
  if (!meshed) return meshed.error();
  std::vector<std::array<Index, 3>> triangles;
  for (const Triangle& triangle : meshed->mesh.triangles) triangles.push_back(triangle.v);
  return size_on(pslg.points, std::move(triangles), sizes, false, {}, progress.threads());
}

}  // namespace

Result<std::function<double(Point)>> interpolated_size(const ValidPslg& domain, std::span<const double> sizes,
                                                       const Options& options) {
  if (Status fit = check_sizes(domain.pslg(), sizes); !fit) return fit.error();
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) {
    return interpolate_sizes(domain.pslg(), sizes, domain.convex_hull(), safe, progress);
  });
}

Result<std::function<double(Point)>> interpolated_size(const Mesh& background, std::span<const double> sizes,
                                                       const Options& options, std::string name) {
  using Size = Result<std::function<double(Point)>>;
  if (Status fit = check_sizes(background, sizes); !fit) return fit.error();
  return supervised(options, [&](const Options&, ProgressMonitor& progress) -> Size {
    Result<std::vector<std::array<Index, 3>>> triangles = triangles_of_background(background);
    if (!triangles) return triangles.error();
    return size_on(background.points.span(), std::move(*triangles), sizes, true, std::move(name), progress.threads());
  });
}

Result<std::function<double(Point)>> interpolated_size(const Pslg& pslg, std::span<const double> sizes,
                                                       bool convex_hull, const Options& options) {
  if (Status fit = check_sizes(pslg, sizes); !fit) return fit.error();
  using Size = Result<std::function<double(Point)>>;
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) -> Size {
    if (Status valid = check_valid(pslg, convex_hull, progress.threads()); !valid) return valid.error();
    return interpolate_sizes(pslg, sizes, convex_hull, safe, progress);
  });
}

Result<std::vector<SizeSource>> size_sources(const ValidPslg& domain, std::span<const double> sizes, double grading,
                                             const Options& options) {
  using Sources = Result<std::vector<SizeSource>>;
  if (Status fit = check_sizes(domain.pslg(), sizes); !fit) return fit.error();
  if (Status in_range = check_grading(grading); !in_range) return in_range.error();
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) -> Sources {
    const Result<Meshed> meshed = mesh_valid(domain.pslg(), domain.convex_hull(), nullptr, safe, progress);
    if (!meshed) return meshed.error();
    std::vector<std::array<Index, 3>> triangles;
    for (const Triangle& triangle : meshed->mesh.triangles) triangles.push_back(triangle.v);
    return steep_edges(domain.pslg().points, triangles, sizes, grading);
  });
}

Result<std::vector<SizeSource>> size_sources(const Mesh& background, std::span<const double> sizes, double grading) {
  using Sources = Result<std::vector<SizeSource>>;
  if (Status fit = check_sizes(background, sizes); !fit) return fit.error();
  if (Status in_range = check_grading(grading); !in_range) return in_range.error();
  return supervised(Options{}, [&](const Options&, ProgressMonitor&) -> Sources {
    Result<std::vector<std::array<Index, 3>>> triangles = triangles_of_background(background);
    if (!triangles) return triangles.error();
    return steep_edges(background.points.span(), *triangles, sizes, grading);
  });
}

Result<RegionSizes> region_sizes(const ValidPslg& domain, std::span<const double> lengths, const Options& options) {
  const std::size_t regions = domain.pslg().regions.size();
  if (lengths.size() != regions)
    return Error{ErrorKind::invalid_input,
                 std::to_string(lengths.size()) + " lengths for " + std::to_string(regions) + " regions"};
  for (std::size_t r = 0; r < regions; ++r)
    if (!(lengths[r] > 0))
      return Error{ErrorKind::invalid_input, "the length in region " +
                                                 std::to_string(r + domain.pslg().first_id.value) +
                                                 " must be positive, not " + shortest(lengths[r])};
  return supervised(options, [&](const Options&, ProgressMonitor& progress) -> Result<RegionSizes> {
    constexpr std::uint64_t usual = 8, at_least = 1000;
    Options bounded;
    bounded.threads = options.threads;
    bounded.max_vertices = usual * domain.pslg().points.size() + at_least;
    const Goal no_thin_triangles;
    const Result<Meshed> meshed =
        mesh_valid(domain.pslg(), domain.convex_hull(), &no_thin_triangles, bounded, progress);
    if (!meshed) return meshed.error();
    return sizes_of_faces(domain.pslg(), domain.convex_hull(), lengths, meshed->mesh, progress.threads());
  });
}

Result<std::function<double(Point)>> allowed_size(const ValidPslg& domain, const Goal& goal, const Options& options) {
  using Size = Result<std::function<double(Point)>>;
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  if (!is_graded(goal)) return goal.size;
  return supervised(options, [&](const Options&, ProgressMonitor& progress) -> Size {
    return graded_size(goal, domain.pslg(), progress.threads());
  });
}

}  // namespace pardel
