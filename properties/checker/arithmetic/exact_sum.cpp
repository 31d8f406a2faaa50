#include "exact_sum.hpp"

#include <bit>
#include <cmath>

namespace pardel::checker {
namespace {

__extension__ using Wide = unsigned __int128;

/// |x| = mantissa * 2^exponent with an integer mantissa below 2^53.
struct Parts {
  std::uint64_t mantissa;
  int exponent;
};

Parts parts(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const int biased = static_cast<int>((bits >> 52) & 0x7ff);
  if (biased == 0) return {fraction, -1074};
  return {fraction | (std::uint64_t{1} << 52), biased - 1075};
}

// An addition changes a limb by less than 2^33, so after 2^29 additions a limb is still below 2^63.
constexpr std::uint32_t additions_between_carries = 1u << 29;

}  // namespace

void ExactSum::accumulate(double x, double y, bool subtract) {
  const Parts a = parts(x);
  const Parts b = parts(y);
  const Wide product = Wide{a.mantissa} * b.mantissa;
  if (product == 0) return;
  if (++pending_ >= additions_between_carries) carry();
  const int position = a.exponent + b.exponent - lowest_exponent;
  auto limb = static_cast<std::size_t>(position / bits_per_limb);
  const int shift = position % bits_per_limb;
  const bool negative = (std::signbit(x) != std::signbit(y)) != subtract;
  // The product has 106 bits; shifted by up to 31 it has 137. The two halves are shifted separately, in 128 bits each.
  Wide low = (product & ~std::uint64_t{0}) << shift;
  Wide high = (product >> 64) << shift;
  const auto put = [&](std::size_t at, std::uint64_t value) {
    const auto piece = static_cast<std::int64_t>(value & 0xffffffffu);
    limb_[at] += negative ? -piece : piece;
  };
  for (std::size_t i = 0; low != 0; ++i, low >>= bits_per_limb) put(limb + i, static_cast<std::uint64_t>(low));
  for (std::size_t i = 2; high != 0; ++i, high >>= bits_per_limb) put(limb + i, static_cast<std::uint64_t>(high));
}

void ExactSum::carry() {
  for (std::size_t i = 0; i + 1 < limb_.size(); ++i) {
    const std::int64_t over = limb_[i] >> bits_per_limb;
    limb_[i] -= over * (std::int64_t{1} << bits_per_limb);
    limb_[i + 1] += over;
  }
  pending_ = 0;
}

ExactSum& ExactSum::operator+=(const ExactSum& other) {
  ExactSum carried = other;
  carried.carry();
  carry();
  for (std::size_t i = 0; i < limb_.size(); ++i) limb_[i] += carried.limb_[i];
  carry();
  return *this;
}

ExactSum& ExactSum::operator-=(const ExactSum& other) {
  ExactSum carried = other;
  carried.carry();
  carry();
  for (std::size_t i = 0; i < limb_.size(); ++i) limb_[i] -= carried.limb_[i];
  carry();
  return *this;
}

int ExactSum::sign() const {
  ExactSum carried = *this;
  carried.carry();
  if (carried.limb_.back() != 0) return carried.limb_.back() < 0 ? -1 : 1;
  for (const std::int64_t limb : carried.limb_)
    if (limb != 0) return 1;
  return 0;
}

double ExactSum::rounded() const {
  const int direction = sign();
  if (direction == 0) return 0;
  ExactSum magnitude;
  if (direction > 0)
    magnitude += *this;
  else
    magnitude -= *this;
  // Add the limbs from the leading limb down. After the first few limbs the others are below the last digit of the
  // result.
  double value = 0;
  for (std::size_t i = magnitude.limb_.size(); i-- > 0;)
    value += std::ldexp(static_cast<double>(magnitude.limb_[i]), static_cast<int>(i) * bits_per_limb + lowest_exponent);
  return direction > 0 ? value : -value;
}

}  // namespace pardel::checker
