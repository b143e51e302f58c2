// Files of gzip (RFC 1952) around DEFLATE that packs nothing: what tests hold the readers' zlib against.
#pragma once

#include "support/crc32.h"

#include <string>

namespace test {

/// One member whose blocks hold the bytes as they are, 65,535 at most in each. Without `checked` its checksum is wrong.
inline std::string storedGzip(std::string_view bytes, bool checked = true) {
    std::string out("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10);
    const auto number = [&](std::uint32_t value, int size) {
        for (int k = 0; k < size; ++k)
            out += static_cast<char>(value >> 8 * k);
    };
    std::string_view left = bytes;
    do {
        const std::string_view block = left.substr(0, 65535);
        left.remove_prefix(block.size());
        number(left.empty() ? 1 : 0, 1);
        number(static_cast<std::uint32_t>(block.size()), 2);
        number(~static_cast<std::uint32_t>(block.size()), 2);
        out += block;
    } while (!left.empty());
    number(test::crc32(bytes) ^ (checked ? 0u : 1u), 4);
    number(static_cast<std::uint32_t>(bytes.size()), 4);
    return out;
}

} // namespace test
