#include "../../../core/formats/text_reader.hpp"

#include <gtest/gtest.h>
#include <omp.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <thread>

#include "../../../core/formats.hpp"
#include "../../temporary_folder.hpp"

namespace pardel::files {
namespace {

constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t high = std::numeric_limits<std::int64_t>::max();

std::string failure_of_number(std::string_view text) {
  TextReader in(text, "f");
  in.next_line();
  in.number("a number");
  return in.failed() ? in.error().message : "";
}

double number_in(std::string_view text) {
  TextReader in(text, "f");
  in.next_line();
  const double value = in.number("a number");
  EXPECT_FALSE(in.failed()) << in.error().message;
  return value;
}

std::string failure_of_integer(std::string_view text) {
  TextReader in(text, "f");
  in.next_line();
  in.integer("a count", 0, 9);
  return in.failed() ? in.error().message : "";
}

TEST(ReadFile, skips_a_byte_order_mark_at_the_beginning_only) {
  const TemporaryFolder folder;
  for (const auto& [written, expected] : {std::pair{"\xEF\xBB\xBF"
                                                    "1 2",
                                                    "1 2"},
                                          {"1\xEF\xBB\xBF", "1\xEF\xBB\xBF"},
                                          {"\xEF\xBB", "\xEF\xBB"}}) {
    const auto text = read_file(folder.write("file", written));
    ASSERT_TRUE(text.ok());
    EXPECT_EQ(std::string_view(*text), expected);
  }
  EXPECT_TRUE(parse_poly("\xEF\xBB\xBF"
                         "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n0 0\n0\n",
                         "text")
                  .ok());
}

TEST(TextReader, skips_blank_lines_and_comments) {
  TextReader in("\n  \t\n# one\n   # two\n 7 # seven\r\n\r\n8#eight\n9", "f");
  for (const int expected : {7, 8, 9}) {
    ASSERT_TRUE(in.next_line());
    EXPECT_EQ(in.integer("a number", low, high), expected);
    EXPECT_FALSE(in.has_field());
  }
  EXPECT_FALSE(in.next_line());
  EXPECT_FALSE(in.failed());
}

TEST(TextReader, ignores_fields_that_are_not_read) {
  TextReader in("1 garbage \x01\x02\n2\n", "f");
  ASSERT_TRUE(in.next_line());
  EXPECT_EQ(in.integer("a number", low, high), 1);
  ASSERT_TRUE(in.next_line());
  EXPECT_EQ(in.integer("a number", low, high), 2);
}

TEST(TextReader, reads_numbers_in_every_usual_spelling) {
  EXPECT_EQ(number_in("+1.5"), 1.5);
  EXPECT_EQ(number_in("-.5e+01"), -5);
  EXPECT_EQ(number_in("1."), 1);
  EXPECT_EQ(number_in("0.1"), 0.1);
  EXPECT_EQ(number_in("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(number_in("1.7976931348623157e308"), std::numeric_limits<double>::max());
}

TEST(TextReader, fails_at_a_field_that_is_no_finite_number_and_quotes_it) {
  for (const char* token : {"nan", "NaN", "inf", "-inf", "infinity", "1e400"}) {
    EXPECT_EQ(failure_of_number(token),
              "f:1: expected a number, finite and within the range of a double, found \"" + std::string(token) + "\"");
  }
  for (const char* token : {"abc", "1,5", "1d5", "0x10", "--1", "+-1", "++1", "+", "-", "1.5.2"}) {
    EXPECT_EQ(failure_of_number(token), "f:1: expected a number, found \"" + std::string(token) + "\"");
  }
}

TEST(TextReader, fails_at_a_field_that_is_no_integer_in_range) {
  EXPECT_EQ(failure_of_integer("3.0"), "f:1: expected a count, a whole number, found \"3.0\"");
  EXPECT_EQ(failure_of_integer("x"), "f:1: expected a count, a whole number, found \"x\"");
  EXPECT_EQ(failure_of_integer("10"), "f:1: expected a count, a whole number from 0 to 9, found \"10\"");
  EXPECT_EQ(failure_of_integer("-1"), "f:1: expected a count, a whole number from 0 to 9, found \"-1\"");
  EXPECT_EQ(failure_of_integer("99999999999999999999"),
            "f:1: expected a count, a whole number from 0 to 9, found \"99999999999999999999\"");
}

TEST(TextReader, distinguishes_the_end_of_a_line_from_the_end_of_the_file) {
  EXPECT_EQ(failure_of_number("# only a comment\n"), "f:2: expected a number, found the end of the file");
  TextReader in("1\n2", "f");
  ASSERT_TRUE(in.next_line());
  in.number("a number");
  in.number("another");
  ASSERT_TRUE(in.failed());
  EXPECT_EQ(in.error().message, "f:1: expected another, found the end of the line");
}

TEST(TextReader, keeps_the_first_failure) {
  TextReader in("a\nb\n", "f");
  in.next_line();
  in.number("a number");
  in.next_line();
  in.fail("something else");
  EXPECT_EQ(in.error().message, "f:1: expected a number, found \"a\"");
}

TEST(TextReader, after_a_failure_gives_the_number_that_stands_for_a_missing_one) {
  TextReader in("a 7", "f");
  in.next_line();
  EXPECT_EQ(in.integer("a number", low, high), 0);
  EXPECT_EQ(in.integer_or("another", low, high, 3), 3);
  EXPECT_EQ(in.integer("a third", low, high), 0);
  EXPECT_EQ(in.number("a fourth"), 0);
}

TEST(TextReader, takes_tabs_and_the_characters_of_old_printers_as_blanks) {
  TextReader in("1\t2\v3\f4\r\n", "f");
  ASSERT_TRUE(in.next_line());
  for (const double expected : {1, 2, 3, 4}) EXPECT_EQ(in.number("a number"), expected);
}

TEST(TextReader, gives_the_rest_of_a_line_without_the_blanks_around_it) {
  TextReader in("name  \t of  it \t\r\nempty   \nlast", "f");
  ASSERT_TRUE(in.next_line());
  EXPECT_EQ(in.word(), "name");
  EXPECT_EQ(in.rest_of_line(), "of  it");
  EXPECT_EQ(in.rest_of_line(), "");
  ASSERT_TRUE(in.next_line());
  EXPECT_EQ(in.word(), "empty");
  EXPECT_EQ(in.rest_of_line(), "");
  ASSERT_TRUE(in.next_line());
  EXPECT_EQ(in.rest_of_line(), "last");
}

TEST(TextReader, fails_at_a_count_that_is_too_large_for_the_text) {
  TextReader exact("1 2\n3 4", "f");  // two records of two fields, the last without its newline
  EXPECT_TRUE(exact.room_for(2, text_bytes(2), "things"));
  EXPECT_FALSE(exact.room_for(3, text_bytes(2), "things"));
  EXPECT_EQ(exact.error().message, "f:1: announces 3 things, but the rest of the file is too short for that");
  TextReader absurd("1\n", "f");
  EXPECT_FALSE(absurd.room_for(std::numeric_limits<std::size_t>::max(), text_bytes(2), "things"));
}

TEST(TextReader, quotes_unprintable_bytes_in_hexadecimal_and_shortens_long_fields) {
  EXPECT_EQ(in_quotes(std::string_view("a\x1b[\0\"\\", 6)), "\"a\\x1b[\\x00\\x22\\x5c\"");
  EXPECT_EQ(in_quotes(" !~\x7f\x1f"), "\" !~\\x7f\\x1f\"");
  EXPECT_EQ(in_quotes(std::string(40, 'x')), "\"" + std::string(40, 'x') + "\"");
  EXPECT_EQ(in_quotes(std::string(50, 'x')), "\"" + std::string(40, 'x') + "...\"");
}

TEST(TextReader, gives_places_in_bytes_after_binary_data) {
  TextReader in("head\n12345678", "f");
  in.next_line();
  EXPECT_EQ(in.word(), "head");
  in.end_line();
  EXPECT_EQ(in.bytes(4, "data"), "1234");
  EXPECT_TRUE(in.bytes(5, "more data").empty());
  EXPECT_EQ(in.error().message, "f: byte 9: expected more data (5 bytes), found the end of the file after 4 bytes");
}

TEST(ReadFile, names_a_file_that_does_not_exist) {
  const auto result = read_file("/nowhere/a file.poly");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::io);
  EXPECT_EQ(result.error().message, "/nowhere/a file.poly: cannot be opened: No such file or directory");
}

TEST(ReadFile, refuses_a_folder) {
  const TemporaryFolder folder;
  const auto result = read_file(folder / "");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::io);
}

TEST(ReadFile, returns_all_bytes) {
  const TemporaryFolder folder;
  const std::string bytes("\0\xff\r\n#", 5);
  EXPECT_EQ(std::string_view(*read_file(folder.write("with spaces.bin", bytes))), bytes);
}

TEST(ReadFile, returns_all_bytes_of_a_large_file) {
  const TemporaryFolder folder;
  std::string bytes = "\xEF\xBB\xBF";
  for (std::uint32_t i = 0; bytes.size() < (std::size_t{1} << 24) + 11; ++i) bytes += std::to_string(i * 2654435761U);
  const auto file = folder.write("large", bytes);
  const int threads = omp_get_max_threads();
  for (const int n : {1, 3, 7}) {
    omp_set_num_threads(n);
    EXPECT_TRUE(std::string_view(*read_file(file)) == std::string_view(bytes).substr(3)) << n;
  }
  omp_set_num_threads(threads);
}

/// The size of a pipe is not known. The lengths are about those at which the memory for its bytes grows.
TEST(ReadFile, returns_all_bytes_of_a_pipe) {
  const TemporaryFolder folder;
  const auto pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string bytes;
  for (std::uint32_t i = 0; bytes.size() < 300'000; ++i) bytes += std::to_string(i * 2654435761U);
  for (const std::size_t length : {0U, 5U, 65'535U, 65'536U, 65'537U, 131'071U, 131'072U, 131'073U, 300'000U}) {
    const std::string_view written = std::string_view(bytes).substr(0, length);
    std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << written; });
    const auto text = read_file(pipe);
    writer.join();
    ASSERT_TRUE(text) << text.error().message;
    EXPECT_TRUE(std::string_view(*text) == written) << length;
  }
}

/// Then the other threads cannot open the file.
TEST(ReadFile, returns_all_bytes_of_a_large_file_if_no_second_file_can_be_open) {
  const TemporaryFolder folder;
  const auto file = folder.write("large", "text");
  std::filesystem::resize_file(file, std::size_t{1} << 24);
  (void)omp_get_max_threads();  // libomp opens a file of its own when it starts
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &old), 0);
  const int next = dup(0);
  close(next);
  const rlimit one_more{static_cast<rlim_t>(next) + 1, old.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &one_more), 0);
  const auto text = read_file(file);
  setrlimit(RLIMIT_NOFILE, &old);
  ASSERT_TRUE(text) << text.error().message;
  EXPECT_EQ(std::string_view(*text).size(), std::size_t{1} << 24);
  EXPECT_TRUE(std::string_view(*text).starts_with("text"));
}

