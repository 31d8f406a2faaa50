// One end of a pair of connected sockets, and messages through it. Nothing here raises SIGPIPE.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace pardel::engine {

/// An open file descriptor, or none. Closes it in the end.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();

  /// -1: none.
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_ = -1;
};

/// Two connected sockets of a type such as SOCK_STREAM. Other programs do not inherit them. Nothing if the system
/// refuses; errno says why.
[[nodiscard]] std::optional<std::pair<Descriptor, Descriptor>> connected_sockets(int type);

/// Sends and receives messages through a stream socket. A message has a number, by which an answer names its question.
class Channel {
 public:
  using Clock = std::chrono::steady_clock;
  using Bytes = std::vector<std::byte>;
  enum class Outcome : std::uint8_t {
    done,
    closed,   ///< the other end is closed
    late,     ///< the deadline has passed
    damaged,  ///< what has arrived is no message
  };
  struct Message {
    std::uint64_t number = 0;
    Bytes body;
  };
  static constexpr Clock::time_point no_deadline = Clock::time_point::max();

  explicit Channel(Descriptor socket) : socket_(std::move(socket)) {}

  [[nodiscard]] Outcome send(std::uint64_t number, const Bytes& body, Clock::time_point deadline = no_deadline);
  /// Overwrites `message`. Takes no more memory than arrives.
  [[nodiscard]] Outcome receive(Message& message, Clock::time_point deadline = no_deadline);

 private:
  [[nodiscard]] Outcome send_bytes(const void* data, std::size_t size, Clock::time_point deadline);
  [[nodiscard]] Outcome receive_bytes(void* data, std::size_t size, Clock::time_point deadline);
  /// Waits for an event of poll(). False: the deadline has passed.
  [[nodiscard]] bool wait_for(short event, Clock::time_point deadline) const;

  Descriptor socket_;
};

}  // namespace pardel::engine
