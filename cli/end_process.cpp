#include "end_process.hpp"

#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "../core/support/output_file.hpp"
#include "exit_code.hpp"

namespace pardel::cli {
namespace {

/// Writes to standard error, unless it is a full pipe: a reader that does not read must not keep the process alive.
void write_message(const std::string& message) {
  (void)ftrylockfile(stderr);  // another thread then draws no progress after the message
  pollfd standard_error{STDERR_FILENO, POLLOUT, 0};
  if (::poll(&standard_error, 1, 0) == 1) (void)!::write(STDERR_FILENO, message.data(), message.size());
}

}  // namespace

void end_process(const Error& error) {
  const auto lock = remove_partial_files();
  write_message(fmt::format("{}pardel: {}\n", erase_progress_line(), error.message));
  _exit(static_cast<int>(exit_code(error.kind)));
}

}  // namespace pardel::cli
