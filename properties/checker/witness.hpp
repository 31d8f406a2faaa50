// Witnesses: the sentences of the checker. They name vertices, triangles and parts of the domain by numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../../core/pslg.hpp"

namespace pardel {

/// What a number in a witness is the number of.
enum class Numbered : std::uint32_t {
  vertex,
  triangle,
  of_domain,  ///< a point, segment, hole or region of the domain
};

/// The numbers that vertices, triangles and parts of the domain have in their files. By default they count from 0.
struct NumbersInWitnesses {
  int first_of_domain = 0;  ///< the number of the first point, and of the first segment, hole and region
  int first_triangle = 0;
  int first_vertex = 0;
  std::span<const std::uint64_t> vertices{};   ///< by vertex; a vertex without an entry counts from `first_vertex`
  std::span<const std::uint64_t> triangles{};  ///< the same by triangle

  /// The number of the thing with this index.
  [[nodiscard]] std::uint64_t number(Numbered what, Index index) const {
    if (what == Numbered::vertex && index < vertices.size()) return vertices[index];
    if (what == Numbered::triangle && index < triangles.size()) return triangles[index];
    const int first = what == Numbered::vertex     ? first_vertex
                      : what == Numbered::triangle ? first_triangle
                                                   : first_of_domain;
    return std::uint64_t{index} + static_cast<unsigned>(first);
  }
};

/// A sentence that can be written with the numbers of any files: the checker keeps indices beside the words.
class Witness {
 public:
  struct Number {
    std::uint32_t at;  ///< how many characters of the words come before it
    Numbered what;
    Index index;
  };

  Witness() = default;
  /// Words without numbers of things. Not explicit, so that words and numbers can be joined with +.
  Witness(std::string words) : words_(std::move(words)) {}  // NOLINT(google-explicit-constructor)
  Witness(const char* words) : words_(words) {}             // NOLINT(google-explicit-constructor)
  /// The number of one thing.
  Witness(Numbered what, Index index) : numbers_{{0, what, index}} {}
  /// Precondition: the numbers are sorted by their places.
  Witness(std::string words, std::vector<Number> numbers) : words_(std::move(words)), numbers_(std::move(numbers)) {}

  /// The sentence with these numbers. O(length).
  [[nodiscard]] std::string text(const NumbersInWitnesses& numbers = {}) const;

  [[nodiscard]] const std::string& words() const { return words_; }
  [[nodiscard]] const std::vector<Number>& numbers() const { return numbers_; }
  [[nodiscard]] bool empty() const { return words_.empty() && numbers_.empty(); }

  Witness& operator+=(const Witness& more);
  [[nodiscard]] friend Witness operator+(Witness first, const Witness& more) { return std::move(first += more); }

 private:
  std::string words_;
  std::vector<Number> numbers_;
};

}  // namespace pardel
