#include "watched_cases.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <ctime>
#include <list>
#include <span>
#include <string>
#include <system_error>

namespace pardel::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

/// A child writes these words at the beginning of a line before a case, and when the case is drawn.
constexpr std::string_view begin_word = "begin ", drawn_word = "drawn ";

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void write_line(int to, std::string line) {
  line += '\n';
  for (std::size_t written = 0; written < line.size();) {
    const ssize_t count = write(to, line.data() + written, line.size() - written);
    if (count > 0)
      written += static_cast<std::size_t>(count);
    else if (errno != EINTR)
      _exit(1);  // the parent is gone
  }
}

/// The timer sends SIGPROF, which ends the process, after this processor time of all its threads.
void limit_processor_time(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - std::floor(seconds)) * 1e6);
  setitimer(ITIMER_PROF, &timer, nullptr);
}

[[noreturn]] void be_child(std::span<const std::uint64_t> numbers, double seconds, const RunCase& run, int to) {
  std::signal(SIGPROF, SIG_DFL);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  for (const std::uint64_t number : numbers) {
    write_line(to, std::string(begin_word) + std::to_string(number));
    limit_processor_time(seconds);
    const double before = processor_seconds();
    Record record = run(number, [&](const std::string& kinds) { write_line(to, std::string(drawn_word) + kinds); });
    record.number = number;
    record.seconds = processor_seconds() - before;
    write_line(to, to_line(record));
  }
  _exit(0);
}

class Child {
 public:
  Child(std::span<const std::uint64_t> numbers, const Watch& watch, const RunCase& run)
      : waiting_(numbers), most_seconds_(10 * watch.seconds) {
    int ends[2];
    if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "a pipe");
    pid_ = fork();
    if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "a process");
    if (pid_ == 0) {
      close(ends[0]);
      be_child(numbers, watch.seconds, run, ends[1]);
    }
    close(ends[1]);
    from_ = ends[0];
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() { close(from_); }

  [[nodiscard]] int from() const { return from_; }

  /// Reads what the child has written. Returns false when the child has ended.
  bool read_on(const std::function<void(const Record&)>& done) {
    char part[4096];
    const ssize_t count = read(from_, part, sizeof part);
    if (count < 0) return errno == EINTR;
    if (count == 0) return false;
    text_.append(part, static_cast<std::size_t>(count));
    for (std::size_t end; (end = text_.find('\n')) != std::string::npos; text_.erase(0, end + 1))
      take(text_.substr(0, end), done);
    return true;
  }

  /// Ends the child if a case takes too long by the clock: a deadlock takes no processor time.
  void end_if_late() {
    if (std::chrono::duration<double>(Clock::now() - begun_).count() < most_seconds_ || is_late_) return;
    is_late_ = true;
    kill(pid_, SIGKILL);
  }

  /// Waits for the child that has ended. If it ended within a case, makes the record of this case. Returns the numbers
  /// that are left.
  std::span<const std::uint64_t> finish(const std::function<void(const Record&)>& done) {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    if (waiting_.empty()) return {};
    Record record;
    record.number = waiting_.front();
    record.verdict = Record::Verdict::crash;
    record.kinds = kinds_;
    if (is_late_ || (WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF)) {
      record.verdict = Record::Verdict::time_out;
      record.seconds = most_seconds_ / 10;
      record.fault = is_late_ ? "waits" : "computes";
    } else if (WIFSIGNALED(status)) {
      record.fault = std::string("signal ") + strsignal(WTERMSIG(status));
    } else {
      record.fault = "exit status " + std::to_string(WEXITSTATUS(status));
    }
    done(record);
    return waiting_.subspan(1);
  }

 private:
  void take(const std::string& line, const std::function<void(const Record&)>& done) {
    if (line.starts_with(begin_word)) {
      kinds_ = "unknown";
      begun_ = Clock::now();
    } else if (line.starts_with(drawn_word)) {
      kinds_ = line.substr(drawn_word.size());
    } else if (const auto record = to_record(line)) {
      done(*record);
      waiting_ = waiting_.subspan(1);
    }
  }

  std::span<const std::uint64_t> waiting_;  ///< the first one is being run
  double most_seconds_;
  pid_t pid_ = -1;
  int from_ = -1;
  std::string text_, kinds_ = "unknown";
  Clock::time_point begun_ = Clock::now();
  bool is_late_ = false;
};

}  // namespace

void run_watched(const std::vector<std::uint64_t>& numbers, const Watch& watch, const RunCase& run,
                 const std::function<void(const Record&)>& done) {
  std::list<std::span<const std::uint64_t>> waiting;
  const std::size_t part = static_cast<std::size_t>(watch.per_process);
  for (std::size_t i = 0; i < numbers.size(); i += part)
    waiting.push_back(std::span(numbers).subspan(i, std::min(part, numbers.size() - i)));
  std::list<Child> children;
  while (!waiting.empty() || !children.empty()) {
    while (!waiting.empty() && children.size() < static_cast<std::size_t>(watch.jobs)) {
      children.emplace_back(waiting.front(), watch, run);
      waiting.pop_front();
    }
    std::vector<pollfd> polled;
    for (const Child& child : children) polled.push_back({child.from(), POLLIN, 0});
    constexpr int milliseconds = 1'000;
    if (poll(polled.data(), polled.size(), milliseconds) < 0 && errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "waiting for processes");
    auto child = children.begin();
    for (const pollfd& each : polled) {
      const bool has_ended = each.revents != 0 && !child->read_on(done);
      child->end_if_late();
      if (!has_ended) {
        ++child;
        continue;
      }
      if (const auto rest = child->finish(done); !rest.empty()) waiting.push_front(rest);
      child = children.erase(child);
    }
  }
}

}  // namespace pardel::fuzz
