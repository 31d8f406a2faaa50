// Exact arithmetic with floating-point expansions. An expansion represents a number as a sum of non-overlapping
// doubles, smallest first. The names follow Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates", 1997. Every operation is exact unless a double overflows or underflows. Zero terms are
// dropped, so sums whose terms cancel stay short. The code requires rounding to nearest even and must be compiled
// without -ffast-math and without contraction. Capacities are part of the types, so no memory is allocated.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace pardel::engine::exact {

/// The exact value head + tail. head is the rounded value, tail the rounding error.
struct Two {
  double head;
  double tail;
};

[[nodiscard]] inline Two two_sum(double a, double b) {
  const double head = a + b;
  const double b_virtual = head - a;
  const double a_virtual = head - b_virtual;
  return {head, (a - a_virtual) + (b - b_virtual)};
}

/// Precondition: |a| >= |b| or a == 0.
[[nodiscard]] inline Two fast_two_sum(double a, double b) {
  const double head = a + b;
  return {head, b - (head - a)};
}

[[nodiscard]] inline Two two_difference(double a, double b) {
  const double head = a - b;
  const double b_virtual = a - head;
  const double a_virtual = head + b_virtual;
  return {head, (a - a_virtual) + (b_virtual - b)};
}

/// Dekker's splitting: head and tail have at most 26 bits each.
[[nodiscard]] inline Two split(double a) {
  const double c = 0x1.0000002p27 * a;
  const double head = c - (c - a);
  return {head, a - head};
}

/// Dekker's and Veltkamp's product, for machines without a fused multiply-add.
[[nodiscard]] inline Two two_product_by_splitting(double a, double b) {
  const double head = a * b;
  const Two x = split(a), y = split(b);
  const double error = ((head - x.head * y.head) - x.tail * y.head) - x.head * y.tail;
  return {head, x.tail * y.tail - error};
}

[[nodiscard]] inline Two two_product_by_fma(double a, double b) {
  const double head = a * b;
  return {head, std::fma(a, b, -head)};
}

/// The faster of the two functions. Their results are identical.
[[nodiscard]] inline Two two_product(double a, double b) {
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
  return two_product_by_fma(a, b);
#else
  return two_product_by_splitting(a, b);
#endif
}

/// A sum of up to Capacity non-zero, non-overlapping terms, smallest first. Zero has no terms.
template <std::size_t Capacity>
class Expansion {
 public:
  // The terms beyond size() are never read, so they are not initialised.
  Expansion() {}  // NOLINT(modernize-use-equals-default,cppcoreguidelines-pro-type-member-init)
  explicit Expansion(Two two) : Expansion() {
    push(two.tail);
    push(two.head);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double operator[](std::size_t i) const { return terms_[i]; }

  /// Appends a term that is larger in magnitude than all others. A zero is not appended.
  void push(double term) {
    if (term != 0) terms_[size_++] = term;
  }
  /// An approximation with the exact sign, because the largest term outweighs the sum of the others.
  [[nodiscard]] double estimate() const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) sum += terms_[i];
    return sum;
  }
  [[nodiscard]] Expansion operator-() const {
    Expansion result;
    result.size_ = size_;
    for (std::size_t i = 0; i < size_; ++i) result.terms_[i] = -terms_[i];
    return result;
  }

 private:
  std::size_t size_ = 0;
  std::array<double, Capacity> terms_;
};

/// Fast-Expansion-Sum with zero elimination.
template <std::size_t N, std::size_t M>
[[nodiscard]] Expansion<N + M> operator+(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<N + M> sum;
  std::size_t i = 0, j = 0;
  const auto next_smallest = [&] {
    const bool from_e = j == f.size() || (i < e.size() && std::abs(e[i]) < std::abs(f[j]));
    return from_e ? e[i++] : f[j++];
  };
  const std::size_t terms = e.size() + f.size();
  if (terms == 0) return sum;
  double q = next_smallest();
  for (std::size_t k = 1; k < terms; ++k) {
    const Two s = two_sum(q, next_smallest());
    sum.push(s.tail);
    q = s.head;
  }
  sum.push(q);
  return sum;
}

template <std::size_t N, std::size_t M>
[[nodiscard]] Expansion<N + M> operator-(const Expansion<N>& e, const Expansion<M>& f) {
  return e + -f;
}

/// Scale-Expansion with zero elimination.
template <std::size_t N>
[[nodiscard]] Expansion<2 * N> operator*(const Expansion<N>& e, double b) {
  Expansion<2 * N> product;
  if (e.size() == 0) return product;
  const Two first = two_product(e[0], b);
  product.push(first.tail);
  double q = first.head;
  for (std::size_t i = 1; i < e.size(); ++i) {
    const Two t = two_product(e[i], b);
    const Two low = two_sum(q, t.tail);
    product.push(low.tail);
    const Two high = fast_two_sum(t.head, low.head);
    product.push(high.tail);
    q = high.head;
  }
  product.push(q);
  return product;
}

/// Multiplies e with the two halves of f recursively, so the two operands of each sum have similar sizes.
template <std::size_t N, std::size_t M>
[[nodiscard]] Expansion<2 * N * M> operator*(const Expansion<N>& e, const Expansion<M>& f) {
  if constexpr (M == 1) {
    return f.size() == 0 ? Expansion<2 * N>() : e * f[0];
  } else {
    constexpr std::size_t half = M / 2;
    Expansion<half> low;
    Expansion<M - half> high;
    const std::size_t middle = f.size() < half ? f.size() : half;
    for (std::size_t i = 0; i < middle; ++i) low.push(f[i]);
    for (std::size_t i = middle; i < f.size(); ++i) high.push(f[i]);
    return e * low + e * high;
  }
}

}  // namespace pardel::engine::exact
