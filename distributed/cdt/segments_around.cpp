#include "segments_around.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/message.hpp"
#include "../../core/support/without_repetitions.hpp"
#include "../../parallel/threads/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

struct TravellingName {
  std::uint64_t a, b;  ///< positions of the ends
  Name name;
};

}  // namespace

SegmentsAround::SegmentsAround(std::span<const GivenSegment> common, std::span<const GivenSegment> own,
                               std::vector<std::uint64_t> needed, const OwnPoints& points, Ranks& ranks,
                               const Threads& threads)
    : points_(points), ranks_(ranks), first_(points.first[ranks.rank()]), needed_(std::move(needed)) {
  sort_without_repetitions(needed_);
  name_own(common, own);
  learn_segments_around();
  list_ends();
  compute(threads);
}

bool SegmentsAround::is_known(const Site& end) const {
  return is_own(end.position) || std::ranges::binary_search(needed_, end.position);
}

/// The owner of end a tells the owner of end b how it has named a segment.
void SegmentsAround::name_own(std::span<const GivenSegment> common, std::span<const GivenSegment> own) {
  segments_.reserve(common.size() + own.size());
  for (const GivenSegment& s : common) segments_.push_back({s, {Name::everyone, static_cast<Index>(segments_.size())}});
  std::vector<std::vector<TravellingName>> leaving(static_cast<std::size_t>(ranks_.count()));
  std::vector<GivenSegment> of_others;
  for (const GivenSegment& s : own) {
    if (!is_own(s.a.position)) {
      of_others.push_back(s);
      continue;
    }
    const Name name{Name::rank(ranks_.rank()), static_cast<Index>(segments_.size())};
    segments_.push_back({s, name});
    if (const int other = points_.owner(s.b.position); other != ranks_.rank())
      leaving[other].push_back({s.a.position, s.b.position, name});
  }
  std::size_t named = 0;
  for (const TravellingName& each : concatenated(exchange_lists(std::move(leaving), ranks_))) {
    const GivenSegment* const s = with_ends(of_others, {each.a, each.b});
    if (s == nullptr) throw Reader::does_not_match();
    segments_.push_back({*s, each.name});
    ++named;
  }
  if (named != of_others.size()) throw Reader::does_not_match();
}

/// Three rounds: the segments at the needed vertices, those at the other ends, and those at the other ends of these.
void SegmentsAround::learn_segments_around() {
  std::vector<std::uint64_t> asked, next = needed_;
  std::set<PositionsOfEnds> known;
  std::size_t listed = 0;
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    std::erase_if(
        next, [&](std::uint64_t position) { return is_own(position) || std::ranges::binary_search(asked, position); });
    const std::vector<NamedSegment> found = segments_at(next);
    asked.insert(asked.end(), next.begin(), next.end());
    std::ranges::sort(asked);
    next.clear();
    // Segments that other ranks know may be among those of this rank.
    for (const auto& [s, name] : found)
      if (!is_own(s.a.position) && !is_own(s.b.position) && known.insert(ends_of(s)).second)
        segments_.push_back({s, name});
    for (; listed < segments_.size(); ++listed)
      for (const Site& end : {segments_[listed].segment.a, segments_[listed].segment.b})
        if (!is_own(end.position)) next.push_back(end.position);
    sort_without_repetitions(next);
  }
}

/// Collective. What the owners of the points know about the segments at them, without the common ones.
std::vector<NamedSegment> SegmentsAround::segments_at(const std::vector<std::uint64_t>& positions) {
  std::vector<std::vector<std::uint64_t>> questions(static_cast<std::size_t>(ranks_.count()));
  for (const std::uint64_t position : positions) questions[points_.owner(position)].push_back(position);
  questions = exchange_lists(std::move(questions), ranks_);
  std::vector<std::pair<std::uint64_t, int>> asked;  // with the ranks that ask
  for (int rank = 0; rank < ranks_.count(); ++rank)
    for (const std::uint64_t position : questions[rank]) asked.emplace_back(position, rank);
  std::ranges::sort(asked);
  std::vector<std::vector<NamedSegment>> answers(questions.size());
  for (const NamedSegment& each : segments_) {
    if (each.name.creator == Name::everyone) continue;
    for (const std::uint64_t end : {each.segment.a.position, each.segment.b.position})
      for (auto at = std::ranges::lower_bound(asked, std::pair(end, 0)); at != asked.end() && at->first == end; ++at)
        answers[at->second].push_back(each);
  }
  return concatenated(exchange_lists(std::move(answers), ranks_));
}

void SegmentsAround::list_ends() {
  // Own points follow one another, so they need not be sorted.
  std::vector<Site> own(static_cast<std::size_t>(points_.first[ranks_.rank() + 1] - first_));
  std::vector<bool> is_end(own.size());
  std::vector<Site> others;
  for (const NamedSegment& each : segments_)
    for (const Site& end : {each.segment.a, each.segment.b})
      if (is_own(end.position)) {
        own[end.position - first_] = end;
        is_end[end.position - first_] = true;
      } else {
        others.push_back(end);
      }
  sort_by_position(others);
  const auto after = others.begin() + static_cast<std::ptrdiff_t>(count_before(others, first_));
  ends_.assign(others.begin(), after);
  ends_.reserve(others.size() + static_cast<std::size_t>(std::ranges::count(is_end, true)));
  index_of_own_.resize(own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    index_of_own_[i] = static_cast<Index>(ends_.size());
    if (is_end[i]) ends_.push_back(own[i]);
  }
  ends_.insert(ends_.end(), after, others.end());
}

Index SegmentsAround::index_of(const Site& end) const {
  return is_own(end.position) ? index_of_own_[end.position - first_] : count_before(ends_, end.position);
}

Index SegmentsAround::index_of(std::uint64_t position) const {
  const Index before = count_before(ends_, position);
  return before < ends_.size() && ends_[before].position == position ? before : no_index;
}

Array<Point> SegmentsAround::places_of_ends(const Threads& threads) const {
  return make_array(threads, ends_.size(), [&](std::size_t i) { return ends_[i].at; });
}

/// The owner of a tip knows all segments there.
void SegmentsAround::keep_clear(std::vector<Hairline> all) {
  if (all.empty()) return;
  const Array<Point> points = places_of_ends({});
  std::vector<Hairline> here;
  for (Hairline& line : all) {
    if (!is_own(line.tip)) continue;
    const Index tip = index_of(line.tip);
    if (tip == no_index) continue;
    line.slope = slope_at_tip(line, tip, domain_segments_, points);
    here.push_back(line);
  }
  for (const Hairline& line : concatenated(lists_of_all(here, ranks_)))
    engine::keep_clear(line, index_of(line.tip), domain_segments_.segment_between(index_of(line.a), index_of(line.b)),
                       domain_segments_, points);
}

void SegmentsAround::compute(const Threads& threads) {
  const Array<Point> points = places_of_ends(threads);
  std::vector<Constraint> constraints;
  constraints.reserve(segments_.size());
  for (const auto& [s, name] : segments_) constraints.push_back({index_of(s.a), index_of(s.b)});
  domain_segments_ = DomainSegments(points, constraints, {}, threads);
  index_of_own_ = {};
}

}  // namespace pardel::engine
