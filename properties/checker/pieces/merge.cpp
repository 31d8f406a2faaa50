#include "merge.hpp"

#include <array>
#include <utility>

#include "../../../core/support/collective.hpp"
#include "../../../core/support/exchange_lists.hpp"
#include "../../../core/support/message.hpp"

namespace pardel::checker {
namespace {

Ranks::Bytes message_of(const Findings& findings) {
  Writer message;
  message.list(findings.counts());
  message.list(std::vector<std::uint64_t>{findings.kept().size()});
  for (const Violation& violation : findings.kept()) {
    message.list(std::vector{violation.kind});
    message.list(violation.ids);
    message.list(violation.where);
    message.list(std::vector<char>(violation.witness.begin(), violation.witness.end()));
  }
  return message.take();
}

Findings findings_of(const Ranks::Bytes& message, std::size_t limit) {
  Reader reader(message);
  const auto counts = reader.list<std::uint64_t>();
  std::vector<Violation> kept(reader.list<std::uint64_t>().at(0));
  for (Violation& violation : kept) {
    violation.kind = reader.list<ViolationKind>().at(0);
    violation.ids = reader.list<Index>();
    violation.where = reader.list<Point>();
    const auto witness = reader.list<char>();
    violation.witness.assign(witness.begin(), witness.end());
  }
  return {limit, counts, std::move(kept)};
}

}  // namespace

Findings merged(const Findings& here, Ranks& ranks) {
  Findings all(here.limit());
  for (const Ranks::Bytes& from : from_all(message_of(here), ranks)) all.append(findings_of(from, here.limit()));
  return all;
}

void merge_measures(Certificate& certificate, Index first_triangle, Ranks& ranks) {
  constexpr std::array least{&Certificate::min_angle_deg, &Certificate::min_edge};
  constexpr std::array greatest{&Certificate::max_angle_deg, &Certificate::max_area, &Certificate::max_edge,
                                &Certificate::max_circumradius, &Certificate::max_radius_edge_ratio};
  std::vector<Extreme> here;
  for (const auto extreme : least) here.push_back(certificate.*extreme);
  for (const auto extreme : greatest) here.push_back(certificate.*extreme);
  for (Extreme& extreme : here)
    if (extreme.triangle != no_index) extreme.triangle += first_triangle;
  std::vector<Extreme> all(here.size());
  for (const std::vector<Extreme>& of_rank : lists_of_all(here, ranks)) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Extreme& extreme = of_rank.at(i);
      if (extreme.triangle == no_index) continue;
      const bool is_further = i < least.size() ? extreme.value < all[i].value : extreme.value > all[i].value;
      if (all[i].triangle == no_index || is_further) all[i] = extreme;
    }
  }
  for (std::size_t i = 0; i < least.size(); ++i) certificate.*least[i] = all[i];
  for (std::size_t i = 0; i < greatest.size(); ++i) certificate.*greatest[i] = all[least.size() + i];
  ranks.add_up(certificate.angle_histogram);
  certificate.equilateral = sum_of(certificate.equilateral, ranks);
}

std::vector<Justified> merged(const std::vector<Justified>& here, Ranks& ranks) {
  return concatenated(lists_of_all(here, ranks));
}

}  // namespace pardel::checker
