// A property of the theory as a test: RapidCheck in GoogleTest, with what the catalogue needs to know about it and
// with a picture of the smallest case that breaks it.
//
//   PARDEL_PROPERTY(T1, at_four_circumradii_the_closures_of_the_cavities_are_disjoint,
//                   {.statement = "|pq| >= 4 r̄ implies that the closures of C(p) and C(q) are disjoint",
//                    .source = "[CC] Theorem 1",
//                    .families = "lattice points of every family"}) {
//     const Scene scene = *scenes(...);
//     exhibit.show(scene);
//     RC_ASSERT(...);
//   }
//
// 2,000 cases from a fixed seed, or what RC_PARAMS says (max_success=100000 seed=7). A failure prints the seed and the
// line that replays it and writes the shrunk case as SUITE.NAME.poly and .svg to the folder PARDEL_FAILURES (default:
// property-failures). With PARDEL_RECORDS set, every property leaves SUITE.NAME.json there, for the catalogue.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "../../../core/mesh.hpp"
#include "../../../core/pslg.hpp"
#include "scene.hpp"

namespace pardel::properties {

struct Statement {
  const char* statement;      ///< what holds, with its hypotheses, in one or two sentences
  const char* source;         ///< paper and theorem, or the section of properties/THEORY.md
  const char* families = "";  ///< what it was tried on
};

/// What a failing case is shown by. A case says what it is about as soon as it knows; the last word counts.
class Exhibit {
 public:
  void show(Scene scene) { shown_ = std::move(scene); }
  void show(Pslg pslg) { shown_ = std::move(pslg); }
  /// With the mesh made of it, which is what the picture shows then.
  void show(Pslg pslg, Mesh mesh) { shown_ = std::pair(std::move(pslg), std::move(mesh)); }

  /// Writes STEM.poly and STEM.svg; returns what was written and what was not, for the report.
  [[nodiscard]] std::string write(const std::string& stem) const;

 private:
  std::variant<std::monostate, Scene, Pslg, std::pair<Pslg, Mesh>> shown_;
};

/// What a search or a sweep over a grid has to tell the catalogue.
struct Facts {
  std::uint64_t cases = 0;         ///< how many were tried
  std::vector<std::string> notes;  ///< figures found, a sentence each
};

void check_property(const Statement& statement, void (*body)(Exhibit&));
void check_fact(const Statement& statement, void (*body)(Facts&));

}  // namespace pardel::properties

/// A property for random cases; the body sees `exhibit`.
#define PARDEL_PROPERTY(Suite, name, ...)                                                                      \
  static void Suite##_##name##_case(::pardel::properties::Exhibit& exhibit);                                   \
  TEST(Suite, name) {                                                                                          \
    ::pardel::properties::check_property(::pardel::properties::Statement __VA_ARGS__, &Suite##_##name##_case); \
  }                                                                                                            \
  static void Suite##_##name##_case([[maybe_unused]] ::pardel::properties::Exhibit& exhibit)

/// A statement that a search, a grid or a stored witness settles, with GoogleTest's assertions; sees `facts`.
#define PARDEL_FACT(Suite, name, ...)                                                                      \
  static void Suite##_##name##_fact(::pardel::properties::Facts& facts);                                   \
  TEST(Suite, name) {                                                                                      \
    ::pardel::properties::check_fact(::pardel::properties::Statement __VA_ARGS__, &Suite##_##name##_fact); \
  }                                                                                                        \
  static void Suite##_##name##_fact([[maybe_unused]] ::pardel::properties::Facts& facts)
