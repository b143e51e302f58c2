// The frames as a table: what the rest of the program asks about a frame, and the part that computes it.
#pragma once

#include "core/surface/definition.h"

#include <cassert>
#include <iterator>

namespace surface {

/// What a frame reads of the surfels' normals. Oriented ones are summed with their signs, and so need a common one.
enum class NormalsRead { None, Unoriented, Oriented };

/// Which products of two are summed besides the rest (moments.h).
enum class Outer { None, Normals, Offsets };

struct FramePart;

struct FrameRow {
    Frame frame;
    const char* name;
    const FramePart* part; ///< computes n and f (frame_part.h)
    NormalsRead reads = NormalsRead::None;
    Outer outer = Outer::None; ///< wanted at x
    bool ownField = false;     ///< f is another than the height over a plane; mu has no part in it
    bool onCurves = false;     ///< gives directions of curves, whatever normals there are
    bool solids = false;       ///< near sheets are put together as two solids (two_solids.h), not told apart
    bool distance = true;      ///< off the surface |f| still grows as the distance does
};

#define POINTCLAY_FRAME(frame, ...) extern const FramePart frame##Part;
#include "core/surface/frames/frame_rows.inl"
#undef POINTCLAY_FRAME

inline constexpr FrameRow frameTable[] = {
#define POINTCLAY_FRAME(enumerator, text, ...)                                                                         \
    {.frame = Frame::enumerator, .name = text, .part = &enumerator##Part, __VA_ARGS__},
#include "core/surface/frames/frame_rows.inl"
#undef POINTCLAY_FRAME
};

constexpr const FrameRow& rowOf(Frame frame) {
    const std::size_t row = static_cast<std::size_t>(frame);
    assert(row < std::size(frameTable) && frameTable[row].frame == frame);
    return frameTable[row];
}

} // namespace surface
