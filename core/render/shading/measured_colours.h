// From measured numbers to colours beside the blocks:
//
//     field = process::evaluateField(question, &before)     numbers per block, shared where nothing changed
//     scale = scaleFor(row, question, range, &field)        what they span
//     colours = coloursOf(field, scale, before, &old)       a table that renderers take (RenderOptions::colours)
#pragma once

#include "core/render/shading/block_colours.h"
#include "core/render/shading/shading_table.h"

namespace render {

struct Measured {
    process::FieldQuestion question;
    ColourScale scale;
    /// Of a selection (selected_colours.h): no scale, but orange over the surfels' own colours, or over white.
    enum class Over { Nothing, Own, White } over = Over::Nothing;
};

/// The range where one is given, else the automatic one: of the field's numbers or, without a field, of some
/// measured here. Throws base::Error for an empty range, base::Cancelled.
ColourScale scaleFor(const MeasureRow& row, const process::FieldQuestion& question,
                     const std::optional<std::pair<float, float>>& range, const process::ScalarField* field = nullptr,
                     const base::Progress& progress = {});

/// Colours of numbers that were coloured before on the same scale are shared with that table.
struct Coloured {
    process::ScalarField field;
    ColourScale scale;
    std::shared_ptr<const BlockColours> colours;
};
std::shared_ptr<const BlockColours> coloursOf(const process::ScalarField& field, const ColourScale& scale,
                                              const Coloured* before = nullptr);

} // namespace render
