// Adaptive ray casting (raycast/README 2 and 3): rays where the surface varies, interpolation between them where it
// does not, and what one view found is used again in the next.
//
//     AdaptiveCast cast(surface);
//     cast.cast(view, {.quality = 1}, counts, shown)   again and again; `shown` sees every level as it is finished
//     cast.setSurface(next version)                     drops what the edit touched
//
// Rays sit on pixel centres, at the corners of square cells: one start size for the view, halved down to the pixel.
// A split casts up to 5 rays, at the middles of the cell's sides and of the cell. How far they are from what the
// corners predicted decides whether the quarters are split further. Cells that the surface covers in part always are,
// and so are those where small discs about the surfels show something that no ray has met: outlines are exact to the
// pixel. Pixels far from any surfel are background without a ray.
//
// Between views the leaves are kept as patches in space. The next view draws them again where it shows the same side
// and does not magnify them too much, and casts rays for the rest. After an edit, patches and rays within the supports
// of changed surfels are dropped.
//
//     cast_pixels.h   rays of chosen pixels            splat_guard.h       what discs know before a ray is cast
//     lattice.h       what is known of each pixel      subdivision.h       which cells are split
//     patch.h         between nine samples             adaptive_picture.h  the pixels
//     kept_patches.h  patches of earlier views         redraw.h            their pixels in a new one
//     edited_region.h where an edit moved the surface
//
// The same bits at any thread count. Used by one thread at a time, which may be any: the caster keeps its version of
// the model alive. A picture of the same view continues where the last one ended, cancelled or not.
#pragma once

#include "core/raycast/full_cast.h"

#include <functional>
#include <memory>

namespace raycast {

struct AdaptiveOptions {
    /// In units of a pixel: 1 aims at normals within 2 degrees and depths within 0.2 of the spacing of the surfels, 2
    /// at twice that. 0: every pixel its own ray, the bits of fullCast. Negative is 0.
    double quality = 1;
};

/// What a pixel of an adaptive picture rests on.
enum class Known : std::uint8_t {
    Nothing,      ///< not known at this level; its sample is a miss that means nothing
    Interpolated, ///< between rays, redrawn from another view, or background that needed no ray
    Exact,        ///< a ray through its centre
};

/// A picture in the making; the caster's own memory, which stays as it is until its next call.
struct AdaptiveImage {
    std::span<const Sample> samples; ///< row by row from the top
    std::span<const Known> known;
    double quality = 0;    ///< reached wherever something is known
    bool complete = false; ///< no pixel is Known::Nothing
};

class AdaptiveCast {
  public:
    using OnLevel = std::function<void(const AdaptiveImage&)>;

    explicit AdaptiveCast(surface::Surface surface);
    ~AdaptiveCast();
    AdaptiveCast(AdaptiveCast&&) noexcept;
    AdaptiveCast& operator=(AdaptiveCast&&) noexcept;

    const surface::Surface& surface() const;
    /// The next version of the model: rays and patches that no changed surfel is near stay. Under another definition
    /// nothing does.
    void setSurface(surface::Surface next);

    /// The picture at the asked quality. With `onLevel` it comes in levels, first the smooth inner parts, then quality
    /// 4, 2, 1 and so on, each with the rays of the one before; the last one is also returned. `counts` tells of this
    /// call alone. Throws base::Cancelled within some 10 ms; rays that were cast until then are kept.
    AdaptiveImage cast(const ImageRays& rays, const AdaptiveOptions& options, CastCounts& counts,
                       const OnLevel& onLevel = {}, const base::Progress& progress = {});

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace raycast
