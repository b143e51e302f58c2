// An array of many plain values in large pages (large_memory.h) that nobody initialises: who makes it writes every
// value before reading it, in parallel at best, so that no core waits for another to touch fresh memory.
//
// Owns its memory, moves like a vector and passes for a span; small ones come from the ordinary heap.
#pragma once

#include "core/base/large_memory.h"

#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>

namespace base {

template <class T>
class LargeArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  public:
    LargeArray() = default;
    explicit LargeArray(std::size_t size) : m_size(size) {
        if (size == 0)
            return;
        void* memory = bytes() < large ? std::malloc(bytes()) : allocateLarge(bytes());
        if (!memory)
            throw std::bad_alloc();
        m_data = static_cast<T*>(memory);
    }
    ~LargeArray() { release(); }
    LargeArray(LargeArray&& other) noexcept
        : m_data(std::exchange(other.m_data, nullptr)), m_size(std::exchange(other.m_size, 0)) {}
    LargeArray& operator=(LargeArray&& other) noexcept {
        if (this != &other) {
            release();
            m_data = std::exchange(other.m_data, nullptr);
            m_size = std::exchange(other.m_size, 0);
        }
        return *this;
    }

    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }
    T* data() { return m_data; }
    const T* data() const { return m_data; }
    T& operator[](std::size_t i) { return m_data[i]; }
    const T& operator[](std::size_t i) const { return m_data[i]; }
    T* begin() { return m_data; }
    T* end() { return m_data + m_size; }
    const T* begin() const { return m_data; }
    const T* end() const { return m_data + m_size; }
    /// Forgets what is behind the first `size`. REQUIRES: size <= size().
    void shrink(std::size_t size) { m_size = size; }

  private:
    static constexpr std::size_t large = std::size_t(1) << 21; ///< bytes
    std::size_t bytes() const { return m_size * sizeof(T); }
    void release() { freeLarge(m_data); } // takes what malloc gave, too

    T* m_data = nullptr;
    std::size_t m_size = 0;
};

} // namespace base
