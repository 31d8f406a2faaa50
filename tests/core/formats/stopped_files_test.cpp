// The caller may end a reader and a writer. Then nothing is written.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include "../../../core/formats.hpp"
#include "../../../core/support/output_file.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"

namespace pardel {
namespace {

const std::set<std::string> read_and_written = {"node", "ele", "msh", "vtu", "vtk", "off", "2dm", "gr3", "14"};

bool never() { return false; }

TEST(StoppedFiles, are_read_and_written_whole_if_the_caller_goes_on) {
  const TemporaryFolder folder;
  for (const std::string& suffix : read_and_written) {
    int questions = 0;
    const GoOn count = [&] { return ++questions > 0; };
    ASSERT_TRUE(write_mesh(sample_mesh(), {}, folder / ("m." + suffix), MeshFileOptions{.go_on = count})) << suffix;
    EXPECT_GT(std::exchange(questions, 0), 0) << "writing " << suffix;
    const Result<Mesh> read = read_mesh(folder / ("m." + suffix), count);
    ASSERT_TRUE(read) << suffix;
    EXPECT_GT(questions, 0) << "reading " << suffix;
    EXPECT_EQ(read->triangles.size(), sample_mesh().triangles.size());
  }
}

TEST(StoppedFiles, that_are_written_do_not_exist_and_those_before_stay) {
  std::set<std::string> suffixes = read_and_written;
  suffixes.insert({"inp", "svg"});
  for (const std::string& suffix : suffixes) {
    const TemporaryFolder folder;
    const MeshFileOptions stopped{.go_on = never};
    const Status none = write_mesh(sample_mesh(), {}, folder / ("new." + suffix), stopped);
    ASSERT_FALSE(none) << suffix;
    EXPECT_EQ(none.error().kind, ErrorKind::cancelled) << suffix;
    EXPECT_EQ(folder.names(), "") << suffix;
    ASSERT_TRUE(write_mesh(sample_mesh(), {}, folder / ("old." + suffix)));
    const std::string before = folder.names();
    const std::string bytes = folder.read("old." + suffix);
    Mesh other = sample_mesh();
    other.points[0].x -= 1;
    EXPECT_FALSE(write_mesh(other, {}, folder / ("old." + suffix), stopped));
    EXPECT_EQ(folder.names(), before) << suffix;
    EXPECT_EQ(folder.read("old." + suffix), bytes) << suffix;
  }
}

TEST(StoppedFiles, that_are_read_are_an_error) {
  const TemporaryFolder folder;
  for (const std::string& suffix : read_and_written) {
    ASSERT_TRUE(write_mesh(sample_mesh(), {}, folder / ("m." + suffix)));
    const Result<Mesh> read = read_mesh(folder / ("m." + suffix), never);
    ASSERT_FALSE(read) << suffix;
    EXPECT_EQ(read.error().kind, ErrorKind::cancelled) << suffix;
    EXPECT_EQ(read.error().message, "the caller asked to stop");
  }
  folder.write("m.asc", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n5\n");
  folder.write("m.sizes", "1\n1 5\n");
  EXPECT_EQ(read_raster(folder / "m.asc", never).error().kind, ErrorKind::cancelled);
  EXPECT_EQ(read_sizes(folder / "m.sizes", never).error().kind, ErrorKind::cancelled);
}

TEST(StoppedFiles, of_domains_are_neither_read_nor_written) {
  const TemporaryFolder folder;
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {0, 1}};
  pslg.segments = {{0, 1}};
  EXPECT_EQ(write_poly(pslg, folder / "d.poly", 1, never).error().kind, ErrorKind::cancelled);
  EXPECT_EQ(write_svg(pslg, folder / "d.svg", never).error().kind, ErrorKind::cancelled);
  EXPECT_EQ(folder.names(), "");
  ASSERT_TRUE(write_poly(pslg, folder / "d.poly"));
  EXPECT_EQ(read_pslg(folder / "d.poly", never).error().kind, ErrorKind::cancelled);
  EXPECT_EQ(read_pslg_or_mesh(folder / "d.poly", never).error().kind, ErrorKind::cancelled);
}

TEST(StoppedFiles, keep_the_failure_that_came_first) {
  OutputFile out("/no/such/folder/file", never);
  out.write("bytes");
  EXPECT_EQ(out.close().error().kind, ErrorKind::io);
}

}  // namespace
}  // namespace pardel
