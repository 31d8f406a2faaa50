// NumberSet: a set of numbers, one bit each.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pardel::checker {

/// The bits are in pages, and a page exists if the set has a number there. So a set of the numbers of one piece is
/// small, whatever numbers these are.
class NumberSet {
 public:
  NumberSet() = default;
  /// Number i is in the set if bit i of the words is set; see words().
  explicit NumberSet(std::span<const std::uint64_t> words);

  /// False if the number is in the set already.
  bool insert(std::uint64_t number);
  void erase(std::uint64_t number);
  [[nodiscard]] bool contains(std::uint64_t number) const;
  /// Adds the other set, and appends the numbers that both sets have to `common`.
  void unite(const NumberSet& other, std::vector<std::uint64_t>& common);
  /// The least number that is not in the set.
  [[nodiscard]] std::uint64_t first_missing() const;
  /// The numbers from `first` to `first` + `count` - 1, less `first`, 64 in a word.
  [[nodiscard]] std::vector<std::uint64_t> words(std::uint64_t first, std::uint64_t count) const;

 private:
  static constexpr std::uint64_t bits = 64, words_of_page = 1024;
  using Page = std::array<std::uint64_t, words_of_page>;

  /// The word with the bit of number 64 i; 0 where there is no page.
  [[nodiscard]] std::uint64_t word(std::uint64_t i) const;
  [[nodiscard]] Page& page(std::uint64_t i);

  std::vector<std::unique_ptr<Page>> pages_;
};

}  // namespace pardel::checker
