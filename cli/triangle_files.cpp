#include "triangle_files.hpp"

#include <algorithm>
#include <cctype>

namespace pardel::cli {

std::string next_name(const std::string& name, bool no_iteration) {
  if (no_iteration) return name;
  const std::size_t dot = name.rfind('.');
  const bool numbered = dot != std::string::npos && dot > 0 && dot + 1 < name.size() && name.size() - dot <= 9 &&
                        std::all_of(name.begin() + static_cast<std::ptrdiff_t>(dot) + 1, name.end(),
                                    [](unsigned char c) { return std::isdigit(c) != 0; });
  if (!numbered) return name + ".1";
  return name.substr(0, dot + 1) + std::to_string(std::stol(name.substr(dot + 1)) + 1);
}

TriangleFiles files_to_write(const TriangleSwitches& switches, int base, bool node_was_read) {
  TriangleFiles files;
  files.base = base;
  files.write_node = !switches.no_node && !(switches.no_iteration && node_was_read);
  files.write_ele = !switches.no_ele;
  files.write_poly = (switches.poly || switches.convex_hull) && !switches.no_poly && !switches.no_iteration;
  files.write_edge = switches.edges;
  files.write_neigh = switches.neighbours;
  files.markers = !switches.no_markers;
  files.second_order = switches.second_order;
  files.command = switches.command;
  return files;
}

}  // namespace pardel::cli
