#include "../../../core/support/output_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <thread>

#include "../../../core/formats.hpp"
#include "../../../core/formats/records.hpp"
#include "../../../core/support/leftover_files.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"

namespace pardel {
using namespace files;
namespace {

namespace fs = std::filesystem;
using enum OutputFile::Aside;

/// The end of the name of a partial file that this process is about to make: of the next one, or of a later one.
std::string partial_suffix(int later = 0) {
  const TemporaryFolder folder;
  const OutputFile probe(folder / "probe", named);
  const std::string name = folder.names();  // "probe.SPACE-PROCESS-NUMBER.partial "
  const int number = std::stoi(name.substr(name.rfind('-') + 1)) + 1 + later;
  const std::string next = partial_name("", static_cast<std::uint64_t>(number)).string();  // ".SPACE-..."
  return next.substr(1);
}

/// True where a file can be written without a name.
bool files_can_be_unnamed(const TemporaryFolder& folder) { return OutputFile(folder / "probe").is_unnamed(); }

TEST(OutputFile, gets_its_name_only_when_it_is_complete) {
  const TemporaryFolder folder;
  folder.write("a b.txt", "old");
  const std::string suffix = partial_suffix();
  OutputFile out(folder / "a b.txt", named);
  out.write("new");
  EXPECT_EQ(folder.names(), "a b.txt a b.txt." + suffix + " ");
  EXPECT_EQ(folder.read("a b.txt"), "old");
  ASSERT_TRUE(out.commit().ok());
  EXPECT_EQ(folder.names(), "a b.txt ");
  EXPECT_EQ(folder.read("a b.txt"), "new");
}

TEST(OutputFile, has_no_name_before_where_the_file_system_allows_it) {
  const TemporaryFolder folder;
  if (!files_can_be_unnamed(folder)) GTEST_SKIP() << "not here";
  for (const std::string before : {"", "a.txt "}) {
    OutputFile out(folder / "a.txt");
    out.write("new " + before);
    EXPECT_EQ(folder.names(), before);
    ASSERT_TRUE(out.close().ok());
    EXPECT_EQ(folder.names(), before);
    ASSERT_TRUE(out.commit().ok());
    EXPECT_EQ(folder.names(), "a.txt ");
    EXPECT_EQ(folder.read("a.txt"), "new " + before);
  }
}

TEST(OutputFile, replaces_a_file_that_got_the_name_meanwhile) {
  const TemporaryFolder folder;
  OutputFile out(folder / "a.txt");
  out.write("new");
  folder.write("a.txt", "of another process");
  ASSERT_TRUE(out.commit().ok());
  EXPECT_EQ(folder.names(), "a.txt ");
  EXPECT_EQ(folder.read("a.txt"), "new");
}

TEST(OutputFile, can_be_opened_by_another_descriptor_before_it_has_its_name) {
  for (const OutputFile::Aside aside : {unnamed, named}) {
    const TemporaryFolder folder;
    OutputFile out(folder / "a.txt", aside);
    const int other = ::open(out.written().c_str(), O_WRONLY);
    ASSERT_GE(other, 0);
    EXPECT_EQ(::pwrite(other, "new", 3, 0), 3);
    ::close(other);
    ASSERT_TRUE(out.commit().ok());
    EXPECT_EQ(folder.read("a.txt"), "new");
  }
}

TEST(OutputFile, whose_name_has_no_room_for_a_partial_name_is_refused_at_once) {
  const TemporaryFolder folder;
  for (const OutputFile::Aside aside : {unnamed, named}) {
    const OutputFile out(folder / std::string(240, 'a'), aside);
    EXPECT_FALSE(out.ok());
  }
  EXPECT_EQ(folder.names(), "");
}

/// Under UndefinedBehaviorSanitizer this failed: the bytes of an empty array are a null pointer. Found by the fuzz
/// target
/// read_off, with a mesh without points.
TEST(OutputFile, accepts_the_bytes_of_an_empty_array) {
  const TemporaryFolder folder;
  OutputFile out(folder / "empty");
  out.write(std::string_view());
  ASSERT_TRUE(out.commit().ok());
  EXPECT_EQ(folder.read("empty"), "");
}

TEST(OutputFile, leaves_all_files_alone_that_it_has_not_made) {
  const TemporaryFolder folder;
  folder.write("a.txt.partial", "of the user");
  const std::string taken = "a.txt." + partial_suffix(1);
  folder.write(taken, "of an earlier process with the same number");
  fs::create_directory(folder / ("a.txt." + partial_suffix(1)));
  const std::string before = folder.names();
  {
    OutputFile out(folder / "a.txt", named), again(folder / "a.txt", named);
    out.write("new");
    again.write("newer");
    ASSERT_TRUE(out.commit().ok());
    ASSERT_TRUE(again.commit().ok());
  }
  EXPECT_EQ(folder.names(), "a.txt " + before);
  EXPECT_EQ(folder.read("a.txt"), "newer");
  EXPECT_EQ(folder.read("a.txt.partial"), "of the user");
  EXPECT_EQ(folder.read(taken), "of an earlier process with the same number");
}

TEST(OutputFile, that_cannot_be_written_aside_removes_nothing) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "a.txt.partial");
  { OutputFile out(folder / "a.txt"); }
  EXPECT_EQ(folder.names(), "a.txt.partial ");
}

