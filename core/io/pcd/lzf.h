// The compression LZF of liblzf, as PCD files use it: runs of bytes as they are, and copies from the 8 KiB before.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace io {

/// The most bytes that `packed` of them can become: three tell of a copy of 264.
constexpr std::size_t lzfMost(std::size_t packed) {
    return packed / 3 * 264 + 264;
}

/// Whether `packed` is whole and fills `out` exactly.
bool unpackLzf(std::string_view packed, std::span<char> out);

} // namespace io
