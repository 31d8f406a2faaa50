// The report card: what became of all cases, counted.
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

/// How a kind of failure looks at its smallest.
struct SmallestFailure {
  std::size_t points = 0, segments = 0, holes = 0;
  bool shrunk_fully = false;   ///< nothing simpler fails
  std::filesystem::path poly;  ///< the picture is beside it, as .svg
};

struct FailureKind {
  Verdict verdict = Verdict::wrong;
  std::string kind;
  std::uint64_t cases = 0;
  std::size_t first = 0;  ///< index of a case
  std::string message;    ///< of that case
  std::optional<SmallestFailure> smallest;
};

using Counts = std::array<std::uint64_t, verdict_count>;

struct FamilyRow {
  Family family;
  Counts counts{};
};

/// Holds nothing that differs between two runs with the same options: no times, no temporary names.
struct Card {
  std::string mesher;  ///< as it was run
  std::string goal;    ///< in words
  std::string limits;  ///< in words
  std::string replay;  ///< the command that repeats a case, up to the case
  std::uint64_t seed = 1;
  std::vector<CaseId> cases;
  std::vector<Outcome> outcomes;  ///< of these
  std::vector<FamilyRow> families;
  Counts counts{};
  std::vector<FailureKind> kinds;  ///< by verdict, then the most frequent first
};

/// Fills in families, counts and kinds from cases and outcomes.
void count(Card& card);

[[nodiscard]] bool all_valid(const Card& card);

[[nodiscard]] std::string to_markdown(const Card& card);
/// Schema pardel.harness/1: every failing case is listed.
[[nodiscard]] std::string to_json(const Card& card);

}  // namespace pardel::harness
