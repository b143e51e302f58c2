#include "core/render/shading/measured_colours.h"

#include "core/base/parallel.h"

namespace render {

ColourScale scaleFor(const MeasureRow& row, const process::FieldQuestion& question,
                     const std::optional<std::pair<float, float>>& range, const process::ScalarField* field,
                     const base::Progress& progress) {
    const base::Box3f box = question.surface.tree().bounds();
    ColourScale out = range ? fixedScale(row, range->first, range->second)
                            : automaticScale(row, process::sampleField(question, field, progress),
                                             box.empty() ? 1.0f : box.diagonal());
    if (row.named())
        out.title = question.attribute;
    return out;
}

std::shared_ptr<const BlockColours> coloursOf(const process::ScalarField& field, const ColourScale& scale,
                                              const Coloured* before) {
    const tree::SurfelTree& version = field.question().surface.tree();
    const bool same = before && before->colours && before->scale == scale;
    std::vector<BlockColours::Colours> found(version.blockCount());
    std::vector<const surfel::SurfelBlock*> blocks(version.blockCount());
    version.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) { blocks[number] = &block; });
    base::parallelFor(blocks.size(), 64, [&](std::size_t i) {
        const process::ScalarField::Values values = field.of(blocks[i]);
        if (same && before->field.of(blocks[i]) == values)
            found[i] = before->colours->shared(blocks[i]);
        if (found[i] || !values)
            return;
        auto colours = std::make_shared<std::vector<surfel::Colour>>(surfel::blockCapacity, unknownColour);
        for (std::size_t k = 0; k < values->size(); ++k)
            (*colours)[k] = scale.of((*values)[k]);
        found[i] = std::move(colours);
    });
    auto out = std::make_shared<BlockColours>(version);
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (found[i])
            out->set(blocks[i], std::move(found[i]));
    return out;
}

} // namespace render
