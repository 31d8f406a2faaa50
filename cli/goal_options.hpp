// The options that say what a mesh has to satisfy: `mesh` aims at them, `check` judges by them.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <filesystem>
#include <optional>

#include "../core/goal.hpp"
#include "../core/result.hpp"

namespace pardel::cli {

struct GoalOptions {
  std::optional<double> min_angle_deg;
  std::optional<double> rho;  ///< circumradius-to-shortest-edge ratio: another way to give the angle
  std::optional<double> max_area;
  std::optional<double> max_edge;
  bool regions = false;
  std::filesystem::path sizes;  ///< empty: none
  bool conforming = false;
  bool convex_hull = false;
};

/// Largest angle bound that a mesher is asked for, and that a triangulation can have.
inline constexpr double largest_angle_to_mesh = 33;
inline constexpr double largest_angle_to_check = 60;

void add_goal_options(CLI::App& app, GoalOptions& options, double largest_angle_deg);

/// Accepts finite numbers greater than zero; the message names `what`.
[[nodiscard]] CLI::Validator positive_number(std::string what);

/// Reads the file of sizes, where one is given; the sizes belong to the points of `pslg`.
[[nodiscard]] Result<Goal> make_goal(const GoalOptions& options, const Pslg& pslg);

}  // namespace pardel::cli
