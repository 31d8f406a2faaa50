#include "../in_processes.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../../core/support/shortest.hpp"
#include "../../core/support/stop_signal.hpp"
#include "../subdomains/without_triangles.hpp"
#include "channel.hpp"
#include "messages.hpp"
#include "starter.hpp"

namespace pardel {

using namespace engine;

namespace {

using Ending = RefinedSubdomain::Ending;

/// Numbers that are free to be used by one thread at a time.
class FreeNumbers {
 public:
  explicit FreeNumbers(Index count) {
    for (Index i = count; i > 0; --i) free_.push_back(i - 1);
  }

  /// Waits until a number is free.
  Index take() {
    std::unique_lock lock(mutex_);
    is_free_.wait(lock, [&] { return !free_.empty(); });
    const Index number = free_.back();
    free_.pop_back();
    return number;
  }
  void give_back(Index number) {
    {
      const std::scoped_lock lock(mutex_);
      free_.push_back(number);
    }
    is_free_.notify_one();
  }

 private:
  std::mutex mutex_;
  std::condition_variable is_free_;
  std::vector<Index> free_;
};

class ProcessesMesher final : public SubdomainMesher {
 public:
  ProcessesMesher(std::unique_ptr<SubdomainMesher> mesher, std::unique_ptr<Starter> starter, Index workers)
      : mesher_(std::move(mesher)), starter_(std::move(starter)), workers_(workers), free_(workers) {}

  [[nodiscard]] MesherAbilities abilities() const override {
    MesherAbilities abilities = mesher_->abilities();
    abilities.is_thread_safe = true;
    return abilities;
  }

  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    constexpr double part_of_time = 0.9;
    const Channel::Bytes request = to_bytes(subdomain, part_of_time * subdomain.seconds);
    const Turn turn(free_);
    Worker& worker = workers_[turn.number];
    if (!worker.channel) {
      Result<Channel> started = starter_->start(turn.number);
      if (!started) return without_triangles(Ending::failed, started.error().message);
      worker.channel = std::move(started).value();
    }
    RefinedSubdomain answer;
    const Channel::Outcome outcome = ask(worker, request, subdomain.seconds, answer);
    if (outcome == Channel::Outcome::done) return answer;
    worker.channel.reset();
    const std::string how = starter_->end(turn.number);
    switch (outcome) {
      case Channel::Outcome::closed:
        return without_triangles(Ending::crashed, how);
      case Channel::Outcome::late:
        return without_triangles(Ending::timed_out, "no answer in " + shortest(subdomain.seconds) + " s");
      default:
        return without_triangles(Ending::unreadable, "what the process has sent is no answer");
    }
  }

 private:
  struct Worker {
    std::optional<Channel> channel;  ///< nothing: no process is running
    std::uint64_t questions = 0;
  };
  struct Turn {
    explicit Turn(FreeNumbers& all_numbers) : all(all_numbers), number(all_numbers.take()) {}
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn() { all.give_back(number); }
    FreeNumbers& all;
    Index number;
  };

  static Channel::Outcome ask(Worker& worker, const Channel::Bytes& request, double seconds, RefinedSubdomain& answer) {
    constexpr double longest = 1e9;
    const auto deadline = Channel::Clock::now() + std::chrono::duration_cast<Channel::Clock::duration>(
                                                      std::chrono::duration<double>(std::min(seconds, longest)));
    const std::uint64_t number = ++worker.questions;
    Channel::Message message;
    if (const auto sent = worker.channel->send(number, request, deadline); sent != Channel::Outcome::done) return sent;
    if (const auto got = worker.channel->receive(message, deadline); got != Channel::Outcome::done) return got;
    if (message.number != number) return Channel::Outcome::damaged;
    try {
      answer = answer_from(message.body);
    } catch (const Stopped&) {
      return Channel::Outcome::damaged;
    }
    return Channel::Outcome::done;
  }

  std::unique_ptr<SubdomainMesher> mesher_;
  std::unique_ptr<Starter> starter_;
  std::vector<Worker> workers_;
  FreeNumbers free_;
};

}  // namespace

Result<std::unique_ptr<SubdomainMesher>> in_processes(std::unique_ptr<SubdomainMesher> mesher, int workers) {
  if (workers < 1)
    return Error{ErrorKind::usage, "the number of workers must be at least 1, not " + std::to_string(workers)};
  Result<std::unique_ptr<Starter>> starter = Starter::make(*mesher);
  if (!starter) return starter.error();
  return std::unique_ptr<SubdomainMesher>(
      std::make_unique<ProcessesMesher>(std::move(mesher), std::move(starter).value(), static_cast<Index>(workers)));
}

}  // namespace pardel
