#include "goal_options.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "../core/formats.hpp"
#include "../parallel/mesher.hpp"
#include "read_geojson.hpp"

namespace pardel::cli {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// Converts text to a number; returns NaN if the text is not exactly one number.
double number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? value : std::nan("");
}

/// The smallest angle, in degrees, of a triangle with circumradius = rho * shortest edge. rho_of() is the inverse.
double angle_of(double rho) { return std::asin(1 / (2 * rho)) * degrees; }
double rho_of(double angle_deg) { return 1 / (2 * std::sin(angle_deg / degrees)); }

CLI::Validator angle_bound(double largest) {
  return {[largest](std::string& text) -> std::string {
            const double value = number(text);
            if (value >= 0 && value <= largest) return {};
            constexpr double largest_of_triangle = 45;  // as check_goal() with Options::max_vertices
            const bool is_for_triangle = value > largest && value <= largest_of_triangle;
            return fmt::format("'{}' is not an angle from 0 to {} degrees{}", text, largest,
                               is_for_triangle ? "; 'pardel triangle' tries it" : "");
          },
          ""};
}

CLI::Validator ratio_bound(double largest_angle) {
  // Rounded up: every ratio that is accepted gives an angle within the range.
  const double least = std::ceil(rho_of(largest_angle) * 1000) / 1000;
  return {[least](std::string& text) -> std::string {
            const double value = number(text);
            if (value >= least && std::isfinite(value)) return {};
            return fmt::format("'{}' is not a ratio of {} or more", text, least);
          },
          ""};
}

CLI::Validator within(double low, double high) {
  return {[low, high](std::string& text) -> std::string {
            const double value = number(text);
            if (value >= low && value <= high) return {};
            return value < low ? fmt::format("'{}' is less than {}", text, low)
                               : fmt::format("'{}' is more than {}", text, high);
          },
          ""};
}

}  // namespace

CLI::Validator positive_number(std::string what) {
  return {[what = std::move(what)](std::string& text) -> std::string {
            const double value = number(text);
            if (value > 0 && std::isfinite(value)) return {};
            return fmt::format("'{}' is not {}: a finite number greater than 0", text, what);
          },
          ""};
}

void add_goal_options(CLI::App& app, GoalOptions& options, double largest_angle_deg) {
  constexpr const char* group = "Goal";
  auto* angle =
      app.add_option("--min-angle", options.min_angle_deg,
                     fmt::format("No angle below this (default 20.7; 0: no bound; at most {})", largest_angle_deg))
          ->check(angle_bound(largest_angle_deg))
          ->type_name("DEGREES")
          ->group(group);
  app.add_option("--rho", options.rho,
                 "The bound on angles as a ratio, circumradius / shortest edge (1.4142 is 20.7 degrees)")
      ->check(ratio_bound(largest_angle_deg))
      ->type_name("RATIO")
      ->excludes(angle)
      ->group(group);
  app.add_option("--max-area", options.max_area, "No triangle with a larger area")
      ->check(positive_number("an area"))
      ->type_name("AREA")
      ->group(group);
  app.add_option("--max-edge", options.max_edge, "No edge longer than this")
      ->check(positive_number("a length"))
      ->type_name("LENGTH")
      ->group(group);
  app.add_flag("--regions", options.regions, "Apply the area caps of the regions in IN.poly")->group(group);
  app.add_option("--sizes", options.sizes,
                 "Edge lengths: of points ('n', then 'i length'), a raster (.asc, .npy) or a mesh (.vtu, .msh, .node)")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--feature-size", options.feature_size,
                 "About K edges across narrow places, and in the radius of a polyline's turn")
      ->check(positive_number("a number of edges"))
      ->check(within(0, most_feature_edges))
      ->type_name("K")
      ->group(group);
  auto* grading =
      app.add_option("--grading", options.grading,
                     "Edge lengths grow by at most G per unit of distance, from sizes, segments and narrow places")
          ->check(positive_number("a limit on gradation"))
          ->check(within(least_grading, INFINITY))
          ->type_name("G")
          ->group(group);
  app.add_option("--sources", options.sources,
                 "Edge lengths from which --grading lets lengths grow; each line is 'point X Y LENGTH',\n"
                 "'marker M LENGTH' (segments and points) or 'region R LENGTH' (regions with attribute R);\n"
                 "or a .geojson whose points, lines and polygons have the property 'length'")
      ->type_name("FILE")
      ->needs(grading)
      ->group(group);
  app.add_flag("--conforming", options.conforming, "Make the mesh Delaunay, not only constrained Delaunay")
      ->group(group);
  app.add_flag("--convex-hull", options.convex_hull, "The domain is the convex hull of the points")->group(group);
}

Goal goal_without_sizes(const GoalOptions& options) {
  Goal goal;
  if (options.min_angle_deg) goal.min_angle_deg = *options.min_angle_deg;
  if (options.rho) goal.min_angle_deg = angle_of(*options.rho);
  if (options.max_area) goal.max_area = *options.max_area;
  if (options.max_edge) goal.max_edge = *options.max_edge;
  if (options.grading) goal.grading = *options.grading;
  if (options.feature_size) goal.feature_edges = *options.feature_size;
  goal.region_caps = options.regions;
  goal.conforming = options.conforming;
  goal.convex_hull = options.convex_hull;
  return goal;
}

Result<GivenSizes> read_given_sizes(const GoalOptions& options, CrossingPolygons crossing) {
  GivenSizes given;
  Result<SizeField> field = read_size_field(options.sizes);
  if (!field) return field.error();
  given.field = std::move(*field);
  if (options.sources.empty()) return given;
  if (is_geojson(options.sources)) {
    Result<DrawnLengths> drawn = read_drawn_lengths(options.sources, crossing);
    if (!drawn) return drawn.error();
    given.drawn = std::move(*drawn);
    return given;
  }
  Result<SizeRules> rules = read_size_rules(options.sources);
  if (!rules) return rules.error();
  given.rules = std::move(*rules);
  return given;
}

Result<Goal> make_goal(const GoalOptions& options, const GivenSizes& sizes, const ValidPslg& domain,
                       const NumbersInFile& numbers) {
  Goal goal = goal_without_sizes(options);
  goal.convex_hull = goal.convex_hull && domain.convex_hull();  // a repair may draw the hull as an outline
  Result<std::function<double(Point)>> size = size_function(sizes.field, options.sizes.string(), domain, numbers);
  if (!size) return size.error();
  goal.size = std::move(*size);
  if (!options.grading) return goal;
  Result<std::vector<SizeSource>> sources = sources_of(sizes.field, domain, *options.grading);
  if (!sources) return sources.error();
  goal.sources = std::move(*sources);
  if (Status added = add_rules(sizes.rules, options.sources.string(), domain, goal); !added) return added.error();
  add_lengths(sizes.drawn.size, sizes.drawn.sources, goal);
  return goal;
}

}  // namespace pardel::cli
