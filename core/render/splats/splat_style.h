// What a model's splats show, the same for every renderer.
#pragma once

#include "core/cells/labels.h"
#include "core/render/renderer.h"
#include "core/render/splats/splat_kernels.h"
#include "core/surfel/shape.h"

#include <cmath>

namespace render {

/// Nothing but outsides can be seen of a model that ends nowhere, from beyond its box. Only those with labels know for
/// sure which side is outside: their faces told, or solids that were put together.
inline bool showsNoBack(const tree::SurfelTree& model, const RenderOptions& options, const Camera& camera) {
    const base::Box3f box = model.bounds();
    return options.entire && options.definition.manifold == surface::Manifold::Surface &&
           !std::isfinite(options.definition.boundaryLimit) && cells::LabelLayout::of(*model.layout()) &&
           camera.clips.empty() && (camera.parallel() || !box.contains(base::cast<float>(camera.eye)));
}

inline SplatStyle splatStyle(const tree::SurfelTree& model, const RenderOptions& options, const Camera& camera) {
    const surfel::AttributeLayout& layout = *model.layout();
    SplatStyle style;
    style.radiusOfSupport = splatRadiusOfSupport * options.splatScale;
    style.oriented = layout.normals && layout.oriented;
    if (style.oriented && showsNoBack(model, options, camera))
        style.backsFarther = model.bounds().diagonal();
    style.shape = surfel::shapeChannel(layout);
    const ShadingRow& row = shadingRow(options.shading);
    style.table = options.colours.get();
    style.coloured = row.usesColour() || style.table;
    style.colours = layout.masks || (layout.colours && row.surfelColours) || style.table;
    return style;
}

} // namespace render
