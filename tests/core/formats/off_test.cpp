#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"

namespace pardel {
namespace {

TEST(Off, is_counts_then_vertices_then_faces) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_off(sample_mesh(), folder / "m.off").ok());
  EXPECT_EQ(folder.read("m.off"),
            "OFF\n6 4 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 0\n5 5 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n"
            "# constrained edges: 5\n# 0 1 1\n# 1 2 5\n# 2 3 1\n# 3 0 -4\n# 2 4 0\n");
  const auto read = read_mesh(folder / "m.off");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->points, sample_mesh().points);
  EXPECT_EQ(read->triangles, sample_mesh().triangles);
}

TEST(Off, lists_the_constrained_edges_in_comments) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  ASSERT_TRUE(write_off(mesh, folder / "m.off").ok());
  const auto read = read_mesh(folder / "m.off");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->constrained_edges, mesh.constrained_edges);
  mesh.constrained_edges.clear();
  ASSERT_TRUE(write_off(mesh, folder / "m.off").ok());
  EXPECT_EQ(folder.read("m.off").find('#'), std::string::npos);
  EXPECT_TRUE(read_mesh(folder / "m.off")->constrained_edges.empty());
}

TEST(Off, may_have_its_counts_on_the_first_line_comments_and_colours) {
  const TemporaryFolder folder;
  const auto read =
      read_mesh(folder.write("m.off", "# made by hand\nOFF 3 1 3\n\n0 0 1\n1 0 2\n0 1 3\n3 0 1 2 255 0 0\n"));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->points[2], (Point{0, 1}));
  EXPECT_EQ(read->triangles.size(), 1u);
}

TEST(Off, errors_name_the_line_and_the_fault) {
  const TemporaryFolder folder;
  const auto failure = [&](const char* text) { return message_of(read_mesh(folder.write("m.off", text)), folder); };
  EXPECT_EQ(failure(""), "m.off:1: expected \"OFF\", found the end of the file");
  EXPECT_EQ(failure("COFF\n"), "m.off:1: expected \"OFF\", found \"COFF\"");
  EXPECT_EQ(failure("OFF\n3 x\n"), "m.off:2: expected the number of faces, a whole number, found \"x\"");
  EXPECT_EQ(failure("OFF\n1 0 0\n0 nan 0\n"),
            "m.off:3: expected a y coordinate, finite and within the range of a double, found \"nan\"");
  EXPECT_EQ(failure("OFF\n1 1 0\n0 0 0\n4 0 0 0 0\n"),
            "m.off:4: expected the number of corners, a whole number from 3 to 3, found \"4\"");
  EXPECT_EQ(failure("OFF\n1 1 0\n0 0 0\n3 0 0 1\n"),
            "m.off:4: expected a corner of a face, a whole number from 0 to 0, found \"1\"");
  EXPECT_EQ(failure("OFF\n2 0 0\n0 0 0\n"), "m.off:4: expected vertex 2 of 2, found the end of the file");
  const std::string point = "OFF\n1 0 0\n0 0 0\n# constrained edges: ";
  EXPECT_EQ(failure((point + "1\n0 0 0\n").c_str()), "m.off:5: expected the comment of constrained edge 1 of 1");
  EXPECT_EQ(failure((point + "1\n# 0 1 0\n").c_str()),
            "m.off:5: expected an end of a constrained edge, a whole number from 0 to 0, found \"1\"");
  EXPECT_EQ(failure((point + "9\n# 0 1 0\n").c_str()),
            "m.off:4: announces 9 constrained edges, but the rest of the file is too short for that");
  EXPECT_EQ(failure("OFF\n4000000000 0 0\n0 0 0\n"),
            "m.off:2: announces 4000000000 vertices, but the rest of the file is too short for that");
  EXPECT_EQ(failure("OFF\n0 1431655764 0\n"),
            "m.off:2: announces 1431655764 faces, but the rest of the file is too short for that");
  EXPECT_EQ(failure("OFF\n0 1431655765 0\n"), "m.off:2: announces more than a mesh can hold");
}

}  // namespace
}  // namespace pardel
