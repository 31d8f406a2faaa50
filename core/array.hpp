// Array<T>: a growable array of trivially copyable values. A large array grows by moving pages, not by copying bytes,
// so growth does not double the peak memory. Pages that are reserved but never written take no memory.
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
/// Like realloc, for blocks of any size. Returns nullptr if memory is short; the old block then remains valid. A large
/// block has its own memory mapping: it grows without copying, and uses huge pages if the system has them.
[[nodiscard]] void* grow_block(void* block, std::size_t old_bytes, std::size_t new_bytes);
/// A block of zero bytes for free_block(), or nullptr. The pages of a large block take no memory before they are
/// written.
[[nodiscard]] void* zero_block(std::size_t bytes);
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

  /// n values whose bytes are all zero. If they are many, those that are never written take neither time nor memory.
  /// Throws std::bad_alloc.
  [[nodiscard]] static Array zeroes(std::size_t n) {
    Array result;
    if (n == 0) return result;
    if (n > SIZE_MAX / sizeof(T)) throw std::bad_alloc();
    result.data_ = static_cast<T*>(detail::zero_block(n * sizeof(T)));
    if (result.data_ == nullptr) throw std::bad_alloc();
    result.size_ = result.capacity_ = n;
    return result;
  }

  /// Takes over the storage of an array whose elements have another type of the same size. The bytes do not change.
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

  /// Reserves memory for n elements, so growth up to n elements moves no element. Never shrinks. Throws std::bad_alloc.
  void reserve(std::size_t n) {
    if (n <= capacity_) return;
    if (n > SIZE_MAX / sizeof(T)) throw std::bad_alloc();
    void* grown = detail::grow_block(data_, capacity_ * sizeof(T), n * sizeof(T));
    if (grown == nullptr) throw std::bad_alloc();
    data_ = static_cast<T*>(grown);
    capacity_ = n;
  }
  void push_back(const T& value) {
    const T copy = value;  // value may be an element of this array, which reserve() may move
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
    const T copy = value;  // may be an element of this array: see push_back
    if (n > capacity_) reserve(n);
    for (std::size_t i = size_; i < n; ++i) data_[i] = copy;
    size_ = n;
  }
  /// New elements are not initialised. In a large block, memory that was never used before contains zero bytes. Pages
  /// of a large block that are never written take no memory.
  void resize_uninitialised(std::size_t n) {
    if (n > capacity_) reserve(grown_capacity(n));
    size_ = n;
  }
  void pop_back() { --size_; }
  void clear() { size_ = 0; }
  /// Returns the unused memory at the end to the system.
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
