#include "core/selection/quantities.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/row_of_id.h"
#include "core/selection/field.h"
#include "core/surface/curvature.h"

#include <algorithm>
#include <numbers>

namespace selection {

using base::Vec3d;
using surfel::SurfelBlock;

namespace {

constexpr QuantityRow rows[] = {
    {"x", "place along x, in the file's coordinates"},
    {"y", "place along y"},
    {"z", "place along z"},
    {"normal-x", "of the unit normal"},
    {"normal-y", "of the unit normal"},
    {"normal-z", "of the unit normal"},
    {"support", "support radius, in model units"},
    {"mask", "0 free to 1 protected"},
    {"red", "0 to 255"},
    {"green", "0 to 255"},
    {"blue", "0 to 255"},
    {"alpha", "0 to 255"},
    {"hue", "degrees, 0 red, 120 green, 240 blue"},
    {"saturation", "0 to 1"},
    {"brightness", "0 to 1: the largest of red, green and blue"},
    {"curvature-most", "the greater principal curvature, in 1 / model units"},
    {"curvature-least", "the lesser principal curvature"},
    {"curvature-mean", "their mean"},
    {"curvature-gauss", "their product"},
};

using Values = std::array<double, surfel::blockCapacity>;
using Reader = std::function<void(const SurfelBlock&, Values&)>;

template <class Fn>
Reader eachSlot(const Fn& of) {
    return [of](const SurfelBlock& block, Values& out) {
        for (int slot = 0; slot < block.size(); ++slot)
            out[static_cast<std::size_t>(slot)] = of(block, slot);
    };
}

double byteOf(surfel::Colour colour, unsigned channel) {
    return static_cast<double>(colour >> (8 * channel) & 255u);
}

double colourPart(std::string_view id, surfel::Colour colour) {
    const double r = byteOf(colour, 0), g = byteOf(colour, 1), b = byteOf(colour, 2);
    const double most = std::max({r, g, b}), least = std::min({r, g, b}), span = most - least;
    if (id == "red" || id == "green" || id == "blue" || id == "alpha")
        return byteOf(colour, id == "red" ? 0 : id == "green" ? 1 : id == "blue" ? 2 : 3);
    if (id == "brightness")
        return most / 255;
    if (id == "saturation")
        return most > 0 ? span / most : 0;
    if (!(span > 0)) // grey has no hue
        return std::numeric_limits<double>::quiet_NaN();
    const double sixth = most == r ? (g - b) / span : most == g ? 2 + (b - r) / span : 4 + (r - g) / span;
    return 60 * (sixth < 0 ? sixth + 6 : sixth);
}

double curvaturePart(std::string_view id, const surface::Curvature& at) {
    if (!at.ok())
        return std::numeric_limits<double>::quiet_NaN();
    return id == "curvature-most"    ? at.k1
           : id == "curvature-least" ? at.k2
           : id == "curvature-mean"  ? at.mean()
                                     : at.gauss();
}

Reader curvatureReader(const surface::Surface& surface, const std::string& id) {
    return [&surface, id](const SurfelBlock& block, Values& out) {
        std::array<base::Vec3f, surfel::blockCapacity> x;
        std::array<surface::Curvature, surfel::blockCapacity> at;
        const auto n = static_cast<std::size_t>(block.size());
        for (std::size_t i = 0; i < n; ++i)
            x[i] = block.position(static_cast<int>(i));
        surface::curvature(surface, std::span(x).first(n), std::span(at).first(n));
        for (std::size_t i = 0; i < n; ++i)
            out[i] = curvaturePart(id, at[i]);
    };
}

Reader attributeReader(const surfel::Attribute& attribute, std::size_t words) {
    return eachSlot([attribute, words](const SurfelBlock& block, int slot) {
        std::vector<std::uint32_t> extra(words);
        block.extra(slot, extra);
        return surfel::read(attribute, extra);
    });
}

Reader readerOf(const surface::Surface& surface, const std::string& id, const Vec3d& origin) {
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    if (id.size() == 1 && id >= "x" && id <= "z") {
        const auto k = static_cast<std::size_t>(id[0] - 'x');
        return eachSlot([k, at = origin[k]](const SurfelBlock& block, int slot) {
            return static_cast<double>(block.position(slot)[k]) + at;
        });
    }
    if (id.starts_with("normal-")) {
        const auto k = static_cast<std::size_t>(id.back() - 'x');
        return eachSlot([k](const SurfelBlock& block, int slot) { return static_cast<double>(block.normal(slot)[k]); });
    }
    if (id == "support")
        return eachSlot([](const SurfelBlock& block, int slot) { return static_cast<double>(block.support(slot)); });
    if (id == "mask")
        return eachSlot([](const SurfelBlock& block, int slot) { return static_cast<double>(block.mask(slot)); });
    if (id.starts_with("curvature-"))
        return curvatureReader(surface, id);
    if (base::findRow(quantityTable(), id))
        return eachSlot([id](const SurfelBlock& block, int slot) { return colourPart(id, block.surfel(slot).colour); });
    return attributeReader(*layout.find(id), layout.words());
}

template <class Holds>
tree::Selection where(const tree::SurfelTree& tree, const Holds& holds) {
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    tree::Selection out(blocks.size());
    base::parallelFor(blocks.size(), 16, [&](std::size_t b) {
        out[b].block = static_cast<std::uint32_t>(b);
        holds(*blocks[b], out[b].slots);
    });
    std::erase_if(out, [](const tree::SelectedBlock& block) { return block.slots.none(); });
    return out;
}

} // namespace

std::span<const QuantityRow> quantityTable() {
    return rows;
}

tree::Selection inRange(const surface::Surface& surface, std::string_view quantity, double low, double high,
                        const Vec3d& origin, const base::Progress& progress) {
    const std::string id(quantity);
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    if (!base::findRow(quantityTable(), id) && !layout.find(id)) {
        std::string known = base::joinedIds(quantityTable());
        for (const surfel::Attribute& attribute : layout.attributes())
            known += ", " + attribute.name;
        throw base::Error("the model has nothing named \"" + id + "\"", {}, "choose one of " + known);
    }
    progress.step(0, "Looking at the surfels");
    const Reader reader = readerOf(surface, id, origin);
    return where(surface.tree(), [&](const SurfelBlock& block, auto& slots) {
        Values values;
        reader(block, values);
        for (std::size_t i = 0; i < static_cast<std::size_t>(block.size()); ++i)
            slots[i] = values[i] >= low && values[i] <= high;
    });
}

tree::Selection nearColour(const tree::SurfelTree& tree, surfel::Colour colour, double tolerance) {
    return where(tree, [&](const SurfelBlock& block, auto& slots) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const surfel::Colour other =
                block.words(slot / surfel::clusterSize, surfel::ColourWord)[slot % surfel::clusterSize];
            double sum = 0;
            for (unsigned c = 0; c < 3; ++c)
                sum += (byteOf(other, c) - byteOf(colour, c)) * (byteOf(other, c) - byteOf(colour, c));
            slots[static_cast<std::size_t>(slot)] = sum <= tolerance * tolerance;
        }
    });
}

tree::Selection facing(const tree::SurfelTree& tree, const Vec3d& direction, double angleRad) {
    const Vec3d d = normalized(direction);
    const double least = angleRad >= std::numbers::pi ? -2.0 : std::cos(angleRad);
    const bool oriented = tree.layout()->oriented;
    return where(tree, [&](const SurfelBlock& block, auto& slots) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const Vec3d n = base::cast<double>(block.normal(slot));
            const double cosine = oriented ? dot(n, d) : std::abs(dot(n, d));
            slots[static_cast<std::size_t>(slot)] = lengthSq(n) > 0 && cosine >= least;
        }
    });
}

} // namespace selection
