// Which input: a case is its name, and its name makes it.
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

/// The index-th domain of a family for a seed. Printed and parsed as SEED:FAMILY:INDEX.
struct CaseId {
  std::uint64_t seed = 1;
  Family family = Family::general_position;
  std::uint64_t index = 0;
};

[[nodiscard]] std::string to_string(const CaseId& id);
[[nodiscard]] Result<CaseId> parse_case(const std::string& text);
[[nodiscard]] Result<Family> parse_family(std::string_view text);

/// Depends on nothing but the id: neither on the other cases nor on which families there are.
[[nodiscard]] LatticeDomain make_case(const CaseId& id);

/// `count` cases, the families in turn. Precondition: there is a family.
[[nodiscard]] std::vector<CaseId> draw_cases(std::uint64_t seed, std::span<const Family> families, std::uint64_t count);

}  // namespace pardel::harness
