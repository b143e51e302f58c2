// What stands behind a model: one table of backgrounds, each a gradient from the top of the image to its bottom.
#pragma once

#include "core/surfel/surfel.h"

#include <span>
#include <string_view>

namespace render {

/// In the order of the table.
enum class Backdrop { Studio, Plain, Dark, White, Paper };

struct BackdropRow {
    Backdrop backdrop;
    const char* id; ///< "studio"
    const char* label;
    const char* tip;
    base::Vec3f top, bottom; ///< sRGB, 0 to 1
    base::Vec3f ink;         ///< of letters, the scale bar and lines of the grid before it, sRGB
};
std::span<const BackdropRow> backdropTable();
const BackdropRow& backdropRow(Backdrop backdrop);
/// Throws base::Error naming the known ones.
Backdrop backdrop(std::string_view id);

/// At height 0 (top) to 1 (bottom) of the image.
surfel::Colour background(Backdrop backdrop, float height);
/// One row of pixels: 8 that repeat along x, dithered so that gradients show no bands. `transparent` gives alpha 0.
void backgroundRow(Backdrop backdrop, int row, int height, bool transparent, surfel::Colour out[8]);

} // namespace render