TEST(OutputFile, has_the_permissions_of_a_new_file) {
  const TemporaryFolder folder;
  for (const OutputFile::Aside aside : {unnamed, named}) {
    const mode_t before = ::umask(027);
    OutputFile out(folder / "a.txt", aside);
    EXPECT_TRUE(out.commit().ok());
    ::umask(before);
    using enum fs::perms;
    EXPECT_EQ(fs::status(folder / "a.txt").permissions(), owner_read | owner_write | group_read);
  }
}

TEST(OutputFile, leaves_no_file_without_commit) {
  const TemporaryFolder folder;
  for (const OutputFile::Aside aside : {unnamed, named}) {
    OutputFile(folder / "a.txt", aside).write("half");
    EXPECT_EQ(folder.names(), "");
    OutputFile closed(folder / "a.txt", aside);
    EXPECT_TRUE(closed.close().ok());
  }
  EXPECT_EQ(folder.names(), "");
}

TEST(OutputFile, that_is_partial_is_removed_if_the_process_has_to_end) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  OutputFile out(folder / "a.txt", named);
  out.write("new");
  { const auto lock = remove_partial_files(); }
  EXPECT_EQ(folder.names(), "a.txt ");
  EXPECT_FALSE(out.commit().ok());
  EXPECT_EQ(folder.read("a.txt"), "old");
}

TEST(OutputFile, that_has_its_name_stays_if_the_process_has_to_end) {
  const TemporaryFolder folder;
  OutputFile out(folder / "a.txt");
  ASSERT_TRUE(out.commit().ok());
  { const auto lock = remove_partial_files(); }
  EXPECT_EQ(folder.names(), "a.txt ");
}

TEST(OutputFile, is_neither_made_nor_renamed_while_the_process_ends) {
  const TemporaryFolder folder;
  auto lock = remove_partial_files();
  std::atomic<bool> started{false};
  std::thread writer([&] {
    started = true;
    OutputFile out(folder / "a.txt");
    EXPECT_TRUE(out.commit().ok());
  });
  while (!started) std::this_thread::yield();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // enough for a writer that does not wait
  EXPECT_EQ(folder.names(), "");
  lock.unlock();
  writer.join();
  EXPECT_EQ(folder.names(), "a.txt ");
}

TEST(OutputFile, replaces_the_target_of_a_symbolic_link) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  fs::create_symlink("file", folder / "link");
  OutputFile out(folder / "link");
  out.write("new");
  ASSERT_TRUE(out.commit().ok());
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(folder.read("file"), "new");
}

TEST(OutputFile, is_made_where_symbolic_links_lead) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "elsewhere");
  fs::create_symlink("../new", folder / "elsewhere" / "second");
  fs::create_symlink("elsewhere/second", folder / "link");
  OutputFile out(folder / "link");
  out.write("new");
  ASSERT_TRUE(out.commit().ok());
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_TRUE(fs::is_symlink(folder / "elsewhere" / "second"));
  EXPECT_EQ(folder.read("new"), "new");
}

TEST(OutputFile, whose_links_lead_in_a_circle_is_refused) {
  const TemporaryFolder folder;
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  OutputFile out(folder / "a");
  const Status placed = out.commit();
  ASSERT_FALSE(placed.ok());
  EXPECT_NE(placed.error().message.find((folder / "a").string() + ": cannot be opened for writing: Too many levels"),
            std::string::npos)
      << placed.error().message;
  EXPECT_EQ(folder.names(), "a b ");
}

