// Files that are large enough to be read and written on several threads.
#include <gtest/gtest.h>

#include "../../../core/formats.hpp"
#include "../../../core/neighbours.hpp"
#include "../../temporary_folder.hpp"
#include "with_threads.hpp"

namespace pardel {
namespace {

/// A grid of squares with two triangles each, in two regions, with attributes. The constrained edges are the left side.
Mesh squares_in_triangles() {
  constexpr Index n = 300;
  Mesh mesh;
  mesh.attributes_per_point = 1;
  mesh.region_attributes = {-1.5, 7};
  for (Index i = 0; i <= n; ++i) {
    for (Index j = 0; j <= n; ++j) {
      mesh.points.push_back({i / 3.0, j / 7.0});
      mesh.point_attributes.push_back(i * 0.1 - j);
      if (i == n || j == n) continue;
      const Index a = i * (n + 1) + j, b = a + n + 1;
      mesh.triangles.push_back({{a, b, b + 1}, {}});
      mesh.triangles.push_back({{a, b + 1, a + 1}, {}});
      mesh.region.push_back(i % 2);
      mesh.region.push_back(j % 2);
      if (i == 0) mesh.constrained_edges.push_back({a, a + 1, no_index, 3});
    }
  }
  rebuild_neighbours(mesh.triangles, mesh.points.size());
  return mesh;
}

TEST(LargeFiles, are_the_same_bytes_on_any_number_of_threads) {
  const TemporaryFolder folder;
  const Mesh mesh = squares_in_triangles();
  std::string first;
  with_threads([&](int threads) {
    TriangleFiles all;
    all.write_edge = all.write_neigh = true;
    ASSERT_TRUE(write_triangle_files(mesh, {}, folder / "m", all).ok());
    ASSERT_TRUE(write_vtu(mesh, folder / "m.vtu").ok());
    ASSERT_TRUE(write_off(mesh, folder / "m.off").ok());
    ASSERT_TRUE(write_msh(mesh, folder / "m.msh", MshEncoding::binary).ok());
    ASSERT_TRUE(write_msh(mesh, folder / "text.msh", MshEncoding::ascii).ok());
    std::string bytes;
    for (const char* name : {"m.node", "m.ele", "m.poly", "m.edge", "m.neigh", "m.vtu", "m.off", "m.msh", "text.msh"})
      bytes += folder.read(name);
    if (threads == 1) first = bytes;
    EXPECT_TRUE(bytes == first) << threads << " threads";
  });
}

TEST(LargeFiles, have_the_mesh_that_was_written_on_any_number_of_threads) {
  const TemporaryFolder folder;
  Mesh mesh = squares_in_triangles();
  TriangleFiles all;
  all.write_edge = all.write_neigh = true;
  all.markers = false;
  ASSERT_TRUE(write_triangle_files(mesh, {}, folder / "m", all).ok());
  all.second_order = true;
  ASSERT_TRUE(write_triangle_files(mesh, {}, folder / "six", all).ok());
  for (ConstrainedEdge& edge : mesh.constrained_edges) edge.marker = 0;
  for (const char* name : {"m.ele", "six.ele"}) {
    with_threads([&](int threads) {
      const Result<Mesh> read = read_mesh(folder / name);
      ASSERT_TRUE(read.ok()) << read.error().message;
      EXPECT_TRUE(*read == mesh) << name << ", " << threads << " threads";
    });
  }
}

TEST(LargeFiles, have_the_first_mistake_on_any_number_of_threads) {
  const TemporaryFolder folder;
  TriangleFiles all;
  all.write_edge = all.write_neigh = true;
  ASSERT_TRUE(write_triangle_files(squares_in_triangles(), {}, folder / "m", all).ok());
  const auto failure = [&](const char* name, const std::string& from, const std::string& to) {
    const std::string text = folder.read(name);
    std::string broken = text;
    broken.replace(broken.find("\n" + from) + 1, from.size(), to);
    folder.write(name, broken);
    std::string message;
    with_threads([&](int threads) {
      const std::string each = message_of(read_mesh(folder / "m.ele"), folder);
      if (threads == 1) message = each;
      EXPECT_EQ(each, message) << threads << " threads";
    });
    folder.write(name, text);
    return message;
  };
  EXPECT_EQ(failure("m.node", "30000 ", "30001 "),
            "m.node:30001: expected point 30000 (numbers are consecutive), found 30001");
  EXPECT_EQ(failure("m.ele", "70000 ", "70000 90602 "),
            "m.ele:70001: expected a corner of a triangle, a whole number from 1 to 90601, found \"90602\"");
  EXPECT_EQ(failure("m.neigh", "70000 ", "70000 1 "),
            "m.neigh:70001: expected neighbour 70001, as the triangles have it, found 1");
  std::filesystem::remove(folder / "m.poly");
  EXPECT_EQ(failure("m.edge", "100000 ", "100000 x "),
            "m.edge:100001: expected an end of a segment, a whole number, found \"x\"");
}

}  // namespace
}  // namespace pardel
