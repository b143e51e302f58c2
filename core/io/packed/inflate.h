// DEFLATE unpacked piece by piece; zlib, which does it, stays behind this header.
#pragma once

#include "core/base/progress.h"

#include <cstddef>
#include <functional>
#include <string_view>

namespace io {

enum class Wrapping { None, Gzip };
enum class InflateEnd { Whole, CutOff, Damaged, TooLong };

struct Inflated {
    InflateEnd end = InflateEnd::CutOff;
    std::size_t used = 0; ///< packed bytes
    std::size_t made = 0; ///< unpacked bytes, all of which went to the sink
};

/// What so many packed bytes may become: DEFLATE can repeat one byte a thousandfold, which no honest model is like.
constexpr std::size_t mostInflated(std::size_t packed) {
    return (std::size_t(64) << 20) + 100 * packed;
}

/// One stream from the start of `packed`, in pieces of some 256 KiB. Ends before more than `most` bytes went to the
/// sink. Throws base::Cancelled.
Inflated inflate(std::string_view packed, Wrapping wrapping, std::size_t most, const base::Progress& progress,
                 const std::function<void(std::string_view)>& sink);

} // namespace io
