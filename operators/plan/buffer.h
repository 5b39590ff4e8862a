// Memory for large results: an array whose elements are not written before somebody fills them. Knows no geometry.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

namespace udcp {

/// Memory of at least `bytes` bytes, uninitialised; null for 0. Large blocks are page aligned, and the system is asked for huge
/// pages, which fault 512 times less often. No page exists before it is first written, so the pages of a result belong to the
/// thread that fills them. Throws Error{limit, "E_MAX_MEMORY"} where the system refuses.
void* allocate_block(std::size_t bytes);
void free_block(void* block, std::size_t bytes) noexcept;

/// An array of `size` elements of a plain type, uninitialised; it can be moved but not copied.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  /// Throws what allocate_block throws, also where the size in bytes is no std::size_t.
  explicit Buffer(std::size_t size) : data_(static_cast<T*>(allocate_block(bytes_of(size)))), size_(size) {}
  Buffer(Buffer&& other) noexcept : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  Buffer& operator=(Buffer&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer() { free_block(data_, size_ * sizeof(T)); }

  [[nodiscard]] T* data() { return data_; }
  [[nodiscard]] const T* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] T* begin() { return data_; }
  [[nodiscard]] T* end() { return data_ + size_; }
  [[nodiscard]] const T* begin() const { return data_; }
  [[nodiscard]] const T* end() const { return data_ + size_; }
  [[nodiscard]] T& operator[](std::size_t i) { return data_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return data_[i]; }
  [[nodiscard]] std::span<T> span() { return {data_, size_}; }
  [[nodiscard]] std::span<const T> span() const { return {data_, size_}; }

 private:
  static std::size_t bytes_of(std::size_t size) {
    constexpr auto most = static_cast<std::size_t>(-1);
    return size > most / sizeof(T) ? most : size * sizeof(T);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace udcp
