// Errors as values. A function that can fail because of its input returns Result<T>. It does not print and does not
// exit. It throws only std::bad_alloc, which the outermost callers turn into an error of kind `resources`.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace pardel {

/// The kind of an error. It determines the exit code of the programs.
enum class ErrorKind : std::uint8_t {
  usage,          ///< an argument is out of range (minimum angle 60, negative area), or a function of the caller failed
  invalid_input,  ///< the input is invalid; the message names the place
  io,             ///< a file could not be opened, read or written
  resources,      ///< not enough memory, or more ids than their type can hold
  cancelled,      ///< a callback of the caller requested a stop
  internal,       ///< a self-check of the program failed: the program is wrong, not the input
};

/// `message` is one complete sentence or several lines. It names the file and the line, or the ids and the coordinates.
struct Error {
  ErrorKind kind = ErrorKind::invalid_input;
  std::string message;
};

/// A value of type T, or an error. Converts to true if it holds a value.
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

/// The result of functions that can fail but return no value.
struct Done {};
using Status = Result<Done>;

}  // namespace pardel
