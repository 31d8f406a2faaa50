// The snippets of docs/api.md, compiled and run. A test compares them with the page, without indentation.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <pardel/pardel.hpp>
#include <pardel/properties/checker/check.hpp>
#include <pardel/properties/domains/domains.hpp>

#include "documents.hpp"

namespace pardel::testing {
namespace {

bool report(const Error& error) {
  std::puts(error.message.c_str());
  return false;
}

void use(Point p) { EXPECT_GE(p.x, 0); }

/// True if no snippet failed.
bool run_snippets(const std::filesystem::path& folder) {
  // clang-format off
  pardel::Pslg plate;
  plate.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}};
  plate.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  plate.holes = {{0.5, 0.5}};
  plate.regions = {{.seed = {0.1, 0.1}, .attribute = 7, .max_area = 0.01}};

  const auto meshed = pardel::mesh(plate, {.min_angle_deg = 30, .max_area = 0.001});
  if (!meshed) return report(meshed.error());
  for (const pardel::Triangle& triangle : meshed->mesh.triangles) {
    const pardel::Point a = meshed->mesh.points[triangle.v[0]];
    use(a);
  }

  pardel::Options options;
  options.threads = 2;
  options.max_memory = std::uint64_t{1} << 30;  // bytes; a larger mesh is an error of kind `resources`
  options.progress = [](const pardel::Progress& progress) { return progress.triangles < 1'000'000; };
  const auto limited = pardel::mesh(plate, {.max_edge = 0.05}, options);
  if (!limited) return report(limited.error());

  pardel::Goal tested;
  tested.user_test = [](const std::array<pardel::Point, 3>& corners, double area) {
    return area > (corners[0].x < 0.5 ? 1e-4 : 1e-2);
  };
  tested.user_test_is_free_of_state = true;  // a pure function, for all threads
  const auto by_test = pardel::mesh(plate, tested);
  if (!by_test) return report(by_test.error());

  pardel::Goal graded{.grading = 0.2, .feature_edges = 2};
  graded.sources.push_back({{0.5, 0.1}, {0.5, 0.1}, 0.01, 0.01});  // from a to b, with these lengths at a and b
  const auto from_sources = pardel::mesh(plate, graded);
  if (!from_sources) return report(from_sources.error());

  for (const pardel::Exemption& exemption : limited->report.exempt) {
    std::printf("triangle %u: %s\n", exemption.triangle, pardel::name(exemption.reason));
  }

  const auto domain = pardel::validate(plate);
  if (!domain) {
    for (const pardel::Problem& problem : domain.error()) std::puts(problem.message().c_str());
    return false;
  }
  const auto triangulated = pardel::triangulate(*domain);
  EXPECT_TRUE(triangulated);

  pardel::Pslg crossing;
  crossing.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {-1, 1}, {3, 1}};
  crossing.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}};
  const auto repaired = pardel::repair(crossing);
  if (!repaired) return report(repaired.error());
  for (const std::string& line : repaired->log) std::puts(line.c_str());
  const auto of_repaired = pardel::mesh(repaired->domain);
  EXPECT_TRUE(of_repaired);

  const pardel::Result<pardel::Locator> locator = pardel::Locator::over(meshed->mesh);
  if (!locator) return report(locator.error());
  const pardel::Index triangle = locator->triangle_at({0.5, 0.25});  // the first of several; pardel::no_index outside
  EXPECT_NE(triangle, pardel::no_index);

  const pardel::Status written = pardel::write_mesh(meshed->mesh, plate, folder / "plate.vtu");
  if (!written) return report(written.error());
  const auto again = pardel::read_mesh(folder / "plate.vtu");
  if (!again) return report(again.error());

  const bool same = pardel::digest(*again) == pardel::digest(meshed->mesh);
  EXPECT_TRUE(same);

  const pardel::Certificate certificate = pardel::check(plate, meshed->mesh, {.min_angle_deg = 30, .max_area = 0.001});
  if (!certificate.valid) {
    for (const pardel::Violation& violation : certificate.violations) std::puts(violation.message().c_str());
  }
  EXPECT_TRUE(certificate.valid);

  const auto wedge = pardel::domains::generate("wedge", 0, 1);
  EXPECT_TRUE(wedge);
  // clang-format on
  return true;
}

TEST(ApiSnippets, run) {
  const auto folder = std::filesystem::temp_directory_path() / ("pardel_api_" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  EXPECT_TRUE(run_snippets(folder));
  std::filesystem::remove_all(folder);
}

TEST(ApiSnippets, are_those_of_the_page) {
  const std::string here = without_indentation(read_document("tests/docs/api_snippets_test.cpp"));
  for (const std::string& snippet : code_blocks(read_document("docs/api.md"), "cpp")) {
    EXPECT_NE(here.find(without_indentation(snippet)), std::string::npos) << snippet;
  }
}

}  // namespace
}  // namespace pardel::testing