TEST(OutputFile, is_written_beside_the_target_of_a_symbolic_link) {
  const TemporaryFolder folder;
  folder.write("elsewhere/file", "old");
  fs::create_symlink("elsewhere/file", folder / "link");
  const std::string suffix = partial_suffix();
  const OutputFile out(folder / "link", named);
  EXPECT_TRUE(fs::exists(folder / ("elsewhere/file." + suffix)));
  EXPECT_EQ(folder.names(), "elsewhere link ");
}

TEST(OutputFile, that_cannot_get_its_name_is_an_io_error_with_its_name) {
  const TemporaryFolder folder;
  OutputFile out(folder / "a.txt");
  fs::create_directory(folder / "a.txt");
  const Status status = out.commit();
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, ErrorKind::io);
  EXPECT_EQ(message_of(status, folder), "a.txt: cannot be put in place: Is a directory");
  EXPECT_FALSE(out.ok());
}

/// The second file cannot get its name, because a folder has it now.
Status commit_blocked(const TemporaryFolder& folder) {
  std::deque<OutputFile> files;
  for (const char* name : {"a.txt", "b.txt", "c.txt"}) files.emplace_back(folder / name).write("new");
  fs::create_directory(folder / "b.txt");
  return commit_all(files);
}

TEST(OutputFiles, that_get_their_names_together_put_back_what_they_replaced) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  folder.write("c.txt", "old");
  fs::create_hard_link(folder / "a.txt", folder / "same");
  EXPECT_EQ(message_of(commit_blocked(folder), folder), "b.txt: cannot be put in place: Is a directory");
  EXPECT_EQ(folder.names(), "a.txt b.txt c.txt same ");
  EXPECT_EQ(folder.read("a.txt"), "old");
  EXPECT_TRUE(fs::equivalent(folder / "a.txt", folder / "same")) << "it is a copy";
  EXPECT_EQ(folder.read("c.txt"), "old");
}

TEST(OutputFiles, that_get_their_names_together_leave_no_name_that_was_not_there_before) {
  const TemporaryFolder folder;
  EXPECT_FALSE(commit_blocked(folder).ok());
  EXPECT_EQ(folder.names(), "b.txt ");
}

TEST(OutputFiles, keep_their_names_only_if_all_agree) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  for (const bool agree : {false, true}) {
    std::deque<OutputFile> files;
    files.emplace_back(folder / "a.txt").write("new");
    files.emplace_back(folder / "b.txt").write("new");
    const Status done = commit_all(files, [&](const Status& placed) {
      EXPECT_TRUE(placed.ok());
      EXPECT_EQ(folder.read("a.txt"), "new");
      return agree ? placed : Status(Error{ErrorKind::io, "another process has failed"});
    });
    EXPECT_EQ(done.ok(), agree);
    EXPECT_EQ(folder.names(), agree ? "a.txt b.txt " : "a.txt ");
    EXPECT_EQ(folder.read("a.txt"), agree ? "new" : "old");
  }
}

TEST(OutputFile, that_has_its_name_removes_no_later_file_with_the_name_of_its_partial_file) {
  const TemporaryFolder folder;
  const std::string partial = "a.txt." + partial_suffix();
  {
    OutputFile out(folder / "a.txt", named);
    ASSERT_TRUE(out.commit().ok());
    folder.write(partial, "of the user");
  }
  EXPECT_EQ(folder.names(), "a.txt " + partial + " ");
}

TEST(OutputFile, that_cannot_be_opened_is_an_io_error_with_its_name) {
  OutputFile out("/nowhere/a.txt");
  EXPECT_FALSE(out.ok());
  out.write("x");
  const Status status = out.commit();
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, ErrorKind::io);
  EXPECT_EQ(status.error().message, "/nowhere/a.txt: cannot be opened for writing: No such file or directory");
}

TEST(OutputFile, reports_a_full_disk_even_if_only_closing_finds_it) {
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{1} << 20}) {
    OutputFile out("/dev/full");
    out.write(std::string(bytes, 'x'));
    const Status status = out.commit();
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().kind, ErrorKind::io);
    EXPECT_EQ(status.error().message, "/dev/full: cannot be written: No space left on device");
  }
  EXPECT_TRUE(fs::exists("/dev/full"));
  EXPECT_FALSE(fs::exists("/dev/full.partial"));
}

