// Triangle's command line: letters without spaces, each followed by its number, such as -pq30a0.1D.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "../core/result.hpp"

namespace pardel::cli {

/// The switches. The comment of each member begins with the letter of the switch that sets it.
struct TriangleSwitches {
  bool poly = false;               ///< p, or FILE ends in .poly
  bool refine = false;             ///< r, or FILE ends in .ele or .area
  bool quality = false;            ///< q, a or D: points may be added
  double min_angle_deg = 0;        ///< q; 20 for q without a number, 0 without q
  std::optional<double> max_area;  ///< a with a number
  bool area_caps = false;          ///< a without a number: caps per region, or from the .area file
  bool region_attributes = false;  ///< A
  bool convex_hull = false;        ///< c
  bool conforming = false;         ///< D, or its old name L
  bool jettison = false;           ///< j
  bool edges = false;              ///< e
  bool neighbours = false;         ///< n
  bool off = false;                ///< g
  bool no_markers = false;         ///< B
  bool no_poly = false;            ///< P
  bool no_node = false;            ///< N
  bool no_ele = false;             ///< E
  bool no_iteration = false;       ///< I
  bool no_holes = false;           ///< O
  bool zero_based = false;         ///< z
  bool second_order = false;       ///< o2
  int no_splits = 0;               ///< Y: 1, YY: 2
  std::optional<unsigned long long> max_steiner_points;  ///< S; 0 for S without a number
  bool check = false;                                    ///< C
  bool quiet = false;                                    ///< Q
  int verbose = 0;                                       ///< V, VV, ...
  bool help = false;                                     ///< h, H or ?
  std::string without_effect;                            ///< i F l s X: they choose among Triangle's own algorithms
  std::string name;                                      ///< FILE without its suffix .node, .poly, .ele or .area
  std::string command;                                   ///< the command line, as the files that are written quote it
};

/// Parses all arguments as one list of switches. Error: `usage`; the message names the switch.
[[nodiscard]] Result<TriangleSwitches> parse_triangle_switches(const std::vector<std::string>& arguments);

}  // namespace pardel::cli
