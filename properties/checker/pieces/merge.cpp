#include "merge.hpp"

#include <array>
#include <span>
#include <string>
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
    message.list(std::span<const char>(violation.witness.words()));
    message.list(violation.witness.numbers());
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
    const auto words = reader.list<char>();
    violation.witness = {std::string(words.begin(), words.end()), reader.list<Witness::Number>()};
  }
  return {limit, counts, std::move(kept)};
}

/// The extremes of a certificate: the least values, then the greatest.
constexpr std::size_t least_values = 2;
constexpr std::array extremes{&Certificate::min_angle_deg,
                              &Certificate::min_edge,
                              &Certificate::max_angle_deg,
                              &Certificate::max_area,
                              &Certificate::max_edge,
                              &Certificate::max_circumradius,
                              &Certificate::max_radius_edge_ratio};

/// Adds extremes of later triangles.
void add_extremes(Certificate& certificate, std::span<const Extreme> later) {
  for (std::size_t i = 0; i < extremes.size(); ++i) {
    Extreme& known = certificate.*extremes[i];
    if (later[i].triangle == no_index) continue;
    const bool is_further = i < least_values ? later[i].value < known.value : later[i].value > known.value;
    if (known.triangle == no_index || is_further) known = later[i];
  }
}

std::vector<Extreme> extremes_of(const Certificate& certificate) {
  std::vector<Extreme> values;
  values.reserve(std::size(extremes));
  for (const auto extreme : extremes) values.push_back(certificate.*extreme);
  return values;
}

}  // namespace

Findings merged(const Findings& here, Ranks& ranks) {
  Findings all(here.limit());
  for (const Ranks::Bytes& from : from_all(message_of(here), ranks)) all.append(findings_of(from, here.limit()));
  return all;
}

void add_measures(Certificate& certificate, const Measures& measures, Index first_triangle) {
  Certificate of_piece;
  measures.report(of_piece);
  std::vector<Extreme> later = extremes_of(of_piece);
  for (Extreme& extreme : later)
    if (extreme.triangle != no_index) extreme.triangle += first_triangle;
  add_extremes(certificate, later);
  for (std::size_t bin = 0; bin < of_piece.angle_histogram.size(); ++bin)
    certificate.angle_histogram[bin] += of_piece.angle_histogram[bin];
  certificate.equilateral += of_piece.equilateral;
}

void merge_measures(Certificate& certificate, Ranks& ranks) {
  const std::vector<std::vector<Extreme>> of_ranks = lists_of_all(extremes_of(certificate), ranks);
  for (const auto extreme : extremes) certificate.*extreme = {};
  for (const std::vector<Extreme>& of_rank : of_ranks) add_extremes(certificate, of_rank);
  ranks.add_up(certificate.angle_histogram);
  certificate.equilateral = sum_of(certificate.equilateral, ranks);
}

std::vector<Justified> merged(const std::vector<Justified>& here, Ranks& ranks) {
  return concatenated(lists_of_all(here, ranks));
}

}  // namespace pardel::checker
