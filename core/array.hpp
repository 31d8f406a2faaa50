// Array<T>: a growable array of trivially copyable values whose growth neither copies nor doubles the
// peak memory: large blocks are grown by moving pages instead of bytes, and pages that are reserved but not
// written cost nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace pardel {
namespace detail {
/// realloc for blocks of any size: nullptr where there is no memory (the old block then stays). Large blocks are
/// mappings of their own, grown without copying, on huge pages where the system has them.
[[nodiscard]] void* grow_block(void* block, std::size_t old_bytes, std::size_t new_bytes);
void free_block(void* block, std::size_t bytes);
}  // namespace detail

template <class T>
class Array {
  static_assert(std::is_trivially_copyable_v<T>, "Array moves its elements as bytes");

 public:
  using value_type = T;

  Array() = default;
  explicit Array(std::size_t n, const T& value = T{}) { resize(n, value); }
  explicit Array(std::span<const T> values) { append(values); }
  Array(const Array& other) : Array(other.span()) {}
  Array(Array&& other) noexcept { swap(other); }
  Array& operator=(Array other) noexcept {
    swap(other);
    return *this;
  }
  ~Array() { detail::free_block(data_, capacity_ * sizeof(T)); }

  /// Takes over the storage of an array of another type of the same size, bytes unchanged.
  template <class U>
  [[nodiscard]] static Array recast(Array<U>&& other) {
    static_assert(sizeof(T) == sizeof(U) && std::is_trivially_copyable_v<U>);
    Array result;
    result.data_ = reinterpret_cast<T*>(std::exchange(other.data_, nullptr));
    result.size_ = std::exchange(other.size_, 0);
    result.capacity_ = std::exchange(other.capacity_, 0);
    return result;
  }

  void swap(Array& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T& back() { return data_[size_ - 1]; }
  const T& back() const { return data_[size_ - 1]; }
  [[nodiscard]] std::span<T> span() { return {data_, size_}; }
  [[nodiscard]] std::span<const T> span() const { return {data_, size_}; }

  /// Room for n elements without moving; throws std::bad_alloc. Never shrinks.
  void reserve(std::size_t n) {
    if (n <= capacity_) return;
    if (n > SIZE_MAX / sizeof(T)) throw std::bad_alloc();
    void* grown = detail::grow_block(data_, capacity_ * sizeof(T), n * sizeof(T));
    if (grown == nullptr) throw std::bad_alloc();
    data_ = static_cast<T*>(grown);
    capacity_ = n;
  }
  void push_back(const T& value) {
    const T copy = value;  // value may lie inside this array, which reserve may move
    if (size_ == capacity_) reserve(grown_capacity(size_ + 1));
    data_[size_++] = copy;
  }
  void append(std::span<const T> values) {
    if (values.empty()) return;
    if (size_ + values.size() > capacity_) reserve(grown_capacity(size_ + values.size()));
    std::memcpy(static_cast<void*>(data_ + size_), values.data(), values.size_bytes());
    size_ += values.size();
  }
  void resize(std::size_t n, const T& value = T{}) {
    const T copy = value;  // as in push_back
    if (n > capacity_) reserve(n);
    for (std::size_t i = size_; i < n; ++i) data_[i] = copy;
    size_ = n;
  }
  /// New elements hold whatever the memory holds (zero bytes, in a large block not used before); pages of a
  /// large block that nobody writes cost nothing.
  void resize_uninitialised(std::size_t n) {
    if (n > capacity_) reserve(grown_capacity(n));
    size_ = n;
  }
  void pop_back() { --size_; }
  void clear() { size_ = 0; }
  /// Gives the unused tail back to the system.
  void shrink_to_fit() {
    if (size_ == capacity_) return;
    if (size_ == 0) {
      Array().swap(*this);
      return;
    }
    if (void* shrunk = detail::grow_block(data_, capacity_ * sizeof(T), size_ * sizeof(T))) {
      data_ = static_cast<T*>(shrunk);
      capacity_ = size_;
    }
  }

  friend bool operator==(const Array& a, const Array& b) {
    if (a.size_ != b.size_) return false;
    for (std::size_t i = 0; i < a.size_; ++i)
      if (!(a.data_[i] == b.data_[i])) return false;
    return true;
  }

 private:
  [[nodiscard]] std::size_t grown_capacity(std::size_t needed) const {
    const std::size_t generous = capacity_ + capacity_ / 2 + 16;
    return generous > needed ? generous : needed;
  }

  template <class U>
  friend class Array;

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace pardel
