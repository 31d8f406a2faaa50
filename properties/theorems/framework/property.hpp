// Macros that turn a property of the theory into a test: RapidCheck runs inside GoogleTest. Each property has an entry
// for the catalogue. After a failure, the test writes a picture of the smallest case that violates the property.
//
//   PARDEL_PROPERTY(T1, at_four_circumradii_the_closures_of_the_cavities_are_disjoint,
//                   {.statement = "If |pq| >= 4 r̄, the closures of C(p) and C(q) are disjoint.",
//                    .source = "[CC] Theorem 1",
//                    .families = "lattice points of every family"}) {
//     const Scene scene = *scenes(...);
//     exhibit.show(scene);
//     RC_ASSERT(...);
//   }
//
// A property runs 2,000 cases from a fixed seed. The environment variable RC_PARAMS overrides this, for example
// RC_PARAMS="max_success=100000 seed=7". A failure prints a command line that repeats all cases, and one that repeats
// only the shrunk case. It writes the shrunk case as SUITE.NAME.poly and SUITE.NAME.svg to the folder PARDEL_FAILURES
// (default: property-failures). If PARDEL_RECORDS names a folder, every property writes SUITE.NAME.json there; the
// catalogue is made from these files.
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

/// The entry of a property in the catalogue.
struct Statement {
  const char* statement;      ///< the claim with its hypotheses, in one or two sentences
  const char* source;         ///< paper and theorem, or the section of properties/THEORY.md
  const char* families = "";  ///< the kinds of inputs with which it is tested
};

/// The input of the current case, for the report of a failure. The body of a property calls show() as soon as it has
/// the input of the case; the last call counts.
class Exhibit {
 public:
  void show(Scene scene) { shown_ = std::move(scene); }
  void show(Pslg pslg) { shown_ = std::move(pslg); }
  /// The picture shows the mesh.
  void show(Pslg pslg, Mesh mesh) { shown_ = std::pair(std::move(pslg), std::move(mesh)); }

  /// Writes STEM.poly and STEM.svg. Returns a text for the report: the names of the files, and errors in writing them.
  [[nodiscard]] std::string write(const std::string& stem) const;

 private:
  std::variant<std::monostate, Scene, Pslg, std::pair<Pslg, Mesh>> shown_;
};

/// The results of a search or of a test of all points of a grid, for the catalogue.
struct Facts {
  std::uint64_t cases = 0;         ///< number of cases tested
  std::vector<std::string> notes;  ///< the values that were found, one sentence each
};

void check_property(const Statement& statement, void (*body)(Exhibit&));
void check_fact(const Statement& statement, void (*body)(Facts&));

}  // namespace pardel::properties

/// A property that is tested on random cases. The body may use the variable `exhibit` (Exhibit&).
#define PARDEL_PROPERTY(Suite, name, ...)                                                                      \
  static void Suite##_##name##_case(::pardel::properties::Exhibit& exhibit);                                   \
  TEST(Suite, name) {                                                                                          \
    ::pardel::properties::check_property(::pardel::properties::Statement __VA_ARGS__, &Suite##_##name##_case); \
  }                                                                                                            \
  static void Suite##_##name##_case([[maybe_unused]] ::pardel::properties::Exhibit& exhibit)

/// A statement that a search, a grid or a stored witness proves or refutes, with GoogleTest's assertions. The body may
/// use the variable `facts` (Facts&).
#define PARDEL_FACT(Suite, name, ...)                                                                      \
  static void Suite##_##name##_fact(::pardel::properties::Facts& facts);                                   \
  TEST(Suite, name) {                                                                                      \
    ::pardel::properties::check_fact(::pardel::properties::Statement __VA_ARGS__, &Suite##_##name##_fact); \
  }                                                                                                        \
  static void Suite##_##name##_fact([[maybe_unused]] ::pardel::properties::Facts& facts)
