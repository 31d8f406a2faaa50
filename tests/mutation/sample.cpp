// A program with one place of each kind that scripts/mutate changes. It prints the result of every function.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace {

bool is_less(int a, int b) { return a < b; }
bool is_small(int a) { return a < 3; }
bool is_two(int a) { return a == 2; }

bool is_below(int a, int b) { return a < b; }
bool is_equal(int a, int b) { return a == b; }
bool is_between(int a, int b, int c) { return is_less(a, b) && is_less(b, c); }
bool is_outside(bool inside) { return !inside; }
int minus(int a, int b) { return a - b; }
int difference(int a, int b) { return a - b; }
int with_seven(int a) { return 7 * a; }
int opposite(int a) { return -a; }
int reversed_difference(int a, int b) { return minus(b, a); }

int number_of_steps(int n) {
  int steps = n;
  if (is_small(n)) return steps;
  for (int i = 0; i < n; ++i) {
    if (is_two(i)) continue;
    steps += i;
  }
  return steps;
}

[[maybe_unused]] int never_called(bool a) { return a ? 1 : 2; }

// No mutants: the compiler computes these.
constexpr int limit = 4 - 1;
static_assert(limit < 5);
template <int N>
struct Multiple {
  int of;
};
[[maybe_unused]] int six(int a) { return Multiple<2 * 3>{a}.of; }
[[maybe_unused]] std::size_t two_names(const std::string& a) {
  const std::array<std::string, 2> names = {a, a + "b"};
  return names.size();
}
template <class Text>
[[maybe_unused]] Text longer(const Text& a) { return a + "b"; }
[[maybe_unused]] int of_a_type(int a, int b) {
  decltype(a + 1) sum = 0;
  return sum + std::min(a, b);
}

// Nested expressions, each with mutants of its own.
double nested(double a, double b) { return (a + b) * (a - b) / (a + 2.5); }

}  // namespace

int main() {
  std::printf("%d %d %d %d %d %d %d %d %d %d %g\n", is_below(2, 2), is_equal(1, 2), is_between(1, 2, 2), is_outside(false),
              difference(5, 3), with_seven(2), opposite(4), reversed_difference(1, 9), number_of_steps(4), limit,
              nested(3, 1));
}
