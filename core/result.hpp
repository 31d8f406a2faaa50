// Errors as values. A function that can fail on what it was given returns Result<T>; it never prints,
// never exits and does not throw (but for std::bad_alloc, which callers at the top turn into `resources`).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace pardel {

/// What kind of thing went wrong; the program's exit codes follow from it.
enum class ErrorKind : std::uint8_t {
  usage,          ///< the caller asked for something that has no meaning (minimum angle 60, negative area)
  invalid_input,  ///< the input is not what it should be; the message names the place
  io,             ///< a file could not be opened, read or written
  resources,      ///< memory or an id range does not suffice
  cancelled,      ///< the caller's own callback asked to stop
  internal,       ///< not the input but the program is wrong: what it relies on does not hold
};

/// `message` is one complete sentence or several lines, with file and line, or ids and coordinates, inside.
struct Error {
  ErrorKind kind = ErrorKind::invalid_input;
  std::string message;
};

template <class T, class E = Error>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(E error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// Precondition: ok().
  T& value() & { return std::get<0>(state_); }
  const T& value() const& { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// Precondition: !ok().
  const E& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, E> state_;
};

/// For functions that return nothing but may fail.
struct Done {};
using Status = Result<Done>;

}  // namespace pardel
