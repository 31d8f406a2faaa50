// The seam at which a test watches which triangles a task touches. Where PARDEL_TOUCHES is not defined, that is in
// everything but the test that defines it, the watched array is the array itself.
#pragma once

#include "../../core/array.hpp"

#ifdef PARDEL_TOUCHES
#include <vector>
#endif

namespace pardel::engine {

#ifdef PARDEL_TOUCHES

/// Where the calling thread notes what it touches; nullptr: nowhere.
inline thread_local std::vector<std::size_t>* touches = nullptr;

template <class T>
class WatchedArray : public Array<T> {
 public:
  using Array<T>::Array;
  T& operator[](std::size_t i) {
    note(i);
    return Array<T>::operator[](i);
  }
  const T& operator[](std::size_t i) const {
    note(i);
    return Array<T>::operator[](i);
  }

 private:
  static void note(std::size_t i) {
    if (touches != nullptr) touches->push_back(i);
  }
};

#else

template <class T>
using WatchedArray = Array<T>;

#endif

}  // namespace pardel::engine
