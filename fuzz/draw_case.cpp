// draw_case INPUT STEM: writes the domain that an input of a fuzz target draws, before its repair, as STEM.poly and
// STEM.svg, and prints the goal and the options.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "../core/formats.hpp"
#include "mesh_case.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: draw_case INPUT STEM\n");
    return 2;
  }
  std::ifstream in(argv[1], std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const pardel::fuzz::MeshCase drawn = pardel::fuzz::decode_mesh_case(bytes);
  const auto& [pslg, goal, options, nudged, again, threads, ranks, seed] = drawn;
  const std::string stem = argv[2];
  for (const pardel::Status& written :
       {pardel::write_poly(pslg, stem + ".poly"), pardel::write_svg(pslg, stem + ".svg")})
    if (!written) {
      std::fprintf(stderr, "%s\n", written.error().message.c_str());
      return 5;
    }
  std::printf("%zu points, %zu segments, %zu holes, %zu regions\n", pslg.points.size(), pslg.segments.size(),
              pslg.holes.size(), pslg.regions.size());
  std::printf("angle %g, area %g, edge %g, conforming %d, hull %d, field %d, grading %g, feature edges %g\n",
              goal.min_angle_deg, goal.max_area, goal.max_edge, goal.conforming, goal.convex_hull,
              static_cast<bool>(goal.size), goal.grading, goal.feature_edges);
  std::printf("placement %d, decomposition %d, triangles per tile %u, vertices %llu, least edge %g, no splits %d %d\n",
              static_cast<int>(options.placement), static_cast<int>(options.decomposition), options.triangles_per_tile,
              static_cast<unsigned long long>(options.max_vertices), options.min_edge, options.no_boundary_splits,
              options.no_segment_splits);
  std::printf("nudged %d, refined again %d, threads %d, ranks %d, seed %llu\n", nudged, again, threads, ranks,
              static_cast<unsigned long long>(seed));
  return 0;
}
