#include "core/reduce/numbered_tree.h"

#include "core/base/parallel.h"

namespace reduce {

NumberedTree::NumberedTree(std::span<const base::Vec3f> position, std::span<const base::Vec3f> normal,
                           std::span<const float> support) {
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = true;
    layout->add("number", surfel::ScalarType::UInt32);
    surfel::SurfelList list;
    list.layout = layout;
    list.items.resize(position.size());
    list.extra.resize(position.size());
    base::parallelFor(position.size(), 8192, [&](std::size_t i) {
        surfel::Surfel& s = list.items[i];
        s.position = position[i];
        s.normal = normal[i];
        s.support = support.empty() ? 1 : support[i];
        list.extra[i] = static_cast<std::uint32_t>(i);
    });
    m_tree = tree::SurfelTree::build(list);
}

} // namespace reduce
