#include "ui/interaction/framing.h"

#include "core/render/framed_box.h"
#include "core/selection/field.h"

namespace ui {

std::vector<base::Box3f> boxesOf(const tree::SurfelTree& tree) {
    const base::Box3f shown = render::framedBox(tree);
    std::vector<base::Box3f> out;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        if (const base::Box3f box = block.box().cut(shown); !box.empty())
            out.push_back(box);
    });
    return out;
}

std::vector<base::Box3f> unmaskedBoxes(const tree::SurfelTree& tree) {
    if (!tree.layout()->masks)
        return {};
    std::vector<base::Box3f> out;
    bool masked = false;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        base::Box3f box;
        for (int slot = 0; slot < block.size(); ++slot) {
            if (block.mask(slot) < 0.5f)
                box.extend(block.position(slot));
            else
                masked = true;
        }
        if (!box.empty())
            out.push_back(box);
    });
    return masked ? out : std::vector<base::Box3f>{};
}

std::vector<base::Box3f> selectedBoxes(const tree::SurfelTree& tree) {
    const surfel::Attribute* attribute = tree.layout()->find(selection::attributeName(selection::Field::Selection));
    std::vector<base::Box3f> out;
    if (!attribute || attribute->type != surfel::ScalarType::Float32)
        return out;
    const int channel = surfel::Extra + static_cast<int>(attribute->firstWord);
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        base::Box3f box;
        for (int slot = 0; slot < block.size(); ++slot)
            if (selection::valueAt(block, channel, slot) >= selection::half)
                box.extend(block.position(slot));
        if (!box.empty())
            out.push_back(box);
    });
    return out;
}

base::Box3f boxAround(const base::Vec3d& centre, double radius) {
    const auto reach = static_cast<float>(radius);
    const base::Vec3f middle = base::cast<float>(centre), corner{reach, reach, reach};
    return {middle - corner, middle + corner};
}

} // namespace ui
