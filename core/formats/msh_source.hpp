// Reads parts of MSH files: values in ASCII or binary, and vertices that are identified by tags.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "../array.hpp"
#include "../mesh.hpp"
#include "text_reader.hpp"

namespace pardel::files {

/// The largest tag where tags are integers of 32 bits.
inline constexpr std::int64_t any_tag = std::numeric_limits<std::int32_t>::max();

/// Reads values. In ASCII they are in rows of text; in binary they are consecutive bytes.
class MshSource {
 public:
  explicit MshSource(TextReader& in) : in_(in) {}
  void set_binary() { binary_ = true; }
  [[nodiscard]] bool binary() const { return binary_; }

  /// Call this after the line that opens a section and before the data of the section.
  void open_section() {
    if (binary_) in_.end_line();
  }
  void row(std::string_view what) {
    if (binary_)
      in_.ask();
    else
      in_.expect_line(what);
  }
  /// Goes to record i of n. In ASCII it begins a row. False after a failure.
  bool record(std::string_view what, std::size_t i, std::size_t n) {
    if (!binary_) return in_.expect_record(what, i, n);
    in_.ask();
    return !in_.failed();
  }
  std::int64_t integer(std::string_view what, std::int64_t low, std::int64_t high) {
    return binary_ ? checked(raw<std::int32_t>(what), what, low, high) : in_.integer(what, low, high);
  }
  std::size_t size(std::string_view what) {
    constexpr std::int64_t high = std::numeric_limits<std::int64_t>::max();
    return static_cast<std::size_t>(binary_ ? checked(raw<std::int64_t>(what), what, 0, high)
                                            : in_.integer(what, 0, high));
  }
  double number(std::string_view what) {
    if (!binary_) return in_.number(what);
    const double value = raw<double>(what);
    if (!std::isfinite(value)) in_.fail("expected " + std::string(what) + ", found a number that is not finite");
    return value;
  }
  /// A number that may be infinite or not a number, as results of computations are.
  double any_number(std::string_view what) { return binary_ ? raw<double>(what) : in_.any_number(what); }
  /// True if the rest of the file can hold n records of `fields` fields, 8 bytes each in binary; otherwise fails.
  bool room_for(std::size_t n, std::size_t fields, std::string_view what) {
    return in_.room_for(n, binary_ ? 8 * fields : text_bytes(fields), what);
  }

 private:
  template <class Value>
  Value raw(std::string_view what) {
    Value value{};
    const std::string_view bytes = in_.bytes(sizeof(Value), what);
    if (!bytes.empty()) std::memcpy(&value, bytes.data(), sizeof(Value));
    return value;
  }
  std::int64_t checked(std::int64_t value, std::string_view what, std::int64_t low, std::int64_t high) {
    if (value >= low && value <= high) return value;
    in_.fail("expected " + std::string(what) + ", from " + std::to_string(low) + " to " + std::to_string(high) +
             ", found " + std::to_string(value));
    return low;
  }

  TextReader& in_;
  bool binary_ = false;
};

/// Finds vertices by their tags in the file. The tags need not be consecutive.
class MshNodes {
 public:
  void add(std::size_t tag, const Point& p) { nodes_.push_back({tag, p}); }
  void sort() {
    const auto less = [](const Node& a, const Node& b) { return a.tag < b.tag; };
    if (!std::is_sorted(nodes_.begin(), nodes_.end(), less)) std::sort(nodes_.begin(), nodes_.end(), less);
  }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const Point& operator[](std::size_t i) const { return nodes_[i].point; }
  [[nodiscard]] std::size_t tag(std::size_t i) const { return nodes_[i].tag; }
  /// The tags, for messages; empty if they are 1, 2, 3 and so on. Precondition: sort() was called last, and repeated()
  /// is 0.
  [[nodiscard]] NumbersInFile numbers() const {
    NumbersInFile all;
    if (nodes_.size() > 0 && nodes_.back().tag != nodes_.size())
      for (const Node& node : nodes_) all.of_points.push_back(node.tag);
    return all;
  }
  /// A tag that occurs twice; 0 (not a valid tag) if there is none. Precondition: sort() was called last.
  [[nodiscard]] std::size_t repeated() const {
    const auto same =
        std::adjacent_find(nodes_.begin(), nodes_.end(), [](const Node& a, const Node& b) { return a.tag == b.tag; });
    return same == nodes_.end() ? 0 : same->tag;
  }
  /// The index of the node with this tag, or no_index. Precondition: sort() was called last.
  [[nodiscard]] Index find(std::size_t tag) const {
    if (nodes_.size() == 0 || tag < nodes_[0].tag || tag > nodes_.back().tag) return no_index;
    if (nodes_.back().tag - nodes_[0].tag == nodes_.size() - 1) return static_cast<Index>(tag - nodes_[0].tag);
    const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), tag,
                                        [](const Node& node, std::size_t t) { return node.tag < t; });
    return found->tag == tag ? static_cast<Index>(found - nodes_.begin()) : no_index;
  }

 private:
  struct Node {
    std::size_t tag;
    Point point;
  };
  Array<Node> nodes_;
};

}  // namespace pardel::files
