#include "case.hpp"

#include <fmt/core.h>

#include <charconv>
#include <optional>

namespace pardel::harness {
namespace {

constexpr int largest_size = 100;

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

/// FNV-1a.
std::uint64_t hash(std::string_view text) {
  std::uint64_t value = 0xcbf29ce484222325;
  for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return value;
}

}  // namespace

std::string to_string(const CaseId& id) { return fmt::format("{}:{}:{}", id.seed, name(id.family), id.index); }

Result<Family> parse_family(std::string_view text) {
  for (const Family family : generators::all_families()) {
    if (text == name(family)) return family;
  }
  return Error{ErrorKind::usage, fmt::format("there is no family '{}' (see --list-families)", text)};
}

Result<CaseId> parse_case(const std::string& text) {
  const std::string_view all = text;
  const std::size_t first = all.find(':'), last = all.rfind(':');
  if (first != last) {
    const auto seed = number(all.substr(0, first)), index = number(all.substr(last + 1));
    if (seed && index) {
      const Result<Family> family = parse_family(all.substr(first + 1, last - first - 1));
      if (!family) return family.error();
      return CaseId{*seed, *family, *index};
    }
  }
  return Error{ErrorKind::usage, fmt::format("'{}' is no case: SEED:FAMILY:INDEX, as in 1:cracks:17", text)};
}

LatticeDomain make_case(const CaseId& id) {
  generators::Random of_family(id.seed ^ hash(name(id.family)));
  generators::Random random(of_family.next() ^ generators::Random(id.index).next());
  const int size = random.between(0, largest_size);
  return generate(id.family, random, size);
}

std::vector<CaseId> cases_in_turn(std::uint64_t seed, std::span<const Family> families, std::uint64_t count) {
  std::vector<CaseId> cases;
  for (std::uint64_t k = 0; k < count; ++k) cases.push_back({seed, families[k % families.size()], k / families.size()});
  return cases;
}

}  // namespace pardel::harness
