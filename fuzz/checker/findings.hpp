// The violations in a certificate, compared with what the definitions find.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string>
#include <utility>

#include "../../properties/checker/check.hpp"
#include "../fuzz_one.hpp"
#include "exact_mesh.hpp"

namespace pardel::fuzz {

inline std::string text(Index i) { return "number " + std::to_string(i); }
inline std::string text(const std::pair<Index, Index>& of_triangle_and_hole) {
  return text(of_triangle_and_hole.first) + " with hole " + std::to_string(of_triangle_and_hole.second);
}
inline std::string text(const ref::Edge& e) { return "edge " + std::to_string(e[0]) + " " + std::to_string(e[1]); }

/// The violations in a certificate.
class Findings {
 public:
  explicit Findings(const Certificate& certificate) : certificate_(certificate) {}

  [[nodiscard]] bool has_any(std::initializer_list<ViolationKind> kinds) const {
    return std::ranges::any_of(
        kinds, [&](ViolationKind kind) { return certificate_.violation_counts[static_cast<std::size_t>(kind)] > 0; });
  }

  /// The first number in each violation.
  [[nodiscard]] std::set<Index> first(ViolationKind kind) const {
    return collect<Index>([=](const Violation& v, auto& to) {
      if (v.kind == kind) to.insert(v.ids.front());
    });
  }
  /// All numbers in the violations.
  [[nodiscard]] std::set<Index> all(ViolationKind kind) const {
    return collect<Index>([=](const Violation& v, auto& to) {
      if (v.kind == kind) to.insert(v.ids.begin(), v.ids.end());
    });
  }
  /// The edges between the first two numbers in each violation.
  [[nodiscard]] Edges edges(ViolationKind kind) const {
    return collect<ref::Edge>([=](const Violation& v, auto& to) {
      if (v.kind == kind) to.insert(ref::edge(v.ids[0], v.ids[1]));
    });
  }

  /// Fails if the checker's findings of this kind are not those of the definition.
  template <class Item>
  void require(ViolationKind kind, const std::set<Item>& checker, const std::set<Item>& definition) const {
    for (const Item& item : checker)
      if (!definition.contains(item)) differ(kind, "only the checker reports " + text(item));
    for (const Item& item : definition)
      if (!checker.contains(item)) differ(kind, "the checker does not report " + text(item));
  }
  void require(ViolationKind kind, bool definition) const {
    if (has_any({kind}) && !definition) differ(kind, "only the checker reports it");
    if (!has_any({kind}) && definition) differ(kind, "the checker does not report it");
  }

  template <class Item, class Take>
  [[nodiscard]] std::set<Item> collect(const Take& take) const {
    std::set<Item> items;
    for (const Violation& violation : certificate_.violations) take(violation, items);
    return items;
  }

 private:
  [[noreturn]] void differ(ViolationKind kind, const std::string& what) const {
    std::string all;
    for (std::size_t k = 0; k < violation_kinds; ++k)
      if (const auto n = certificate_.violation_counts[k]; n > 0)
        all += " " + std::to_string(n) + " " + name(static_cast<ViolationKind>(k));
    fail(std::string(name(kind)) + ": " + what + "; it reports:" + (all.empty() ? " nothing" : all));
  }

  const Certificate& certificate_;
};

}  // namespace pardel::fuzz