TEST(TextReader, tells_whether_there_is_the_line_that_it_expects) {
  TextReader in("# comment\n\n7\n", "f");
  EXPECT_TRUE(in.expect_line("a number"));
  EXPECT_EQ(in.integer("a number", 0, 9), 7);
  EXPECT_FALSE(in.expect_line("another number"));
  EXPECT_TRUE(in.failed());
}

TEST(TextReader, reads_no_digit_after_the_end_of_its_text) {
  TextReader in(std::string_view("12345").substr(0, 3), "f");
  ASSERT_TRUE(in.next_line());
  EXPECT_EQ(in.integer("a number", low, high), 123);
  EXPECT_FALSE(in.failed());
  TextReader again(std::string_view("12345").substr(0, 3), "f");
  ASSERT_TRUE(again.next_line());
  EXPECT_EQ(again.number("a number"), 123);
}

TEST(TextReader, finds_no_line_after_the_end_of_its_text) {
  for (const std::string text : {"7\n8\n", "7\n\n8\n", "7\n", "7#\n8", "7 8\n", "7\r\n8\n"})
    for (const std::size_t length : {std::size_t{1}, text.find('\n')}) {
      TextReader in(std::string_view(text).substr(0, length), "f");
      ASSERT_TRUE(in.next_line());
      EXPECT_EQ(in.integer("a number", low, high), 7);
      EXPECT_FALSE(in.next_line()) << text;
      in.end_line();
      EXPECT_FALSE(in.next_field()) << text;
      EXPECT_EQ(in.rest(), "");
      EXPECT_FALSE(in.expect_line("another number"));
      EXPECT_EQ(in.error().message, "f:1: expected another number, found the end of the file");
    }
  TextReader empty(std::string_view(), "f");
  empty.end_line();
  EXPECT_FALSE(empty.next_line());
}

TEST(TextReader, gives_nothing_after_a_failure) {
  TextReader in("1 two 3\n4 5 6\n", "f");
  ASSERT_TRUE(in.next_line());
  in.fail("wrong");
  EXPECT_EQ(in.word(), "");
  EXPECT_EQ(in.rest_of_line(), "");
  EXPECT_EQ(in.number("a number"), 0);
  EXPECT_EQ(in.integer("a number", low, high), 0);
  EXPECT_EQ(in.integer_or("a number", low, high, 7), 7);
  EXPECT_EQ(in.count("a number"), 0U);
  EXPECT_EQ(in.bytes(1, "a byte"), "");
  EXPECT_FALSE(in.next_line());
  EXPECT_FALSE(in.next_field());
  in.fail("later");
  EXPECT_EQ(in.error().message, "f:1: wrong");
}

TEST(TextReader, closes_the_files_that_it_reads) {
  const TemporaryFolder folder;
  const auto file = folder.write("f", "text");
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &old), 0);
  const rlimit few{64, old.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &few), 0);
  for (int i = 0; i < 200; ++i) EXPECT_TRUE(read_file(file));
  setrlimit(RLIMIT_NOFILE, &old);
}

}  // namespace
}  // namespace pardel::files
