#include "sites_of_numbers.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/answers_of_ranks.hpp"
#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/message.hpp"

namespace pardel::engine {
namespace {

struct TravellingSite {
  std::uint64_t number;
  Site site;
};

}  // namespace

SitesOfNumbers::SitesOfNumbers(const TriangulatedPoints& points, Ranks& ranks) : ranks_(ranks) {
  const std::uint64_t all = points.own.first.back();
  share_ = all / static_cast<std::uint64_t>(ranks.count()) + 1;
  first_ = std::min(share_ * static_cast<std::uint64_t>(ranks.rank()), all);
  sites_.resize(static_cast<std::size_t>(std::min(first_ + share_, all) - first_));
  std::vector<std::vector<TravellingSite>> leaving(static_cast<std::size_t>(ranks.count()));
  std::size_t known = 0;
  const auto place = [&](const TravellingSite& each) {
    if (!keeps(each.number)) throw Reader::does_not_match();
    sites_[each.number - first_] = each.site;
    ++known;
  };
  for (VertexId v = 0; v < points.delaunay.own(); ++v) {
    const TravellingSite each{points.own.number[v], points.delaunay.site(v)};
    if (keeps(each.number))
      place(each);
    else
      leaving[keeper_of(each.number)].push_back(each);
  }
  for (const std::vector<TravellingSite>& arrived : exchange_lists(std::move(leaving), ranks))
    for (const TravellingSite& each : arrived) place(each);
  if (known != sites_.size()) throw Reader::does_not_match();
}

std::vector<Site> SitesOfNumbers::find(const std::vector<Index>& numbers) const {
  std::vector<Site> sites(numbers.size());
  std::vector<std::size_t> unknown;
  std::vector<Index> asked;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (keeps(numbers[i])) {
      sites[i] = sites_[numbers[i] - first_];
    } else {
      unknown.push_back(i);
      asked.push_back(numbers[i]);
    }
  const std::vector<Site> answers = answers_of_ranks<Site>(
      asked, 1, ranks_, [&](std::size_t i) { return keeper_of(asked[i]); },
      [&](const std::vector<Index>& questions) {
        std::vector<Site> found;
        for (const Index number : questions) {
          if (!keeps(number)) throw Reader::does_not_match();
          found.push_back(sites_[number - first_]);
        }
        return found;
      });
  for (std::size_t i = 0; i < unknown.size(); ++i) sites[unknown[i]] = answers[i];
  return sites;
}

}  // namespace pardel::engine
