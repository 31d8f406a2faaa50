// A .node of which several ranks read a part each.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../../temporary_folder.hpp"

namespace pardel {
namespace {

/// The parts of all ranks put together, or the message that all ranks return.
struct Together {
  Pslg points;
  std::string failure;
};

Together read_by(int count, const std::filesystem::path& file) {
  std::vector<PartOfPoints> parts(static_cast<std::size_t>(count));
  std::vector<std::string> failures(static_cast<std::size_t>(count));
  properties::on_ranks(count, [&](Ranks& ranks) {
    Result<std::optional<PartOfPoints>> part = read_part_of_points(file, ranks);
    if (!part)
      failures[ranks.rank()] = part.error().message;
    else if (!*part)
      failures[ranks.rank()] = "more than points";
    else
      parts[ranks.rank()] = **std::move(part);
  });
  Together all;
  all.failure = failures.front();
  for (const std::string& failure : failures) EXPECT_EQ(failure, all.failure);
  for (const PartOfPoints& part : parts) {
    if (!all.failure.empty()) break;
    EXPECT_EQ(part.first, all.points.points.size());
    EXPECT_EQ(part.attributes_per_point, parts.front().attributes_per_point);
    EXPECT_EQ(part.first_id.value, parts.front().first_id.value);
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(all.points.points, part.points);
    append(all.points.point_attributes, part.point_attributes);
    append(all.points.point_markers, part.point_markers);
  }
  all.points.attributes_per_point = parts.front().attributes_per_point;
  all.points.first_id = parts.front().first_id;
  return all;
}

/// Reads the text in one process and by ranks, and expects the same points or the same message.
void expect_the_same(const std::string& text) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("points.node", text);
  const Result<Pslg> whole = read_pslg(file);
  for (const int count : {1, 2, 3, 5, 8, 40}) {
    const Together together = read_by(count, file);
    if (!whole) {
      EXPECT_EQ(together.failure, whole.error().message) << count << " ranks: " << text;
    } else {
      EXPECT_EQ(together.failure, "") << text;
      EXPECT_EQ(together.points, *whole) << count << " ranks: " << text;
      EXPECT_EQ(together.points.first_id.value, whole->first_id.value);
    }
  }
}

std::string many_points(int base) {
  std::string text = "# points\n\n  200 2 1 1 # two hundred\n";
  for (int i = 0; i < 200; ++i) {
    text += std::to_string(i + base) + " " + std::to_string(i * 0.25) + " " + std::to_string(i % 7) + " 1.5 " +
            std::to_string(i % 3) + (i % 20 == 0 ? "   # a comment" : "") + (i % 11 == 0 ? "\r\n" : "\n");
    if (i % 17 == 0) text += "\n# a line without a point, longer than the part of a rank that reads it with others\n";
  }
  return text;
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  return text.replace(text.find(old), old.size(), by);
}

TEST(PartsOfNode, are_together_the_points_of_the_file) {
  for (const int base : {0, 1}) {
    expect_the_same(many_points(base));
    expect_the_same("\xEF\xBB\xBF" + many_points(base));
    expect_the_same(many_points(base) + "# Generated\n1 2 3 text after the points is ignored\n");
  }
  expect_the_same("3 2 0 0\n1 0 0\n2 1 0\n3 0 1");
  expect_the_same("0\n");
  expect_the_same("1 2 0 0\n0 5 6\n");
}

TEST(PartsOfNode, name_the_line_of_a_fault_as_one_reader_does) {
  expect_the_same("");
  expect_the_same("# nothing\n\n");
  expect_the_same("three points\n");
  expect_the_same("3 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n");
  expect_the_same("3\n2 0 0\n3 1 0\n4 0 1\n");
  const std::string text = many_points(1);
  expect_the_same(replaced(text, "\n120 ", "\n121 "));
  expect_the_same(replaced(text, "\n77 ", "\n77 x"));
  expect_the_same(replaced(text, "  200 2", "  205 2"));
  expect_the_same(replaced(text, "200 2 1 1", "200 2 2 1"));
}

TEST(PartsOfPoly, are_read_if_it_has_only_points) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& after_points, int count) {
    return read_by(count, folder.write("points.poly", many_points(1) + after_points));
  };
  for (const int count : {1, 2, 3, 8}) {
    for (const std::string none : {"0 0\n0\n", "# segments\n0 1\n# holes\n0\n# regions\n0\n", "0\n0\n\n0\ntext\n"}) {
      const Together together = read(none, count);
      EXPECT_EQ(together.failure, "") << none;
      const Result<Pslg> whole = read_pslg(folder / "points.poly");
      EXPECT_EQ(together.points.points, whole->points) << none;
      EXPECT_EQ(together.points.point_markers, whole->point_markers) << none;
    }
    for (const std::string more : {"1 0\n1 1 2\n0\n", "0 0\n1\n1 0.5 0.5\n", "0 0\n0\n1\n1 0.5 0.5 1\n", "0 0\n", ""})
      EXPECT_EQ(read(more, count).failure, "more than points") << more;
    EXPECT_EQ(read_by(count, folder.write("in_node.poly", "0 2 0 0\n0 0\n0\n")).failure, "more than points");
  }
}

TEST(PartsOfNode, of_a_file_that_is_missing_or_no_regular_file_are_refused) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_by(3, folder / "none.node").failure,
            (folder / "none.node").string() + ": cannot be opened: No such file or directory");
  EXPECT_EQ(read_by(3, "/dev/null").failure, "/dev/null: only a regular file can be read in parts");
}

}  // namespace
}  // namespace pardel
