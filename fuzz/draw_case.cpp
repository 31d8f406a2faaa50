// draw_case TARGET INPUT STEM: writes the domain that an input of a fuzz target draws, before its repair, as STEM.poly
// and STEM.svg, and prints the goal and the options. If scales are mixed, it writes the domain after its repair, mixed.
#include <cstdio>
#include <string>
#include <system_error>
#include <vector>

#include "../core/formats.hpp"
#include "mesh_case.hpp"
#include "reference_case.hpp"
#include "stored_inputs.hpp"

namespace {

using namespace pardel;

void print(const Pslg& pslg, const Goal& goal) {
  std::printf("%zu points, %zu segments, %zu holes, %zu regions\n", pslg.points.size(), pslg.segments.size(),
              pslg.holes.size(), pslg.regions.size());
  std::printf("angle %g, area %g, edge %g, conforming %d, hull %d, field %d, grading %g, feature edges %g\n",
              goal.min_angle_deg, goal.max_area, goal.max_edge, goal.conforming, goal.convex_hull,
              static_cast<bool>(goal.size), goal.grading, goal.feature_edges);
}

/// `pslg`: the domain that is written.
void print(const Pslg& pslg, const fuzz::MeshCase& drawn) {
  const auto& [original, goal, options, nudged, again, threads, ranks, seed, mixture] = drawn;
  print(pslg, goal);
  std::printf(
      "placement %d, decomposition %d, triangles per tile %u, vertices %llu, least edge %g, no splits %d %d, kept "
      "markers %zu\n",
      static_cast<int>(options.placement), static_cast<int>(options.decomposition), options.triangles_per_tile,
      static_cast<unsigned long long>(options.max_vertices), options.min_edge, options.no_boundary_splits,
      options.no_segment_splits, options.kept_markers.size());
  std::printf("nudged %d, refined again %d, threads %d, ranks %d, seed %llu, mixture %d\n", nudged, again, threads,
              ranks, static_cast<unsigned long long>(seed), mixture);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 4) {
    std::fprintf(stderr, "usage: draw_case TARGET INPUT STEM\n");
    return 2;
  }
  const std::string target = argv[1], stem = argv[3];
  const std::vector<std::uint8_t> bytes = fuzz::bytes_of(argv[2]);
  Pslg pslg;
  if (target == "reference") {
    const fuzz::ReferenceCase drawn = fuzz::decode_reference_case(bytes);
    print(drawn.pslg, drawn.goal);
    pslg = drawn.pslg;
  } else {
    const fuzz::MeshCase drawn = fuzz::decode_mesh_case(bytes);
    pslg = drawn.mixture != 0 && target != "repair" ? fuzz::prepare(drawn).pslg : drawn.pslg;
    print(pslg, drawn);
  }
  for (const Status& written : {write_poly(pslg, stem + ".poly"), write_svg(pslg, stem + ".svg")})
    if (!written) {
      std::fprintf(stderr, "%s\n", written.error().message.c_str());
      return 5;
    }
  return 0;
} catch (const std::system_error& error) {
  std::fprintf(stderr, "draw_case: %s\n", error.what());
  return 2;
}
