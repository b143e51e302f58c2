#include "core/solid/seam_labels.h"

#include "core/base/disjoint_sets.h"
#include "core/cells/creases/labelled_surface.h"
#include "core/tree/with_surfels.h"

#include <algorithm>

namespace solid {

using base::Vec3d;
using cells::Label;

tree::SurfelTree labelled(const tree::SurfelTree& tree, const tree::SurfelTree& other) {
    cells::requireNames(*tree.layout());
    const bool others = !other.empty() && cells::LabelLayout::of(*other.layout());
    const auto lacks = [&](const char* name) { return other.layout()->find(name) && !tree.layout()->find(name); };
    const bool whole = others && (lacks("sharpness") || lacks("face"));
    if (cells::LabelLayout::of(*tree.layout()) && !whole)
        return tree;
    surfel::SurfelList list = tree.surfels();
    cells::setLabels(list, cells::labelsOf(tree), whole);
    return tree::withSurfels(tree, list);
}

std::uint32_t firstFree(const tree::SurfelTree& tree) {
    std::uint32_t most = 0;
    if (const auto layout = cells::LabelLayout::of(*tree.layout()))
        tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot) {
                const Label label = layout->at(block, slot);
                most = std::max({most, label.cell, label.face});
            }
        });
    return most + 1;
}

Label nearestLabel(const tree::SurfelTree& tree, const Vec3d& x) {
    const std::optional<cells::LabelLayout> layout = cells::LabelLayout::of(*tree.layout());
    std::vector<tree::Neighbour> near;
    if (layout)
        tree.nearest(base::cast<float>(x), 1, near);
    return near.empty() ? Label{} : layout->at(*near[0].block, near[0].slot);
}

void writeLabel(const surfel::AttributeLayout& layout, const Label& label, std::span<std::uint32_t> words) {
    const std::pair<const char*, double> values[] = {{"cell", label.cell},
                                                     {"partner", label.partner},
                                                     {"sign", static_cast<int>(label.meeting)},
                                                     {"sharpness", label.sharpness},
                                                     {"face", label.face}};
    for (const auto& [name, value] : values)
        if (const surfel::Attribute* attribute = layout.find(name))
            surfel::write(*attribute, words, value);
}

Label besideSeam(Label label, std::uint32_t across, cells::Meeting meeting) {
    label.partner = across;
    label.meeting = meeting;
    label.sharpness = 255;
    return label;
}

void RelabelledBlock::put(int slot, const Label& label) {
    if (!m_copy)
        m_copy = m_block.clone();
    std::vector<std::uint32_t> words(m_block.extraWords());
    m_block.extra(slot, words);
    writeLabel(m_layout, label, words);
    m_copy->setExtra(slot, words);
    ++m_count;
}

std::size_t RelabelledBlock::giveTo(tree::BlockEdit& edit) {
    if (m_copy) {
        m_copy->seal();
        edit.changed = m_copy;
    }
    return m_count;
}

Translation::Translation(const surfel::AttributeLayout& from, const surfel::AttributeLayout& to)
    : m_words(to.words(), 0) {
    for (const surfel::Attribute& target : to.attributes()) {
        const surfel::Attribute* source = from.find(target.name);
        if (source && !target.name.starts_with("layer_")) // each model numbers its own layers (layers/README 1)
            m_pairs.push_back({*source, target});
    }
}

std::span<std::uint32_t> Translation::operator()(std::span<const std::uint32_t> words) {
    for (const auto& [source, target] : m_pairs)
        surfel::write(target, m_words, surfel::read(source, words));
    return m_words;
}

JoinedFaces::JoinedFaces(const tree::SurfelTree& model, const tree::SurfelTree& operand, std::uint32_t offset,
                         std::uint32_t next, const std::vector<FilletPlace>& contacts) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    std::vector<std::uint32_t> faces;
    for (const FilletPlace& each : contacts) {
        pairs.emplace_back(nearestLabel(model, each.onModel).face, nearestLabel(operand, each.onOperand).face + offset);
        faces.push_back(pairs.back().first);
        faces.push_back(pairs.back().second);
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    const auto number = [&](std::uint32_t face) {
        return static_cast<std::uint32_t>(std::lower_bound(faces.begin(), faces.end(), face) - faces.begin());
    };
    base::DisjointSets sets(faces.size());
    for (const auto& [a, b] : pairs)
        sets.join(number(a), number(b));
    for (const std::uint32_t face : faces)
        m_joined.emplace_back(face, next + sets.find(number(face)));
}

std::uint32_t JoinedFaces::of(std::uint32_t face) const {
    const auto found = std::lower_bound(m_joined.begin(), m_joined.end(), std::pair{face, std::uint32_t(0)});
    return found != m_joined.end() && found->first == face ? found->second : face;
}

tree::SurfelTree JoinedFaces::in(const tree::SurfelTree& model) const {
    surfel::SurfelList list = model.surfels();
    std::vector<Label> labels = cells::labelsOf(model);
    for (Label& label : labels)
        label.face = of(label.face);
    cells::setLabels(list, labels);
    return tree::withSurfels(model, list); // sides are known by the order of the tree
}

} // namespace solid
