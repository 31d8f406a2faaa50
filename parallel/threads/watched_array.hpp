// An array that can record the indices that are accessed. A test uses it to check which triangles each task accesses.
// The recording exists only where PARDEL_WATCHED_ARRAYS is defined: in the library pardel_watched, and in the engine
// with known mistakes (properties/mutants). Everywhere else WatchedArray is Array.
#pragma once

#include "../../core/array.hpp"

#ifdef PARDEL_WATCHED_ARRAYS
#include <vector>
#endif

namespace pardel::engine {

#ifdef PARDEL_WATCHED_ARRAYS

/// The list to which the calling thread appends every index that it accesses. With nullptr nothing is recorded.
inline thread_local std::vector<std::size_t>* watched_indices = nullptr;

template <class T>
class WatchedArray : public Array<T> {
 public:
  using Array<T>::Array;
  T& operator[](std::size_t i) {
    record(i);
    return Array<T>::operator[](i);
  }
  const T& operator[](std::size_t i) const {
    record(i);
    return Array<T>::operator[](i);
  }

 private:
  static void record(std::size_t i) {
    if (watched_indices != nullptr) watched_indices->push_back(i);
  }
};

#else

template <class T>
using WatchedArray = Array<T>;

#endif

}  // namespace pardel::engine
