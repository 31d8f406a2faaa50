#include "program.hpp"

#include <fcntl.h>
#include <pty.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace pardel::testing {
namespace fs = std::filesystem;
namespace {

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void limit(int resource, const std::optional<std::uint64_t>& bytes) {
  if (!bytes) return;
  const rlimit both = {*bytes, *bytes};
  setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

void redirect(int to, const char* file, int flags = O_WRONLY | O_CREAT | O_TRUNC) {
  const int fd = open(file, flags, 0600);
  if (fd < 0 || dup2(fd, to) < 0) _exit(99);
}

/// Runs in the child process; does not return.
[[noreturn]] void become_program(std::string program, const std::vector<std::string>& arguments,
                                 const RunOptions& options, const fs::path& folder, const std::string& out,
                                 const std::string& err, int terminal) {
  if (chdir(folder.c_str()) != 0) _exit(98);
  if (!options.in_file.empty()) redirect(STDIN_FILENO, options.in_file.c_str(), O_RDONLY);
  redirect(STDOUT_FILENO, options.out_file.empty() ? out.c_str() : options.out_file.c_str());
  if (terminal >= 0) {
    dup2(terminal, STDERR_FILENO);
  } else {
    redirect(STDERR_FILENO, err.c_str());
  }
  if (options.file_size_limit) {
    if (!options.file_size_signal) signal(SIGXFSZ, SIG_IGN);
    if (sanitized) setenv("TMPDIR", "/no-such-folder", 1);  // ThreadSanitizer would keep a large file there
  }
  limit(RLIMIT_FSIZE, options.file_size_limit);
  limit(RLIMIT_AS, options.address_space);
  limit(RLIMIT_STACK, options.stack_size);
  if (options.processor_time) {
    const rlimit soft = {*options.processor_time, *options.processor_time + 10};
    setrlimit(RLIMIT_CPU, &soft);
  }
  if (options.ignored_signal != 0) signal(options.ignored_signal, SIG_IGN);
  std::vector<std::string> copy = arguments;
  std::vector<char*> argv = {program.data()};
  for (std::string& argument : copy) argv.push_back(argument.data());
  argv.push_back(nullptr);
  execvp(program.c_str(), argv.data());
  _exit(127);
}

/// Returns everything that the child writes to a terminal. Sends the signal to the child when the text has
/// `interrupt_when`.
std::string shown(int terminal, pid_t child, const RunOptions& options) {
  std::string text;
  bool waiting = !options.interrupt_when.empty();
  char buffer[4096];
  for (ssize_t got; (got = ::read(terminal, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(got));
    if (!waiting || text.find(options.interrupt_when) == std::string::npos) continue;
    kill(child, options.signal);
    waiting = false;
  }
  return text;
}

void interrupt_once_seen(pid_t child, const RunOptions& options, const fs::path& err) {
  using namespace std::chrono_literals;
  for (int tries = 0; tries < 3000; ++tries, std::this_thread::sleep_for(10ms)) {
    if (contents(err).find(options.interrupt_when) != std::string::npos) break;
  }
  kill(child, options.signal);
}

}  // namespace

Workshop::Workshop() {
  std::string name = (fs::temp_directory_path() / "pardel-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = name;
  fs::create_directory(folder_ / "work");
}

bool terminals_exist() {
  int master = -1, slave = -1;
  if (openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) return false;
  close(slave);
  close(master);
  return true;
}

Workshop::~Workshop() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Ran Workshop::pardel(const std::vector<std::string>& arguments, const RunOptions& options) const {
  return run(PARDEL_PROGRAM, arguments, options);
}

Ran Workshop::run(const std::string& program, const std::vector<std::string>& arguments,
                  const RunOptions& options) const {
  const std::string out = folder_ / "stdout";
  const std::string err = folder_ / "stderr";
  fs::remove(err);
  int master = -1, slave = -1;
  if (options.terminal && openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) {
    throw std::runtime_error("no terminal");
  }
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) become_program(program, arguments, options, folder_ / "work", out, err, slave);
  Ran ran;
  if (slave >= 0) {
    close(slave);
    ran.err = shown(master, child, options);
    close(master);
  }
  if (!options.terminal && !options.interrupt_when.empty()) interrupt_once_seen(child, options, err);
  if (options.interrupt_after) {
    std::this_thread::sleep_for(std::chrono::duration<double>(*options.interrupt_after));
    kill(child, options.signal);  // has no effect if the program has ended
  }
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  ran.peak_memory = static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
  ran.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (options.out_file.empty()) ran.out = contents(out);
  if (!options.terminal) ran.err = contents(err);
  return ran;
}

nlohmann::json Workshop::report(std::vector<std::string> arguments, int code) const {
  arguments.insert(arguments.begin(), "mesh");
  arguments.insert(arguments.end(), {"--json", "-"});
  const Ran ran = pardel(arguments);
  EXPECT_EQ(ran.exit_code, code) << ran;
  return nlohmann::json::parse(ran.out, nullptr, false);
}

void Workshop::write(const std::string& name, std::string_view text) const {
  std::ofstream(folder_ / "work" / name, std::ios::binary) << text;
}

std::string Workshop::read(const std::string& name) const { return contents(folder_ / "work" / name); }

bool Workshop::exists(const std::string& name) const { return fs::exists(folder_ / "work" / name); }

Files Workshop::files() const {
  Files names;
  for (const auto& entry : fs::directory_iterator(folder_ / "work")) names.insert(entry.path().filename().string());
  return names;
}

std::vector<std::vector<double>> Workshop::table(const std::string& name) const {
  if (!exists(name)) throw std::runtime_error("no file " + name);
  std::istringstream in(read(name));
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<double> row;
    for (double number = 0; words >> number;) row.push_back(number);
    if (!row.empty()) rows.push_back(row);
  }
  return rows;
}

std::ostream& operator<<(std::ostream& out, const Ran& ran) {
  return out << "exit code " << ran.exit_code << "\n--- stdout\n" << ran.out << "--- stderr\n" << ran.err;
}

::testing::AssertionResult holds(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    if (text.find(part) == std::string::npos) {
      return ::testing::AssertionFailure() << "'" << part << "' is not in:\n" << text;
    }
  }
  return ::testing::AssertionSuccess();
}

}  // namespace pardel::testing
