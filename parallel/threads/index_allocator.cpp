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
  pool.for_each_left([&](IndexRange r) {
    free_.push_back(r);
    free_count_ += r.size();
  });
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

IndexMoves::IndexMoves(const IndexAllocator& allocator) : in_use_(allocator.in_use()) {
  to_.reserve(allocator.end() - in_use_);
  const std::vector<IndexRange>& holes = allocator.holes();
  auto above = std::find_if(holes.begin(), holes.end(), [&](IndexRange h) { return h.end > in_use_; });
  Index from = in_use_;
  for (const IndexRange hole : holes)
    for (Index to = hole.begin; to < std::min(hole.end, in_use_); ++to) {
      while (above != holes.end() && from >= above->begin) from = (above++)->end;
      to_.resize(from - in_use_, no_index);
      to_.push_back(to);
      ++from;
    }
}

}  // namespace pardel::engine
