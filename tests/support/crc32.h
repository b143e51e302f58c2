// CRC-32 as gzip, ZIP and PNG have it, bit by bit: what tests hold the libraries' own against.
#pragma once

#include <cstdint>
#include <string_view>

namespace test {

inline std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t out = ~0u;
    for (const char c : bytes) {
        out ^= static_cast<unsigned char>(c);
        for (int k = 0; k < 8; ++k)
            out = out >> 1 ^ (out & 1 ? 0xedb88320u : 0u);
    }
    return ~out;
}

} // namespace test
