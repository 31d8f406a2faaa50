// Lists of plain values that ranks send to each other.
#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "../ranks.hpp"

namespace pardel {

/// Collective. Sends lists[r] to rank r. Returns the lists for this rank; element r came from rank r.
template <class T>
[[nodiscard]] std::vector<std::vector<T>> exchange_lists(const std::vector<std::vector<T>>& lists, Ranks& ranks) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<Ranks::Bytes> messages;
  for (const std::vector<T>& list : lists) {
    Ranks::Bytes& message = messages.emplace_back(list.size() * sizeof(T));
    if (!list.empty()) std::memcpy(message.data(), list.data(), message.size());
  }
  std::vector<std::vector<T>> arrived;
  for (const Ranks::Bytes& message : ranks.exchange(std::move(messages))) {
    std::vector<T>& list = arrived.emplace_back(message.size() / sizeof(T));
    if (!list.empty()) std::memcpy(list.data(), message.data(), list.size() * sizeof(T));
  }
  return arrived;
}

/// The lists one after the other.
template <class T>
[[nodiscard]] std::vector<T> concatenated(const std::vector<std::vector<T>>& lists) {
  std::vector<T> all;
  for (const std::vector<T>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// Collective. Sends the list to all ranks. Returns the lists of all ranks.
template <class T>
[[nodiscard]] std::vector<std::vector<T>> lists_of_all(const std::vector<T>& list, Ranks& ranks) {
  return exchange_lists(std::vector<std::vector<T>>(static_cast<std::size_t>(ranks.count()), list), ranks);
}

}  // namespace pardel
