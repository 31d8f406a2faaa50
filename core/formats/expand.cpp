#include "expand.hpp"

#include <zlib.h>

namespace pardel::files {

bool append_expanded(std::string_view compressed, std::size_t size, std::string& to) {
  constexpr std::size_t largest_ratio = 1032;
  if (size / largest_ratio > compressed.size()) return false;
  const std::size_t start = to.size();
  to.resize(start + size);
  uLongf expanded = size;
  uLong used = compressed.size();
  const int status = uncompress2(reinterpret_cast<Bytef*>(to.data() + start), &expanded,
                                 reinterpret_cast<const Bytef*>(compressed.data()), &used);
  return status == Z_OK && expanded == size;
}

}  // namespace pardel::files
