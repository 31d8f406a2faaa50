// An array of which few parts are used.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::engine {

/// Maps all indices to values; those that were never set have the value T{}. Memory is used only for the pages of 1024
/// indices in which a value was set. Constant time.
template <class T>
class SparseArray {
 public:
  [[nodiscard]] T get(Index i) const {
    const std::size_t page = i / size_of_page;
    return page < pages_.size() && pages_[page] ? (*pages_[page])[i % size_of_page] : T{};
  }
  /// Calls visit(begin, end, may_be_set) for runs that together are the indices from `first` to `last` - 1, in
  /// ascending order. If `may_be_set` is false, all values of the run are T{}.
  template <class Visit>
  void for_each_run(Index first, Index last, const Visit& visit) const {
    for (Index begin = first; begin < last;) {
      const std::size_t page = begin / size_of_page;
      const Index end = begin + std::min(last - begin, size_of_page - begin % size_of_page);
      visit(begin, end, page < pages_.size() && pages_[page] != nullptr);
      begin = end;
    }
  }
  void set(Index i, const T& value) {
    const std::size_t page = i / size_of_page;
    if (page >= pages_.size()) pages_.resize(page + 1);
    if (!pages_[page]) pages_[page] = std::make_unique<Page>();
    (*pages_[page])[i % size_of_page] = value;
  }

 private:
  static constexpr Index size_of_page = 1024;
  using Page = std::array<T, size_of_page>;
  std::vector<std::unique_ptr<Page>> pages_;
};

}  // namespace pardel::engine
