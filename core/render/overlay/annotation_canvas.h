// Draws annotations onto an image: no fonts, no display, the same bits on every machine.
#pragma once

#include "core/render/overlay/annotations.h"
#include "core/render/renderer.h"

namespace render {

/// Antialiased, letters and lines with a soft edge of the opposite lightness, so that they read on anything.
void paint(const Drawing& drawing, Image& out);

} // namespace render
