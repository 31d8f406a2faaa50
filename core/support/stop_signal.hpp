// Ends a run early. All loops that can take long ask a StopSignal again and again.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "../result.hpp"

namespace pardel {

/// Thrown out of the loops of a run that has to end. The public functions catch it and return `error`.
struct Stopped {
  Error error;
};

/// Ends a run on all threads. A run ends if its question returns an error, or if stop() is called.
class StopSignal {
 public:
  using Clock = std::chrono::steady_clock;
  /// Returns an error if the run has to end.
  using Question = std::function<std::optional<Error>()>;
  /// The usual time from the answer to the next question. So the question may take longer than a step of a loop.
  static constexpr std::chrono::milliseconds usual_interval{4};

  /// For functions of the interface that the caller can stop: an error of the kind `cancelled` as soon as go_on()
  /// returns false. Never an error if there is no function go_on.
  [[nodiscard]] static Question unless(std::function<bool()> go_on) {
    return [go_on = std::move(go_on)]() -> std::optional<Error> {
      if (!go_on || go_on()) return {};
      return Error{ErrorKind::cancelled, "the caller asked to stop"};
    };
  }

  /// Only the thread that makes the signal asks the question.
  explicit StopSignal(Question question, Clock::duration interval = usual_interval)
      : question_(std::move(question)), interval_(interval) {}

  /// Throws Stopped if the run has to end. Thread-safe and cheap: the question is asked only if the interval has
  /// passed.
  void ask() {
    throw_if_stopped();
    if (std::this_thread::get_id() == asker_ && Clock::now() >= next_) ask_now();
  }
  /// Asks the question in any case. Precondition: this is the thread that made the signal.
  void ask_now() {
    throw_if_stopped();
    if (std::optional<Error> error = question_ ? question_() : std::nullopt) stop(*std::move(error));
    next_ = Clock::now() + interval_;
    throw_if_stopped();
  }

  /// Ends the run: every later ask() throws. If it is called again, the first error counts. Thread-safe.
  void stop(Error error) {
    const std::scoped_lock lock(stopping_);
    if (stopped()) return;
    error_ = std::move(error);
    stopped_.store(true, std::memory_order_release);
  }
  [[nodiscard]] bool stopped() const { return stopped_.load(std::memory_order_acquire); }

 private:
  void throw_if_stopped() const {
    if (stopped()) throw Stopped{*error_};
  }

  Question question_;
  Clock::duration interval_;
  Clock::time_point next_ = Clock::now();
  std::thread::id asker_ = std::this_thread::get_id();
  std::mutex stopping_;
  std::optional<Error> error_;
  std::atomic<bool> stopped_{false};
};

/// For loops over many items that take about a microsecond or less each: asks at the first call, and then at every
/// 1024th. The signal may be null.
class SparseAsk {
 public:
  explicit SparseAsk(StopSignal* stop) : stop_(stop) {}
  void operator()() {
    if (calls_++ % 1024 == 0 && stop_ != nullptr) stop_->ask();
  }

 private:
  StopSignal* stop_;
  std::uint32_t calls_ = 0;
};

/// Returns work(signal), where the signal asks go_on(); the error `cancelled` if that ended the work. The signal is
/// null if there is no function go_on.
template <class Work>
auto stoppable(const std::function<bool()>& go_on, const Work& work)
    -> decltype(work(static_cast<StopSignal*>(nullptr))) {
  if (!go_on) return work(nullptr);
  StopSignal stop(StopSignal::unless(go_on));
  try {
    return work(&stop);
  } catch (const Stopped& stopped) {
    return stopped.error;
  }
}

}  // namespace pardel
