// Arrays in the device's memory (memory.hpp).
#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/backend/device/loops.hpp"
#include "sim/backend/device/memory.hpp"
#include "sim/core/bytes.hpp"
#include "sim/core/real.hpp"

namespace spindrift::sim::inline device {

/// Number of elements that are read together, side by side in memory: one per thread of a warp.
constexpr int lane_count = 32;

/// Sets n elements to one value, after all that the device was given before.
template <class T>
void fill(T* values, std::size_t n, const T& value) {
  const T one = value;
  launch(static_cast<std::uint32_t>(n), [=] SPINDRIFT_HD(std::uint32_t k) { values[k] = one; });
}

/// As much of std::vector as the solvers need. The host may access elements after wait().
template <class T>
class Array {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  using value_type = T;

  Array() = default;
  explicit Array(std::size_t size, const T& value = T{}) { resize(size, value); }
  Array(const Array& other) { assign(other.begin(), other.end()); }
  Array(Array&& other) noexcept { swap(other); }
  Array& operator=(Array other) noexcept {
    swap(other);
    return *this;
  }
  ~Array() { release(data_); }

  void reserve(std::size_t capacity) {
    if (capacity <= capacity_)
      return;
    T* const larger = static_cast<T*>(allocate(capacity * sizeof(T)));
    copy_in(larger, data_, size_ * sizeof(T));
    wait();
    release(data_);
    data_ = larger;
    capacity_ = capacity;
  }
  /// The device writes the new elements. The host waits for that only if the array needs memory.
  void resize(std::size_t size, const T& value = T{}) {
    const bool larger = size > capacity_;
    if (larger)
      reserve(size + size / 16);
    if (size > size_)
      fill(data_ + size_, size - size_, value);
    size_ = size;
    if (larger)
      wait();
  }
  /// Resizes the array; the values of its elements are lost if it needs more memory.
  void renew(std::size_t size) {
    if (size > capacity_) {
      wait();
      release(std::exchange(data_, nullptr));
      size_ = capacity_ = 0;
      reserve(size + size / 8);
    }
    size_ = size;
  }
  template <class Iterator>
  void assign(Iterator first, Iterator last) {
    renew(static_cast<std::size_t>(last - first));
    wait();
    std::copy(first, last, data_);
  }
  void swap(Array& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* data() { return data_; }
  const T* data() const { return data_; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  bool empty() const { return size_ == 0; }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

/// Sets all elements to one value.
template <class T>
void set_all(Array<T>& values, const T& value) {
  fill(values.data(), values.size(), value);
}

/// Resizes an array; the values of its elements may be lost.
template <class T>
void grow(Array<T>& values, std::size_t size) {
  values.renew(size);
}

/// Copies a host vector into an array, after all that the device was given before.
template <class T>
void put(Array<T>& values, const std::vector<T>& from) {
  values.renew(from.size());
  copy_in(values.data(), from.data(), from.size() * sizeof(T));
}

}  // namespace spindrift::sim::inline device
