// A case: a generated domain, identified by seed, family and index.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/result.hpp"
#include "../../properties/domains/generators/lattice_domain.hpp"

namespace pardel::harness {

using generators::Family;
using generators::LatticeDomain;

/// Identifies a random domain by the seed, the family, and its index in the family (from 0). Its text form is
/// SEED:FAMILY:INDEX.
struct CaseId {
  std::uint64_t seed = 1;
  Family family = Family::general_position;
  std::uint64_t index = 0;
};

[[nodiscard]] std::string to_string(const CaseId& id);
[[nodiscard]] Result<CaseId> parse_case(const std::string& text);
[[nodiscard]] Result<Family> parse_family(std::string_view text);

/// Generates the domain. The result depends only on the id, not on other cases or on the families that are selected for
/// the run.
[[nodiscard]] LatticeDomain make_case(const CaseId& id);

/// Returns `count` cases that go through the families in turn. Precondition: `families` is not empty.
[[nodiscard]] std::vector<CaseId> cases_in_turn(std::uint64_t seed, std::span<const Family> families,
                                                std::uint64_t count);

}  // namespace pardel::harness
