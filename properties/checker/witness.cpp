#include "witness.hpp"

#include "arithmetic/text.hpp"

namespace pardel {

std::string Witness::text(const NumbersInWitnesses& numbers) const {
  std::string text;
  std::size_t written = 0;
  for (const Number& n : numbers_) {
    text.append(words_, written, n.at - written).append(checker::to_text(numbers.number(n.what, n.index)));
    written = n.at;
  }
  return text.append(words_, written);
}

Witness& Witness::operator+=(const Witness& more) {
  const auto before = static_cast<std::uint32_t>(words_.size());
  for (const auto& [at, what, index] : more.numbers_) numbers_.push_back({before + at, what, index});
  words_ += more.words_;
  return *this;
}

}  // namespace pardel
