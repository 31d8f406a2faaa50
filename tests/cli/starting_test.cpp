// What the program loads and sets when it starts.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

class Starting : public Workshop {
 protected:
  /// Runs the program with these variables (NAME=VALUE) in its environment.
  [[nodiscard]] Ran with_variables(std::vector<std::string> variables,
                                   const std::vector<std::string>& arguments) const {
    variables.push_back(PARDEL_PROGRAM);
    variables.insert(variables.end(), arguments.begin(), arguments.end());
    return run("env", variables);
  }
};

TEST_F(Starting, loads_no_library_of_pictures) {
  const Ran ran = with_variables({"LD_TRACE_LOADED_OBJECTS=1"}, {"mesh"});
  ASSERT_NE(ran.out.find("libc.so"), std::string::npos) << ran;
  for (const std::string library : {"cairo", "fontconfig", "freetype", "X11"})
    EXPECT_EQ(ran.out.find(library), std::string::npos) << ran;
}

TEST_F(Starting, a_picture_without_cairo_is_refused_with_the_reason) {
  write("square.poly", square_poly);
  // Another library under the name of cairo: it has none of its functions.
  const std::string loaded = with_variables({"LD_TRACE_LOADED_OBJECTS=1"}, {}).out;
  const std::size_t path = loaded.find("=> /") + 3;
  std::filesystem::create_directory(folder_ / "other");
  std::filesystem::copy_file(loaded.substr(path, loaded.find(' ', path) - path), folder_ / "other" / "libcairo.so.2");
  const Files before = files();
  const Ran ran = with_variables({"LD_LIBRARY_PATH=" + (folder_ / "other").string()}, {"draw", "square.poly", "s.svg"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"cairo, which cannot be loaded", "cairo_clip"})) << ran;
  EXPECT_EQ(files(), before);
}

TEST_F(Starting, waiting_threads_soon_sleep_unless_the_user_decides_otherwise) {
  const auto settings = [&](const std::vector<std::string>& variables) {
    return with_variables(variables, {"--version"}).err;
  };
  const std::string spins = "GOMP_SPINCOUNT = '1000'";
  const std::string shown = "OMP_DISPLAY_ENV=verbose";
  if (const std::string usual = settings({shown}); usual.find(spins) == std::string::npos) {
    // Only GCC's library is part of the program.
    ASSERT_TRUE(sanitized || usual.find("GOMP_SPINCOUNT") == std::string::npos) << usual;
    GTEST_SKIP() << "the program loads its OpenMP library";
  }
  EXPECT_EQ(settings({shown, "OMP_WAIT_POLICY=active"}).find(spins), std::string::npos);
  EXPECT_NE(settings({shown, "GOMP_SPINCOUNT=7"}).find("GOMP_SPINCOUNT = '7'"), std::string::npos);
}

}  // namespace
}  // namespace pardel::testing