TEST(OutputFile, writes_to_devices_directly) {
  OutputFile out("/dev/null");
  out.write("x");
  EXPECT_TRUE(out.commit().ok());
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST(OutputFile, below_dev_is_written_aside_if_it_is_a_regular_file) {
  if (!fs::is_directory("/dev/shm")) GTEST_SKIP() << "there is no /dev/shm";
  const fs::path file = "/dev/shm/pardel-test-" + std::to_string(::getpid());
  const std::string suffix = partial_suffix();
  OutputFile out(file, named);
  out.write("x");
  EXPECT_FALSE(fs::exists(file)) << "the file appears under its name before it is complete";
  EXPECT_TRUE(fs::exists(file.string() + "." + suffix));
  EXPECT_TRUE(out.commit().ok());
  EXPECT_TRUE(fs::is_regular_file(file));
  fs::remove(file);
}

TEST(OutputFile, of_an_open_file_continues_where_the_file_is) {
  const TemporaryFolder folder;
  std::FILE* open = std::fopen((folder / "a").c_str(), "wb");
  ASSERT_NE(open, nullptr);
  std::fputs("first ", open);
  std::fflush(open);
  OutputFile out("/dev/fd/" + std::to_string(fileno(open)));
  out.write("second ");
  EXPECT_TRUE(out.commit().ok());
  std::fputs("third", open);
  std::fclose(open);
  EXPECT_EQ(folder.read("a"), "first second third");
  EXPECT_EQ(folder.names(), "a ");
}

TEST(OutputFile, writes_to_standard_output_if_there_is_no_standard_input) {
  EXPECT_EXIT(
      {
        close(0);  // the next file that is opened gets the number 0
        OutputFile out("-");
        std::exit(out.commit().ok() ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

/// A pipe that is full and does not wait refuses what is written. Its descriptor is closed before the file, so closing
/// the file fails, too, and for another reason.
TEST(OutputFile, reports_its_first_failure_whatever_fails_later) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_NONBLOCK), 0);
  while (::write(ends[1], "x", 1) == 1) {
  }
  const std::string name = "/dev/fd/" + std::to_string(ends[1]);
  const int next = ::dup(ends[1]);  // the number of the next descriptor, when this one is closed again
  ::close(next);
  OutputFile out(name);
  out.write(std::string(std::size_t{1} << 20, 'x'));
  EXPECT_FALSE(out.ok());
  ASSERT_EQ(::close(next), 0) << "the file has another descriptor";
  EXPECT_EQ(out.commit().error().message, name + ": cannot be written: Resource temporarily unavailable");
  for (const int end : ends) ::close(end);
}

TEST(OutputFile, that_is_not_open_is_an_io_error) {
  OutputFile out("/dev/fd/987");
  EXPECT_EQ(out.commit().error().message, "/dev/fd/987: cannot be opened for writing: Bad file descriptor");
}

TEST(Writers, report_a_full_disk) {
  const Mesh mesh = sample_mesh();
  const fs::path full = "/dev/full";
  for (const Status& status :
       {write_vtu(mesh, full), write_off(mesh, full), write_svg(mesh, full), write_svg(Pslg{}, full),
        write_msh(mesh, full, MshEncoding::ascii), write_msh(mesh, full, MshEncoding::binary), write_poly({}, full)}) {
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().kind, ErrorKind::io);
  }
}

TEST(Writers, of_several_files_leave_none_if_one_fails) {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/full", folder / "m.ele");
  const Status status = write_mesh(sample_mesh(), {}, folder / "m.node");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(message_of(status, folder), "m.ele: cannot be written: No space left on device");
  EXPECT_EQ(folder.names(), "m.ele ");
}

TEST(Writers, that_cannot_open_a_file_leave_none) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "m.poly");
  EXPECT_EQ(message_of(write_mesh(sample_mesh(), {}, folder / "m.node"), folder),
            "m.poly: cannot be opened for writing: Is a directory");
  EXPECT_EQ(folder.names(), "m.poly ");
}

TEST(Records, are_written_in_order_across_all_blocks) {
  const TemporaryFolder folder;
  constexpr std::size_t n = 200'000;
  std::string expected;
  for (std::size_t i = 0; i < n; ++i) expected += std::to_string(i) + "\n";
  OutputFile out(folder / "a");
  write_records(out, n, [](Bytes& to, std::size_t i) { to << i << '\n'; });
  ASSERT_TRUE(out.commit().ok());
  EXPECT_EQ(folder.read("a"), expected);
}

TEST(Records, have_the_shortest_numbers_that_read_back) {
  EXPECT_EQ((Bytes() << 0.1 << ' ' << 1.0 / 3 << ' ' << 1e21 << ' ' << -0.0).view(), "0.1 0.3333333333333333 1e+21 -0");
}

}  // namespace
}  // namespace pardel
