// The command line options that define a Goal. The command `mesh` refines until the goal is met; `check` verifies it.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <filesystem>
#include <optional>

#include "../core/goal.hpp"
#include "../core/result.hpp"
#include "../parallel/validate.hpp"
#include "drawn_lengths.hpp"
#include "size_field.hpp"
#include "size_rules.hpp"

namespace pardel::cli {

struct GoalOptions {
  std::optional<double> min_angle_deg;
  std::optional<double> rho;  ///< ratio of circumradius to shortest edge, which implies an angle bound
  std::optional<double> max_area;
  std::optional<double> max_edge;
  bool regions = false;
  std::filesystem::path sizes;    ///< the file of sizes; empty: none
  std::filesystem::path sources;  ///< the file of places with sizes; empty: none
  std::optional<double> grading;
  std::optional<double> feature_size;
  bool conforming = false;
  bool convex_hull = false;
};

/// In degrees. Every triangle has an angle of at most 60 degrees, so no mesh has a larger smallest angle.
inline constexpr double largest_angle_to_check = 60;

/// Adds the options to the command. --min-angle accepts 0 to largest_angle_deg degrees.
void add_goal_options(CLI::App& app, GoalOptions& options, double largest_angle_deg);

/// Accepts finite numbers greater than zero. `what` names the quantity in the message: "an area".
[[nodiscard]] CLI::Validator positive_number(std::string what);

/// The goal without the size function.
[[nodiscard]] Goal goal_without_sizes(const GoalOptions& options);

/// What the files of options.sizes and options.sources have.
struct GivenSizes {
  SizeField field;
  SizeRules rules;
  DrawnLengths drawn{};  ///< instead of rules, if the file is GeoJSON
};
[[nodiscard]] Result<GivenSizes> read_given_sizes(const GoalOptions& options, CrossingPolygons crossing);

/// The goal. `sizes`: what read_given_sizes() returned. `numbers`: of the points, for messages, as Mesh::numbers.
[[nodiscard]] Result<Goal> make_goal(const GoalOptions& options, const GivenSizes& sizes, const ValidPslg& domain,
                                     const NumbersInFile& numbers = {});

}  // namespace pardel::cli
