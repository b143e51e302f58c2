// What a model's splats show, the same for every renderer.
#pragma once

#include "core/render/renderer.h"
#include "core/render/splats/splat_kernels.h"
#include "core/surfel/shape.h"

namespace render {

inline SplatStyle splatStyle(const tree::SurfelTree& model, const RenderOptions& options) {
    const surfel::AttributeLayout& layout = *model.layout();
    SplatStyle style;
    style.radiusOfSupport = splatRadiusOfSupport * options.splatScale;
    style.oriented = layout.normals && layout.oriented;
    style.shape = surfel::shapeChannel(layout);
    const ShadingRow& row = shadingRow(options.shading);
    style.table = options.colours.get();
    style.coloured = row.usesColour() || style.table;
    style.colours = layout.masks || (layout.colours && row.surfelColours) || style.table;
    return style;
}

} // namespace render
