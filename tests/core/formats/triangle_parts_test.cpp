// A domain of which several ranks read a part of the points each.
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
  Pslg pslg;
  std::string failure;
};

Together read_by(int count, const std::filesystem::path& file) {
  std::vector<PartOfPslg> parts(static_cast<std::size_t>(count));
  std::vector<std::string> failures(static_cast<std::size_t>(count));
  properties::on_ranks(count, [&](Ranks& ranks) {
    Result<PartOfPslg> part = read_part_of_pslg(file, ranks);
    if (!part)
      failures[ranks.rank()] = part.error().message;
    else
      parts[ranks.rank()] = *std::move(part);
  });
  Together all;
  all.failure = failures.front();
  for (const std::string& failure : failures) EXPECT_EQ(failure, all.failure);
  for (const PartOfPslg& part : parts) {
    if (!all.failure.empty()) break;
    EXPECT_EQ(part.points.first, all.pslg.points.size());
    EXPECT_EQ(part.points.attributes_per_point, parts.front().points.attributes_per_point);
    EXPECT_EQ(part.points.first_id.value, parts.front().points.first_id.value);
    EXPECT_EQ(part.segments.first, all.pslg.segments.size());
    EXPECT_EQ(part.rest, parts.front().rest);
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(all.pslg.points, part.points.points);
    append(all.pslg.point_attributes, part.points.point_attributes);
    append(all.pslg.point_markers, part.points.point_markers);
    append(all.pslg.segments, part.segments.segments);
  }
  const PartOfPslg& first = parts.front();
  all.pslg.attributes_per_point = first.points.attributes_per_point;
  all.pslg.first_id = first.points.first_id;
  all.pslg.has_segment_markers = first.rest.has_segment_markers;
  all.pslg.holes = first.rest.holes;
  all.pslg.regions = first.rest.regions;
  return all;
}

/// Reads the file in one process and by ranks, and expects the same domain or the same message.
void expect_the_same(const std::filesystem::path& file, const std::string& text) {
  const Result<Pslg> whole = read_pslg(file);
  for (const int count : {1, 2, 3, 5, 8, 40}) {
    const Together together = read_by(count, file);
    if (!whole) {
      EXPECT_EQ(together.failure, whole.error().message) << count << " ranks: " << text;
    } else {
      EXPECT_EQ(together.failure, "") << text;
      EXPECT_EQ(together.pslg, *whole) << count << " ranks: " << text;
      EXPECT_EQ(together.pslg.first_id.value, whole->first_id.value);
    }
  }
}

void expect_the_same(const std::string& text) {
  const TemporaryFolder folder;
  expect_the_same(folder.write("points.node", text), text);
}

void expect_the_same_poly(const std::string& text) {
  const TemporaryFolder folder;
  expect_the_same(folder.write("domain.poly", text), text);
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
  expect_the_same("27 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  expect_the_same("4000000000 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  expect_the_same("3 2 2000000000 0\n1 0 0\n2 1 0\n3 0 1\n");
  expect_the_same("# points\n\n3 2\n1 0 0\n2 1 0\n3");
}

std::string domain_with(const std::string& after_points) { return many_points(1) + after_points; }

TEST(PartsOfPoly, are_together_the_domain_of_the_file) {
  for (const std::string none : {"0 0\n0\n", "# segments\n0 1\n# holes\n0\n# regions\n0\n", "0\n0\n\n0\ntext\n"})
    expect_the_same_poly(domain_with(none));
  expect_the_same_poly(domain_with("1 0\n1 1 2\n0\n"));
  expect_the_same_poly(
      domain_with("2 1 # two segments\n1 1 2 -5\n\n2 7 8 6\n# holes\n1\n1 0.5 0.5\n2\n1 1 1 4 0.25\n2 2 2 3"));
  expect_the_same_poly(domain_with("0 0\n1\n1 0.5 0.5\n"));
}

TEST(PartsOfPoly, have_the_points_of_its_node) {
  const TemporaryFolder folder;
  folder.write("domain.node", many_points(0));
  const std::string rest = "# no points here\n0 2 0 0\n3 0\n1 0 1\n2 1 2\n3 5 199\n1\n1 0.5 0.5\n";
  expect_the_same(folder.write("domain.poly", rest), rest);
  expect_the_same_poly(rest);  // the .node is missing
}

TEST(PartsOfPoly, name_the_line_of_a_fault_as_one_reader_does) {
  for (const std::string faulty :
       {"", "0 0\n", "\n# nothing\n\n", "two\n0\n", "1 0\n1 1 201\n0\n", "2 0\n1 1 2\n\n2 3 x\n0\n",
        "1 0\n1 1 2\n2\n1 0 0\n2 0\n", "0 0\n0\n1\n1 0.5 0.5\n", "3 0\n1 1 2\n2 2 3\n"})
    expect_the_same_poly(domain_with(faulty));
  expect_the_same_poly(replaced(domain_with("1 0\n1 1 2\n0\n"), "\n77 ", "\n77 x"));
  expect_the_same_poly(replaced(domain_with("0 0\n0\n"), "  200 2", "  205 2"));
}

std::string many_segments() {
  std::string text = "# segments\n150 1 # many\n";
  for (int s = 1; s <= 150; ++s)
    text += std::to_string(s) + " " + std::to_string(s) + " " + std::to_string(s + 1) + " " + std::to_string(s % 5) +
            (s % 13 == 0 ? "  # a comment\r\n\n" : "\n");
  return text + "# holes\n1\n1 0.5 0.5\n";
}

TEST(PartsOfPoly, have_a_part_of_many_segments_each) {
  expect_the_same_poly(domain_with(many_segments()));
  const TemporaryFolder folder;
  folder.write("domain.node", many_points(1));
  const std::string rest = "0 2 0 0\n" + many_segments();
  expect_the_same(folder.write("domain.poly", rest), rest);
}

TEST(PartsOfPoly, name_the_line_of_a_fault_in_a_segment_as_one_reader_does) {
  const std::string text = domain_with(many_segments());
  expect_the_same_poly(replaced(text, "\n77 77 78 ", "\n77 77 201 "));
  expect_the_same_poly(replaced(text, "\n150 150 ", "\n150 x "));
  expect_the_same_poly(replaced(text, "\n1 1 2 1", "\n1 1"));
  expect_the_same_poly(replaced(text, "150 1 #", "149 1 #"));
  expect_the_same_poly(replaced(text, "150 1 #", "170 1 #"));
  expect_the_same_poly(replaced(text, "150 1 #", "4000000000 1 #"));
  expect_the_same_poly(replaced(text, "150 1 #", "150 2 #"));
  expect_the_same_poly(text.substr(0, text.find("\n120 ")));
  expect_the_same_poly(replaced(text, "1 0.5 0.5", "1 0.5"));
}

TEST(PartsOfNode, of_a_file_that_is_missing_or_no_regular_file_are_refused) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_by(3, folder / "none.node").failure,
            (folder / "none.node").string() + ": cannot be opened: No such file or directory");
  EXPECT_EQ(read_by(3, "/dev/null").failure, "/dev/null: only a regular file can be read in parts");
}

}  // namespace
}  // namespace pardel
