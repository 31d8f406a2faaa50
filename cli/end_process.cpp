#include "end_process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdio>

#include "../core/support/short_lived.hpp"
#include "exit_code.hpp"

namespace pardel::cli {
namespace {

std::atomic<const char*>& process_name() {
  static std::atomic<const char*> name = "pardel";
  return name;
}

/// Writes to standard error, unless it is a full pipe: a reader that does not read must not keep the process alive.
void write_message(std::string_view message) {
  (void)ftrylockfile(stderr);  // another thread then draws no progress after the message
  pollfd standard_error{STDERR_FILENO, POLLOUT, 0};
  if (::poll(&standard_error, 1, 0) == 1) (void)!::write(STDERR_FILENO, message.data(), message.size());
}

}  // namespace

void name_process(const char* name) { process_name() = name; }

void end_process(ErrorKind kind, std::string_view message) {
  [[maybe_unused]] const auto lock = leave_nothing_behind();
  std::array<char, 512> text{};  // no memory is allocated, because there may be none left
  const auto written =
      fmt::format_to_n(text.data(), text.size(), "{}{}: {}\n", erase_progress_line(), process_name().load(), message);
  if (!message.empty()) write_message({text.data(), std::min(written.size, text.size())});
  _exit(static_cast<int>(exit_code(kind)));
}

}  // namespace pardel::cli
