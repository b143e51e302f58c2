// Numbers in the bytes of a LAS record, little-endian.
#pragma once

#include <cstdint>
#include <cstring>

namespace io::laz {

template <class T>
T get(const char* at) {
    T out;
    std::memcpy(&out, at, sizeof out);
    return out;
}

template <class T>
void set(char* at, T value) {
    std::memcpy(at, &value, sizeof value);
}

inline unsigned byteAt(const char* at) {
    return static_cast<unsigned char>(*at);
}

/// Differences of coordinates and times go around, as those of unsigned numbers do.
inline std::int32_t plus(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
inline std::int32_t minus(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
inline std::int32_t times(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b));
}

} // namespace io::laz
