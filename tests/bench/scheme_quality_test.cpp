// What count_schemes tells of a mesh: only a mesh that meets the goal is certified.
#include <gtest/gtest.h>

#include "../../bench/schemes/quality.hpp"
#include "../../ref/schemes/all_schemes.hpp"

namespace pardel::bench {
namespace {

TEST(SchemeQuality, certifies_only_what_meets_the_goal) {
  for (const char* name : {"square", "random"}) {
    const SchemeInput input = scheme_input(name, 500, true).value();
    const schemes::Start start = schemes::start_of({input.pslg, input.goal}).value();
    EXPECT_FALSE(scheme_quality(start.mesh, input, true).certified) << name;
    EXPECT_TRUE(scheme_quality(start.mesh, input, false).certified) << name;
    const auto refined = schemes::all_schemes().front().run({input.pslg, input.goal}, {1});
    const SchemeQuality quality = scheme_quality(refined.value().front().mesh, input, true);
    EXPECT_TRUE(quality.certified) << name;
    EXPECT_EQ(quality.triangles, refined.value().front().mesh.faces.size()) << name;
    EXPECT_GE(quality.smallest_angle, 20.7) << name;
    EXPECT_LE(quality.smallest_angle, 60) << name;
  }
}

TEST(SchemeQuality, certifies_no_mesh_with_a_hole) {
  const SchemeInput input = scheme_input("random", 500, true).value();
  schemes::LinkedMesh mesh = schemes::all_schemes().front().run({input.pslg, input.goal}, {1}).value().front().mesh;
  mesh.faces.pop_back();
  for (schemes::Face& face : mesh.faces)
    for (Index& n : face.n)
      if (n == mesh.faces.size()) n = no_index;
  EXPECT_FALSE(scheme_quality(mesh, input, true).certified);
  EXPECT_FALSE(scheme_quality(mesh, input, false).certified);
}

}  // namespace
}  // namespace pardel::bench
