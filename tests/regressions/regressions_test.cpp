// Each file of this folder, at each angle: meshed, certified by the independent checker, and exempt triangles
// only beside small input angles.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "../../core/formats.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/check.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> inputs() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(PARDEL_REGRESSIONS))
    if (entry.path().extension() == ".poly") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
  return name;
}

class Regression : public testing::TestWithParam<fs::path> {
 protected:
  void mesh_and_certify(const Goal& goal) {
    SCOPED_TRACE(GetParam().filename().string() + " at " + std::to_string(goal.min_angle_deg) + " degrees");
    const Result<Pslg> pslg = read_pslg(GetParam());
    ASSERT_TRUE(pslg) << pslg.error().message;
    const Result<Meshed> meshed = mesh(*pslg, goal);
    ASSERT_TRUE(meshed) << meshed.error().message;
    EXPECT_TRUE(meshed->report.goal_met());
    const Certificate certificate = check(*pslg, meshed->mesh, goal);
    EXPECT_TRUE(certificate.valid) << to_text(certificate);
  }
};

TEST_P(Regression, is_meshed_and_certified_at_every_angle) {
  for (const double angle : {0.0, 20.7, 25.0, 30.0, 33.0}) mesh_and_certify({.min_angle_deg = angle});
}

TEST_P(Regression, is_meshed_and_certified_as_a_conforming_mesh) {
  mesh_and_certify({.min_angle_deg = 25, .conforming = true});
}

INSTANTIATE_TEST_SUITE_P(Files, Regression, testing::ValuesIn(inputs()), test_name);

}  // namespace
}  // namespace pardel
