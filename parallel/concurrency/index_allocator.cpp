#include "index_allocator.hpp"

namespace pardel::engine {

void IndexAllocator::allocate(std::size_t count, std::vector<IndexRange>& ranges) {
  while (count > 0 && first_free_ < free_.size()) {
    IndexRange& lowest = free_[first_free_];
    const auto take = static_cast<Index>(std::min<std::size_t>(count, lowest.size()));
    ranges.push_back({lowest.begin, lowest.begin + take});
    lowest.begin += take;
    free_count_ -= take;
    count -= take;
    if (lowest.size() == 0) ++first_free_;
  }
  const auto fresh = static_cast<Index>(std::min<std::size_t>(count, limit_ - end_));
  if (fresh > 0) ranges.push_back({end_, end_ + fresh});
  end_ += fresh;
}

void IndexAllocator::release(const IndexPool& pool) {
  for (const IndexRange r : pool.rest()) {
    free_.push_back(r);
    free_count_ += r.size();
  }
}

void IndexAllocator::settle() {
  std::erase_if(free_, [](IndexRange r) { return r.size() == 0; });
  std::sort(free_.begin(), free_.end(), [](IndexRange a, IndexRange b) { return a.begin < b.begin; });
  std::vector<IndexRange> joined;
  for (const IndexRange r : free_) {
    if (!joined.empty() && joined.back().end == r.begin)
      joined.back().end = r.end;
    else
      joined.push_back(r);
  }
  if (!joined.empty() && joined.back().end == end_) {
    end_ = joined.back().begin;
    free_count_ -= joined.back().size();
    joined.pop_back();
  }
  free_ = std::move(joined);
  first_free_ = 0;
}

std::vector<IndexMove> moves_into_holes(const IndexAllocator& allocator) {
  const std::vector<IndexRange>& holes = allocator.holes();
  const Index in_use = allocator.in_use();
  std::vector<Index> targets;
  for (const IndexRange hole : holes)
    for (Index n = hole.begin; n < std::min(hole.end, in_use); ++n) targets.push_back(n);

  std::vector<IndexMove> moves;
  moves.reserve(targets.size());
  auto hole = std::find_if(holes.begin(), holes.end(), [&](IndexRange h) { return h.end > in_use; });
  for (Index from = in_use; moves.size() < targets.size(); ++from) {
    while (hole != holes.end() && from >= hole->begin && from < hole->end) from = (hole++)->end;
    moves.push_back({from, targets[moves.size()]});
  }
  return moves;
}

}  // namespace pardel::engine
