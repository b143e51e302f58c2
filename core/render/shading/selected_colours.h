// What is selected, in orange over whatever a shading shows: a table of colours that renderers take in place of the
// shading's own (RenderOptions::colours).
//
//     materials          orange light
//     colours, numbers   mixed with orange, so that what is beneath is still told
#pragma once

#include "core/process/scalar_field.h"
#include "core/render/shading/block_colours.h"
#include "core/render/shading/shading_table.h"

namespace render {

/// A colour under a selection of 0 to 1.
surfel::Colour underSelection(surfel::Colour colour, float selected);

/// What the surfels' selection asks of a surface, as an attribute.
process::FieldQuestion selectionQuestion(const surface::Surface& surface);

struct SelectedColours {
    std::shared_ptr<const BlockColours> under; ///< the shading's own table; null where it has none
    std::shared_ptr<const BlockColours> shown; ///< `under` where nothing is selected
};
/// `before`: what this gave an earlier version in the same shading; colours of blocks that did not change are shared.
SelectedColours showSelected(const tree::SurfelTree& version, Shading shading,
                             std::shared_ptr<const BlockColours> under, const SelectedColours* before);

} // namespace render
