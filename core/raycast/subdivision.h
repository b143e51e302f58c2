// Which cells of a view are split, and what the splits ask for: predict, cast, verify (raycast/README 2).
//
// A cell is [column, column + size) x [row, row + size), between samples at its four corners. Its split adds the five
// samples of patch.h and makes four cells of half the size; each of them is shown by interpolation, is missed by the
// surface, or is split in turn. Cells of one pixel are that pixel's sample. Whether a cell is split depends on its nine
// samples, the guard and the quality alone: what a coarser quality asks for a finer one does too.
#pragma once

#include "core/raycast/lattice.h"
#include "core/raycast/patch.h"
#include "core/raycast/splat_guard.h"

namespace raycast {

/// What the subdivision of a view works on; all outlive it.
struct CastView {
    const cells::AnySurface& surface;
    const ImageRays& rays;
    const ViewLens& lens;
    const SplatGuard& guard;
    Lattice& lattice;
    const Sample* picture; ///< with the samples that the lattice calls redrawn
    PatchKind kind;
    int startCell = 0; ///< pixels, a power of two, 4 to 32

    /// Cast or redrawn; null for none.
    const Sample* sampleAt(Pixel p) const;
    Knot knotAt(Pixel p) const;
    bool inImage(Pixel p) const { return p.column < rays.width && p.row < rays.height; }
};

/// A cell that was split, of twice `half`. Bits of children: 1 upper left, 2 upper right, 4 and 8 below.
struct Split {
    Pixel at;
    int half = 0;
    float error = 0;         ///< predictionError of its nine samples
    unsigned char shown = 0; ///< interpolated between them
    unsigned char missed = 0;
    unsigned char open = 0; ///< would have to be split

    Pixel child(int i) const { return {at.column + (i & 1 ? half : 0), at.row + (i & 2 ? half : 0)}; }
    /// Every child, by what it is.
    template <class Fn>
    void forChildren(unsigned char which, const Fn& fn) const {
        for (int i = 0; i < 4; ++i)
            if (which >> i & 1)
                fn(child(i));
    }
    Patch patch(const CastView& view) const;
};

struct SubdivisionOptions {
    double quality = 1;
    bool onlyFirst = false; ///< every start cell is split once, and no more
};

/// The leaves of the view by the cells that they were split from; every pixel of the image is in one child of one
/// split, or in a cell that was redrawn as a whole, which is no part of any. Casts what the lattice lacks and counts
/// it. Throws base::Cancelled between batches of rays that take some milliseconds; those cast are in the lattice.
std::vector<Split> subdivide(const CastView& view, const SubdivisionOptions& options, CastCounts& counts,
                             const base::Progress& progress);

/// The side of start cells for a spacing in pixels: the largest power of two up to 3.35 of it, 4 to 32. Larger ones
/// miss bumps between their samples, smaller ones only cost rays.
int startCellFor(double spacingPx);

} // namespace raycast
