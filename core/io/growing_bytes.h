// Bytes that grow in place where the machine can, so that a table that becomes large does not need twice its memory:
// for readers whose files do not prove beforehand how much they hold.
#pragma once

#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>

namespace io {

class GrowingBytes {
  public:
    GrowingBytes() = default;
    ~GrowingBytes() { std::free(m_data); }
    GrowingBytes(const GrowingBytes&) = delete;
    GrowingBytes& operator=(const GrowingBytes&) = delete;

    char* data() { return m_data; }
    std::size_t size() const { return m_size; }
    /// So many more bytes, which have no value yet; returns where they are.
    char* grow(std::size_t by) {
        void* const grown = std::realloc(m_data, m_size + by);
        if (!grown)
            throw std::bad_alloc();
        m_data = static_cast<char*>(grown);
        m_size += by;
        return m_data + m_size - by;
    }
    void append(std::string_view bytes) {
        if (!bytes.empty())
            std::memcpy(grow(bytes.size()), bytes.data(), bytes.size());
    }

  private:
    char* m_data = nullptr;
    std::size_t m_size = 0;
};

} // namespace io
