#include "core/reduce/numbered_tree.h"

#include "core/base/parallel.h"

namespace reduce {

NumberedTree::NumberedTree(std::span<const base::Vec3f> position, std::span<const base::Vec3f> normal,
                           std::span<const float> support, std::span<const base::Vec3f> shape) {
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = true;
    layout->add("number", surfel::ScalarType::UInt32);
    if (!shape.empty())
        surfel::addShape(*layout);
    m_shape = surfel::shapeChannel(*layout);
    const std::size_t words = layout->words();
    surfel::SurfelList list;
    list.layout = layout;
    list.items.resize(position.size());
    list.extra.resize(words * position.size());
    base::parallelFor(position.size(), 8192, [&](std::size_t i) {
        surfel::Surfel& s = list.items[i];
        s.position = position[i];
        s.normal = normal[i];
        s.support = support.empty() ? 1 : support[i];
        list.extra[words * i] = static_cast<std::uint32_t>(i);
        if (!shape.empty())
            surfel::putShape(std::span(list.extra).subspan(words * i, words), 1, shape[i]);
    });
    m_tree = tree::SurfelTree::build(list);
}

} // namespace reduce
