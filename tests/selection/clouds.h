// Models to choose from: random and uneven, and what is selected of them as a list.
#pragma once

#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "core/selection/field.h"
#include "process/even_shapes.h"

#include <set>

namespace test {

using base::Vec3d, base::Vec3f;

inline std::string seedText(std::uint64_t seed) {
    return "seed " + std::to_string(seed);
}

/// A ball of random points about `centre`, twenty times as fine around one end of x; normals are exact.
inline surface::Surface unevenBall(std::uint64_t seed, int count, double noise = 0, const Vec3d& centre = {}) {
    base::Random random(seed);
    surfel::SurfelList out;
    out.layout = orientedLayout();
    const auto add = [&](const Vec3d& u) {
        surfel::Surfel s;
        s.position = base::cast<float>(centre + u + random.unitVector() * noise * random.uniform());
        s.normal = base::cast<float>(u);
        s.colour = static_cast<surfel::Colour>(random.next());
        out.append(s, {});
    };
    for (int k = 0; k < count; ++k)
        add(random.unitVector());
    for (int k = 0; k < count; ++k)
        add(normalized(Vec3d{1, 0, 0} + random.unitVector() * (0.1 * std::sqrt(random.uniform()))));
    return process::prepare(out, {});
}

/// A surfel by its place in its version.
using Place = std::pair<std::uint32_t, int>;

inline std::set<Place> placesOf(const tree::Selection& selection) {
    std::set<Place> out;
    for (const tree::SelectedBlock& each : selection)
        for (std::size_t slot = 0; slot < each.slots.size(); ++slot)
            if (each.slots[slot])
                out.insert({each.block, static_cast<int>(slot)});
    return out;
}

/// fn(place, surfel) for all.
template <class Fn>
void forSurfels(const tree::SurfelTree& tree, const Fn& fn) {
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            fn(Place{number, slot}, block.surfel(slot));
    });
}

/// The surfels of which `holds(surfel)` is true, as a Selection.
template <class Holds>
tree::Selection those(const tree::SurfelTree& tree, const Holds& holds) {
    tree::Selection out;
    forSurfels(tree, [&](const Place& at, const surfel::Surfel& s) {
        if (!holds(s))
            return;
        if (out.empty() || out.back().block != at.first)
            out.push_back({at.first, {}});
        out.back().slots.set(static_cast<std::size_t>(at.second));
    });
    return out;
}

inline float selectionAt(const tree::SurfelTree& tree, const Place& at) {
    return selection::valueAt(*tree.block(at.first), selection::channelOf(*tree.layout(), selection::Field::Selection),
                              at.second);
}

/// The field of a version set to fn(surfel).
template <class Fn>
surface::Surface withField(const surface::Surface& surface, const Fn& fn) {
    return {selection::rewritten(surface.tree(), selection::Field::Selection,
                                 [&](std::uint32_t, const surfel::SurfelBlock& block, selection::BlockValues& values) {
                                     for (int slot = 0; slot < block.size(); ++slot)
                                         values[static_cast<std::size_t>(slot)] =
                                             static_cast<float>(fn(block.surfel(slot)));
                                 }),
            surface.definition()};
}

} // namespace test
