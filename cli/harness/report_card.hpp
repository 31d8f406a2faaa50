// The report card: all cases with their outcomes, and their counts.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case.hpp"
#include "outcome.hpp"

namespace pardel::harness {

/// The smallest input found that fails in a given way.
struct SmallestFailure {
  std::size_t points = 0, segments = 0, holes = 0;
  bool shrunk_fully = false;   ///< the shrinker found no simpler input that fails in this way
  std::filesystem::path poly;  ///< the picture has the same name, with .svg
};

struct FailureKind {
  Verdict verdict = Verdict::wrong;
  std::string kind;
  std::uint64_t cases = 0;
  std::size_t first = 0;  ///< index of the first such case
  std::string message;    ///< the message of the first such case
  std::optional<SmallestFailure> smallest;
};

using Counts = std::array<std::uint64_t, verdict_count>;

struct FamilyRow {
  Family family;
  Counts counts{};
};

/// Two runs with the same options give equal cards: a card has no times and no temporary names.
struct ReportCard {
  std::string mesher;  ///< its command
  std::string goal;    ///< in words
  std::string limits;  ///< in words
  std::string replay;  ///< the command that repeats a case, without "--replay CASE" at its end
  std::uint64_t seed = 1;
  std::vector<CaseId> cases;
  std::vector<Outcome> outcomes;  ///< in the order of the cases
  std::vector<FamilyRow> families;
  Counts counts{};
  std::vector<FailureKind> kinds;  ///< by verdict, then by decreasing number of cases
};

/// Computes families, counts and kinds from cases and outcomes.
void count(ReportCard& card);

[[nodiscard]] bool all_valid(const ReportCard& card);

[[nodiscard]] std::string to_markdown(const ReportCard& card);
/// Schema pardel.harness/1. Lists every failing case.
[[nodiscard]] std::string to_json(const ReportCard& card);

}  // namespace pardel::harness
