#include "../../../core/formats/read_records.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "with_threads.hpp"

namespace pardel::files {
namespace {

constexpr std::size_t many = 120'000;

/// Lines "i 7*i" for i < records, with all that may be between records and behind their fields.
std::string lines_of(std::size_t records) {
  std::string text;
  for (std::size_t i = 0; i < records; ++i) {
    if (i % 11 == 3) text += "\n# 1 2 3\n \t\n";
    text += (i % 7 == 0 ? "  " : "") + std::to_string(i) + ' ' + std::to_string(7 * i);
    text += i % 5 == 0 ? " ignored\r\n" : i % 13 == 0 ? "#comment 5 6\n" : "\n";
  }
  return text;
}

struct Outcome {
  std::vector<std::int64_t> values;  ///< of all records; 0 for those that were not read
  std::string message;
  std::string rest;  ///< the next word after the records
  std::size_t line;  ///< the number of its line
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Reads the records, of which the first is read alone.
Outcome read_lines(std::string_view text) {
  TextReader in(text, "f");
  std::vector<std::int64_t> values(many);
  const auto value = [&](TextReader& line, std::size_t i) {
    const std::int64_t number = line.integer("the number of a record", 0, many);
    if (number != static_cast<std::int64_t>(i)) line.fail("wrong number");
    values[i] = line.integer("a value", 0, 7 * many);
  };
  in.expect_record("record", 0, many);
  value(in, 0);
  read_records(in, "record", 1, many, value);
  const std::string message = in.failed() ? in.error().message : "";
  if (in.failed()) return {{}, message, "", 0};
  in.next_line();
  const std::string rest(in.word());
  return {std::move(values), message, rest, in.line()};
}

/// The outcome on one thread, which must be that on several threads.
Outcome outcome(const std::string& text) {
  Outcome first;
  with_threads([&](int threads) {
    Outcome each = read_lines(text);
    if (threads == 1) first = each;
    EXPECT_EQ(each.message, first.message) << threads << " threads";
    EXPECT_TRUE(each == first) << threads << " threads";
  });
  return first;
}

TEST(ReadRecords, gives_the_same_on_any_number_of_threads) {
  const Outcome all = outcome(lines_of(many) + "# comment\n\nnext");
  for (std::size_t i = 0; i < many; ++i) ASSERT_EQ(all.values[i], 7 * i);
  EXPECT_EQ(all.message, "");
  EXPECT_EQ(all.rest, "next");
}

TEST(ReadRecords, stops_behind_the_last_record) {
  const std::string records = lines_of(many);
  EXPECT_EQ(outcome(records).rest, "");
  EXPECT_EQ(outcome(records + lines_of(many)).rest, "0");
  EXPECT_EQ(outcome(records + lines_of(many)).line, outcome(records + "0").line);
  EXPECT_EQ(outcome(records.substr(0, records.size() - 1)).rest, "");
}

TEST(ReadRecords, reports_the_first_failure) {
  for (const std::vector<std::size_t>& wrong :
       {std::vector{many - 1, many / 2, std::size_t{1}}, {many - 1, many / 2}, {many - 1}}) {
    std::string text = lines_of(many);
    std::size_t at = 0;
    for (const std::size_t i : wrong) {
      at = text.find("\n" + std::to_string(i) + ' ') + 1;
      text[at] = 'x';
    }
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const std::string word = text.substr(at, text.find(' ', at) - at);
    EXPECT_EQ(outcome(text).message, "f:" + std::to_string(line) +
                                         ": expected the number of a record, a whole number, found \"" + word + "\"");
  }
}

TEST(ReadRecords, names_the_line_of_a_field_that_is_missing) {
  std::string text = lines_of(many);
  const std::size_t at = text.find("\n100001 ");
  text.erase(at + 7, 7);
  EXPECT_NE(outcome(text).message.find(": expected a value, a whole number, found the end of the line"),
            std::string::npos)
      << outcome(text).message;
}

TEST(ReadRecords, names_the_first_record_that_is_missing) {
  EXPECT_EQ(outcome("0 0\n").message, "f:2: expected record 2 of 120000, found the end of the file");
  const std::string text = lines_of(many - 1);
  EXPECT_EQ(outcome(text).message, "f:" + std::to_string(1 + std::count(text.begin(), text.end(), '\n')) +
                                       ": expected record 120000 of 120000, found the end of the file");
}

TEST(ReadRecords, may_have_lines_longer_than_blocks) {
  std::string text = lines_of(many);
  const std::string plain = text;
  text.insert(text.find("\n50002 ") + 1, "#" + std::string(3'000'000, '1') + "\n");
  text.insert(text.find("\n100001 ") + 1, std::string(1'000'000, ' '));
  EXPECT_EQ(outcome(text).values, outcome(plain).values);
  EXPECT_EQ(outcome(text).line, outcome(plain).line + 1);
}

TEST(ReadRecords, throws_what_the_first_record_throws) {
  const std::string text = lines_of(many);
  with_threads([&](int threads) {
    TextReader in(text, "f");
    try {
      read_records(in, "record", 0, many, [](TextReader&, std::size_t i) {
        if (i >= 50'000) throw std::runtime_error(std::to_string(i));
      });
      ADD_FAILURE() << "no exception on " << threads << " threads";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "50000") << threads << " threads";
    }
  });
}

TEST(ReadRecords, reads_nothing_after_a_failure) {
  const std::string text = lines_of(many);
  with_threads([&](int) {
    TextReader in(text, "f");
    in.fail("wrong");
    read_records(in, "record", 0, many, [](TextReader&, std::size_t) { ADD_FAILURE() << "a record was read"; });
    EXPECT_EQ(in.error().message, "f:1: wrong");
  });
}

}  // namespace
}  // namespace pardel::files
