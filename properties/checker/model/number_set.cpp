#include "number_set.hpp"

#include <algorithm>
#include <bit>

namespace pardel::checker {

NumberSet::NumberSet(std::span<const std::uint64_t> words) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] != 0) page(i / words_of_page)[i % words_of_page] = words[i];
}

bool NumberSet::insert(std::uint64_t number) {
  std::uint64_t& word = page(number / bits / words_of_page)[number / bits % words_of_page];
  const std::uint64_t bit = std::uint64_t{1} << number % bits;
  const bool is_new = (word & bit) == 0;
  word |= bit;
  return is_new;
}

void NumberSet::erase(std::uint64_t number) {
  if (contains(number))
    page(number / bits / words_of_page)[number / bits % words_of_page] &= ~(std::uint64_t{1} << number % bits);
}

bool NumberSet::contains(std::uint64_t number) const { return (word(number / bits) >> number % bits & 1) != 0; }

void NumberSet::unite(const NumberSet& other, std::vector<std::uint64_t>& common) {
  for (std::size_t p = 0; p < other.pages_.size(); ++p) {
    if (!other.pages_[p]) continue;
    const Page& theirs = *other.pages_[p];
    Page& mine = page(p);
    for (std::size_t i = 0; i < words_of_page; ++i) {
      for (std::uint64_t both = mine[i] & theirs[i]; both != 0; both &= both - 1)
        common.push_back((p * words_of_page + i) * bits + static_cast<std::uint64_t>(std::countr_zero(both)));
      mine[i] |= theirs[i];
    }
  }
}

std::uint64_t NumberSet::first_missing() const {
  std::uint64_t i = 0;
  while (~word(i) == 0) ++i;
  return i * bits + static_cast<std::uint64_t>(std::countr_one(word(i)));
}

std::vector<std::uint64_t> NumberSet::words(std::uint64_t first, std::uint64_t count) const {
  std::vector<std::uint64_t> words((count + bits - 1) / bits);
  const std::uint64_t shift = first % bits;
  for (std::size_t i = 0; i < words.size(); ++i) {
    words[i] = word(first / bits + i) >> shift;
    if (shift != 0) words[i] |= word(first / bits + i + 1) << (bits - shift);
  }
  if (count % bits != 0) words.back() &= (std::uint64_t{1} << count % bits) - 1;
  return words;
}

std::uint64_t NumberSet::word(std::uint64_t i) const {
  const std::uint64_t p = i / words_of_page;
  return p < pages_.size() && pages_[p] ? (*pages_[p])[i % words_of_page] : 0;
}

NumberSet::Page& NumberSet::page(std::uint64_t i) {
  if (i >= pages_.size()) pages_.resize(i + 1);
  if (!pages_[i]) pages_[i] = std::make_unique<Page>(Page{});
  return *pages_[i];
}

}  // namespace pardel::checker
