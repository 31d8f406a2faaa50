#include "channel.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>

namespace pardel::engine {
namespace {

/// Comes before the body of a message.
struct Header {
  static constexpr std::uint64_t right_mark = 0x706172'64656c'3031;
  std::uint64_t mark = right_mark;
  std::uint64_t number = 0;
  std::uint64_t size = 0;  ///< of the body, in bytes
};

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

std::optional<std::pair<Descriptor, Descriptor>> connected_sockets(int type) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends.data()) != 0) return {};
  return std::pair(Descriptor(ends[0]), Descriptor(ends[1]));
}

Channel::Outcome Channel::send(std::uint64_t number, const Bytes& body, Clock::time_point deadline) {
  const Header header{.number = number, .size = body.size()};
  const Outcome outcome = send_bytes(&header, sizeof header, deadline);
  return outcome == Outcome::done ? send_bytes(body.data(), body.size(), deadline) : outcome;
}

Channel::Outcome Channel::receive(Message& message, Clock::time_point deadline) {
  constexpr std::uint64_t most_at_once = 1U << 20U;
  message.body.clear();
  Header header;
  if (const Outcome o = receive_bytes(&header, sizeof header, deadline); o != Outcome::done) return o;
  if (header.mark != Header::right_mark) return Outcome::damaged;
  message.number = header.number;
  while (message.body.size() < header.size) {
    const std::size_t begin = message.body.size();
    message.body.resize(begin + std::min(header.size - begin, most_at_once));
    if (const Outcome o = receive_bytes(&message.body[begin], message.body.size() - begin, deadline);
        o != Outcome::done)
      return o;
  }
  return Outcome::done;
}

Channel::Outcome Channel::send_bytes(const void* data, std::size_t size, Clock::time_point deadline) {
  const auto* rest = static_cast<const std::byte*>(data);
  while (size > 0) {
    const ssize_t sent = ::send(socket_.number(), rest, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent >= 0) {
      rest += sent;
      size -= static_cast<std::size_t>(sent);
    } else if (errno == EAGAIN || errno == EINTR) {
      if (!wait_for(POLLOUT, deadline)) return Outcome::late;
    } else {
      return Outcome::closed;
    }
  }
  return Outcome::done;
}

Channel::Outcome Channel::receive_bytes(void* data, std::size_t size, Clock::time_point deadline) {
  auto* rest = static_cast<std::byte*>(data);
  while (size > 0) {
    const ssize_t received = recv(socket_.number(), rest, size, MSG_DONTWAIT);
    if (received > 0) {
      rest += received;
      size -= static_cast<std::size_t>(received);
    } else if (received < 0 && (errno == EAGAIN || errno == EINTR)) {
      if (!wait_for(POLLIN, deadline)) return Outcome::late;
    } else {
      return Outcome::closed;
    }
  }
  return Outcome::done;
}

bool Channel::wait_for(short event, Clock::time_point deadline) const {
  constexpr double longest = 1e6;
  while (true) {
    int milliseconds = -1;
    if (deadline != no_deadline) {
      const double left = std::chrono::duration<double, std::milli>(deadline - Clock::now()).count();
      if (left <= 0) return false;
      milliseconds = static_cast<int>(std::ceil(std::min(left, longest)));
    }
    pollfd end{socket_.number(), event, 0};
    if (poll(&end, 1, milliseconds) > 0) return true;
  }
}

}  // namespace pardel::engine
