// Surfels to grow trees from, and plain-vector counterparts of what a tree must hold. Every surfel carries its number
// in one further attribute, so that contents compare one by one even where surfels are alike.
#pragma once

#include "core/base/random.h"
#include "core/tree/surfel_tree.h"

#include <algorithm>
#include <map>

namespace test {

inline surfel::AttributeLayoutPtr numberedLayout() {
    static const surfel::AttributeLayoutPtr layout = [] {
        auto made = std::make_shared<surfel::AttributeLayout>();
        made->normals = true;
        made->add("number", surfel::ScalarType::UInt32);
        return made;
    }();
    return layout;
}

/// A surfel at `p` with random other channels.
inline surfel::Surfel surfelAt(const base::Vec3d& p, double support, base::Random& random) {
    surfel::Surfel s;
    s.position = base::cast<float>(p);
    s.normal = base::cast<float>(random.unitVector());
    s.support = static_cast<float>(support * random.uniform(0.5, 1.5));
    s.colour = static_cast<surfel::Colour>(random.next());
    s.mask = static_cast<float>(random.uniform());
    return s;
}

/// Samples of a bumpy closed surface of about unit radius, with about 20 in support.
inline surfel::SurfelList bumpySphere(std::size_t count, base::Random& random) {
    surfel::SurfelList out;
    out.layout = numberedLayout();
    const double support = std::sqrt(20.0 * 4.0 / static_cast<double>(std::max<std::size_t>(count, 100)));
    for (std::size_t i = 0; i < count; ++i) {
        const base::Vec3d u = random.unitVector();
        const double r = 1 + 0.1 * std::sin(5 * u.x) * std::sin(4 * u.y + u.z);
        const auto number = static_cast<std::uint32_t>(i);
        out.append(surfelAt(u * r, support, random), {&number, 1});
    }
    return out;
}

/// What a tree should hold, by number.
using Content = std::map<std::uint32_t, surfel::Surfel>;

inline Content contentOf(const surfel::SurfelList& list) {
    Content out;
    for (std::size_t i = 0; i < list.size(); ++i)
        out[list.extraOf(i)[0]] = list.items[i];
    return out;
}

/// The content of a tree; a number that stands twice is an error and empties the answer.
inline Content contentOf(const tree::SurfelTree& tree) {
    const surfel::SurfelList list = tree.surfels();
    Content out = contentOf(list);
    return out.size() == list.size() && list.size() == tree.size() ? out : Content{};
}

inline std::uint32_t numberOf(const surfel::SurfelBlock& block, int slot) {
    std::uint32_t number = 0;
    block.extra(slot, {&number, 1});
    return number;
}

inline std::vector<surfel::BlockPtr> blocksOf(const tree::SurfelTree& tree) {
    std::vector<surfel::BlockPtr> out;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) { out.emplace_back(&block); });
    return out;
}

/// Same blocks in the same order with the same surfels in the same slots, below nodes of the same shape.
inline bool sameStructure(const tree::Node& a, const tree::Node& b) {
    if (a.level != b.level || a.childCount != b.childCount || a.surfelCount != b.surfelCount)
        return false;
    for (std::size_t i = 0; i < a.childCount; ++i) {
        if (a.level > 1) {
            if (!sameStructure(*a.nodes[i], *b.nodes[i]))
                return false;
            continue;
        }
        if (a.blocks[i]->size() != b.blocks[i]->size())
            return false;
        for (int slot = 0; slot < a.blocks[i]->size(); ++slot)
            if (!(a.blocks[i]->surfel(slot) == b.blocks[i]->surfel(slot)) ||
                numberOf(*a.blocks[i], slot) != numberOf(*b.blocks[i], slot))
                return false;
    }
    return true;
}

inline bool sameStructure(const tree::SurfelTree& a, const tree::SurfelTree& b) {
    return a.empty() || b.empty() ? a.empty() == b.empty() : sameStructure(*a.root(), *b.root());
}

} // namespace test
