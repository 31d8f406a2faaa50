// Lists of plain values that ranks send to each other.
#pragma once

#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "../ranks.hpp"
#include "stop_signal.hpp"

namespace pardel {

template <class T>
[[nodiscard]] Ranks::Bytes to_bytes(const std::vector<T>& list) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto bytes = std::as_bytes(std::span(list));
  return {bytes.begin(), bytes.end()};
}

template <class T>
[[nodiscard]] std::vector<T> list_in(const Ranks::Bytes& bytes) {
  std::vector<T> list(bytes.size() / sizeof(T));
  if (!list.empty()) std::memcpy(list.data(), bytes.data(), list.size() * sizeof(T));
  return list;
}

/// Collective. Sends lists[r] to rank r. Returns the lists for this rank; element r came from rank r. The list of this
/// rank for itself, which is often the longest one, is not copied.
template <class T>
[[nodiscard]] std::vector<std::vector<T>> exchange_lists(std::vector<std::vector<T>> lists, Ranks& ranks) {
  const auto here = static_cast<std::size_t>(ranks.rank());
  std::vector<Ranks::Bytes> messages(lists.size());
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
    if (rank != here) messages[rank] = to_bytes(std::exchange(lists[rank], {}));
  messages = ranks.exchange(std::move(messages));
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
    if (rank != here) lists[rank] = list_in<T>(std::exchange(messages[rank], {}));
  return lists;
}

/// The lists one after the other.
template <class T>
[[nodiscard]] std::vector<T> concatenated(const std::vector<std::vector<T>>& lists) {
  std::size_t size = 0;
  for (const std::vector<T>& list : lists) size += list.size();
  std::vector<T> all;
  all.reserve(size);
  for (const std::vector<T>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// Collective. Sends the list to all ranks. Returns the lists of all ranks.
template <class T>
[[nodiscard]] std::vector<std::vector<T>> lists_of_all(const std::vector<T>& list, Ranks& ranks) {
  return exchange_lists(std::vector<std::vector<T>>(static_cast<std::size_t>(ranks.count()), list), ranks);
}

/// Collective. Returns the value that one rank has; the others pass an empty list. Throws Stopped with an internal
/// error if none has it.
template <class T>
[[nodiscard]] T value_of_one(const std::vector<T>& value, Ranks& ranks) {
  const std::vector<T> all = concatenated(lists_of_all(value, ranks));
  if (all.empty()) throw Stopped{{ErrorKind::internal, "a value that one rank has is missing"}};
  return all.front();
}

}  // namespace pardel
