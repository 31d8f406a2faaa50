// The mutations of a copy of the sources (scripts/mutate). One build contains all mutants. The environment variable
// PARDEL_MUTATION is the number of the one that is switched on. If PARDEL_MUTATION_TRACE names a folder, the program
// writes the numbers of the mutants that it evaluated to a file of that folder at its end.
#pragma once

#include <unistd.h>

#include <array>
#include <atomic>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <type_traits>

namespace pardel_mutation {

inline constexpr int most_mutants = 100'000;

class Trace {
 public:
  Trace() {
    if (const char* folder = std::getenv("PARDEL_MUTATION_TRACE"))
      file_ = std::string(folder) + '/' + std::to_string(getpid());
  }
  ~Trace() {
    if (file_.empty()) return;
    std::FILE* file = std::fopen(file_.c_str(), "w");
    if (file == nullptr) return;
    for (int id = 0; id < most_mutants; ++id)
      if (reached_[id].load(std::memory_order_relaxed)) std::fprintf(file, "%d\n", id);
    std::fclose(file);
  }
  [[nodiscard]] bool is_on() const { return !file_.empty(); }
  void mark(int id) { reached_[id].store(true, std::memory_order_relaxed); }

 private:
  std::string file_;
  std::array<std::atomic<bool>, most_mutants> reached_{};
};

inline Trace trace;
inline const bool tracing = trace.is_on();
inline const int chosen = std::getenv("PARDEL_MUTATION") != nullptr ? std::atoi(std::getenv("PARDEL_MUTATION")) : 0;

/// True if mutant `id` is switched on. Never true in constant expressions, which are as in the sources.
constexpr bool active(int id) {
  if (std::is_constant_evaluated()) return false;
  if (tracing) [[unlikely]]
    trace.mark(id);
  return chosen == id;
}

/// The result of a comparison, negated: a truth value, or one per lane.
constexpr auto inverse(const auto& result) {
  if constexpr (std::same_as<std::remove_cvref_t<decltype(result)>, bool>)
    return !result;
  else
    return ~result;
}

/// Two mutants of a comparison: the boundary moves, or the result is negated.
template <int id>
constexpr auto less(const auto& a, const auto& b) {
  if (active(id)) return a <= b;
  return active(id + 1) ? inverse(a < b) : a < b;
}
template <int id>
constexpr auto less_equal(const auto& a, const auto& b) {
  if (active(id)) return a < b;
  return active(id + 1) ? inverse(a <= b) : a <= b;
}
template <int id>
constexpr auto greater(const auto& a, const auto& b) {
  if (active(id)) return a >= b;
  return active(id + 1) ? inverse(a > b) : a > b;
}
template <int id>
constexpr auto greater_equal(const auto& a, const auto& b) {
  if (active(id)) return a > b;
  return active(id + 1) ? inverse(a >= b) : a >= b;
}

/// The negated value.
template <int id>
constexpr bool negated(const auto& value) {
  return static_cast<bool>(value) != active(id);
}

/// An operand of && that is left out, and one of ||.
template <int id>
constexpr bool or_true(const auto& operand) {
  return static_cast<bool>(operand) || active(id);
}
template <int id>
constexpr bool and_false(const auto& operand) {
  return static_cast<bool>(operand) && !active(id);
}

/// Another operator. Types without the other operator have no mutant.
template <int id>
constexpr auto plus(const auto& a, const auto& b) {
  if constexpr (requires {
                  { a - b } -> std::same_as<decltype(a + b)>;
                })
    if (active(id)) return a - b;
  return a + b;
}
template <int id>
constexpr auto minus(const auto& a, const auto& b) {
  if constexpr (requires {
                  { a + b } -> std::same_as<decltype(a - b)>;
                })
    if (active(id)) return a + b;
  return a - b;
}
template <int id>
constexpr auto times(const auto& a, const auto& b) {
  if constexpr (requires {
                  { a + b } -> std::same_as<decltype(a * b)>;
                })
    if (active(id)) return a + b;
  return a * b;
}
template <int id>
constexpr auto divided(const auto& a, const auto& b) {
  if constexpr (requires {
                  { a* b } -> std::same_as<decltype(a / b)>;
                })
    if (active(id)) return a * b;
  return a / b;
}
template <int id>
constexpr auto modulo(const auto& a, const auto& b) {
  return active(id) ? a / b : a % b;
}
/// -a without its sign: `value` is that of -a.
template <int id>
constexpr auto without_sign(const auto& value) {
  return active(id) ? -value : value;
}
template <int id>
constexpr auto& add(auto& a, const auto& b) {
  return active(id) ? a -= b : a += b;
}
template <int id>
constexpr auto& subtract(auto& a, const auto& b) {
  return active(id) ? a += b : a -= b;
}

/// Another constant: the next integer, twice the number, the other truth value.
template <int id, class Number>
constexpr Number constant(Number value) {
  if (!active(id)) return value;
  if constexpr (std::same_as<Number, bool>) return !value;
  if constexpr (std::integral<Number>) return static_cast<Number>(value + 1);
  return value == Number(0) ? Number(1) : Number(2) * value;
}

/// One of two arguments that are swapped.
template <int id, class T>
constexpr T& pick(T& argument, T& other) {
  return active(id) ? other : argument;
}

}  // namespace pardel_mutation
