#include "sites_of_numbers.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/answers_of_ranks.hpp"
#include "../../core/support/message.hpp"

namespace pardel::engine {
namespace {

struct TravellingSite {
  std::uint64_t number;
  Site site;
};

}  // namespace

SitesOfNumbers::SitesOfNumbers(const TriangulatedPoints& points, std::vector<std::uint64_t> first_read, Ranks& ranks)
    : first_read_(std::move(first_read)), ranks_(ranks) {
  std::vector<std::vector<VertexId>> of_reader(static_cast<std::size_t>(ranks.count()));
  for (VertexId v = 0; v < points.delaunay.own(); ++v) of_reader[reader_of(points.own.number[v])].push_back(v);
  std::vector<Writer> messages(of_reader.size());
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
    messages[rank].list_of<TravellingSite>(of_reader[rank].size(), [&](std::size_t i) {
      const VertexId v = of_reader[rank][i];
      return TravellingSite{points.own.number[v], points.delaunay.site(v)};
    });
  of_reader = {};
  const std::uint64_t first = first_read_[ranks.rank()];
  sites_.resize(static_cast<std::size_t>(first_read_[ranks.rank() + 1] - first));
  for (const Ranks::Bytes& message : exchange(messages, ranks)) {
    Reader reader(message);
    const auto arrived = reader.packed_list<TravellingSite>();
    for (std::size_t i = 0; i < arrived.size(); ++i) {
      const TravellingSite each = arrived[i];
      if (each.number < first || each.number - first >= sites_.size()) throw Reader::does_not_match();
      sites_[each.number - first] = each.site;
    }
  }
}

int SitesOfNumbers::reader_of(std::uint64_t number) const {
  // Of ranks that have read nothing, the number of the first point is that of the next rank.
  return static_cast<int>(std::ranges::upper_bound(first_read_, number) - first_read_.begin()) - 1;
}

std::vector<Site> SitesOfNumbers::find(const std::vector<Index>& numbers) const {
  const std::uint64_t first = first_read_[ranks_.rank()];
  const auto has_read = [&](Index number) { return number >= first && number - first < sites_.size(); };
  std::vector<Site> sites(numbers.size());
  std::vector<std::size_t> unknown;
  std::vector<Index> asked;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (has_read(numbers[i])) {
      sites[i] = sites_[numbers[i] - first];
    } else {
      unknown.push_back(i);
      asked.push_back(numbers[i]);
    }
  const std::vector<Site> answers = answers_of_ranks<Site>(
      asked, 1, ranks_, [&](std::size_t i) { return reader_of(asked[i]); },
      [&](const std::vector<Index>& questions) {
        std::vector<Site> found;
        for (const Index number : questions) {
          if (!has_read(number)) throw Reader::does_not_match();
          found.push_back(sites_[number - first]);
        }
        return found;
      });
  for (std::size_t i = 0; i < unknown.size(); ++i) sites[unknown[i]] = answers[i];
  return sites;
}

}  // namespace pardel::engine
