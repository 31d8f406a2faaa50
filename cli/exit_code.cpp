#include "exit_code.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

namespace pardel::cli {

ExitCode exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return ExitCode::usage;
    case ErrorKind::invalid_input:
      return ExitCode::invalid_input;
    case ErrorKind::io:
    case ErrorKind::resources:
      return ExitCode::failure;
    case ErrorKind::cancelled:
      return ExitCode::interrupted;
    case ErrorKind::internal:
      return ExitCode::internal;
  }
  return ExitCode::failure;
}

ExitCode report(const Error& error, std::string_view program) {
  print_on_stderr(
      fmt::format("{}: {}{}\n", program, error.kind == ErrorKind::internal ? "internal error: " : "", error.message));
  return exit_code(error.kind);
}

const char* erase_progress_line() { return isatty(STDERR_FILENO) == 1 ? "\r\033[K" : ""; }

void warn(const std::string& message, std::string_view program) {
  print_on_stderr(fmt::format("{}{}: {}\n", erase_progress_line(), program, message));
}

void print_on_stderr(std::string_view text) { (void)std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace pardel::cli
