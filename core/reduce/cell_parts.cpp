#include "core/reduce/cell_parts.h"

#include "core/cells/labels.h"
#include "core/reduce/coverage.h"
#include "core/reduce/numbered_tree.h"
#include "core/surfel/shape.h"
#include "core/surfel/widen.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace reduce {

namespace {

/// The spacing that a support stands for, of an ellipsoid that along its long axis.
float spacingOf(const surfel::Surfel& s) {
    return s.support * std::sqrt(std::numbers::pi_v<float> / supportsOver);
}

/// With shapes as the last words, balls where there were none.
surfel::SurfelList withShapes(const surfel::SurfelList& list) {
    surfel::SurfelList out = surfel::withoutShape(list);
    auto layout = std::make_shared<surfel::AttributeLayout>(*out.layout);
    surfel::addShape(*layout);
    surfel::widen(out, layout);
    const std::size_t words = layout->words(), first = surfel::shapeWord(*layout);
    const bool shaped = surfel::shapeChannel(*list.layout) > 0;
    for (std::size_t i = 0; i < list.size(); ++i)
        surfel::putShape(std::span(out.extra).subspan(i * words, words), first,
                         shaped ? surfel::shapeIn(list.extraOf(i), surfel::shapeWord(*list.layout)) : base::Vec3f{});
    return out;
}

surfel::SurfelList besideCreases(const Cell& cell) {
    const cells::LabelLayout from = *cells::LabelLayout::of(*cell.surfels.layout);
    surfel::SurfelList out;
    out.layout = cell.surfels.layout;
    for (std::size_t i = 0; i < cell.size(); ++i)
        if (from.at(cell.surfels.extraOf(i)).meeting != cells::Meeting::None)
            out.append(cell.surfels.items[i], cell.surfels.extraOf(i));
    return out;
}

/// Of each surfel that of the nearest one beside a crease, within two spacings.
std::vector<cells::Label> nearestLabels(const surfel::SurfelList& beside, const surfel::SurfelList& reduced) {
    const cells::LabelLayout from = *cells::LabelLayout::of(*beside.layout),
                             at = *cells::LabelLayout::of(*reduced.layout);
    const tree::SurfelTree creases = tree::SurfelTree::build(beside);
    std::vector<cells::Label> out(reduced.size());
    std::vector<tree::Neighbour> near;
    for (std::size_t i = 0; i < reduced.size(); ++i) {
        const surfel::Surfel& s = reduced.items[i];
        constexpr float reach = 2;
        out[i] = at.at(reduced.extraOf(i));
        creases.nearest(s.position, 1, near);
        if (std::sqrt(near.front().distanceSq) <= reach * spacingOf(s))
            out[i] = from.at(*near.front().block, near.front().slot);
        else
            out[i].partner = out[i].cell, out[i].meeting = cells::Meeting::None;
    }
    return out;
}

/// Strips narrower than the spacing have their ends beside other creases too: where none of the surfels around one
/// beside a crease has that cell as partner, the nearest of those takes it whose own is that of another one there.
void keepCreases(const surfel::SurfelList& beside, const surfel::SurfelList& reduced,
                 std::vector<cells::Label>& labels) {
    constexpr std::size_t around = 6;
    const cells::LabelLayout from = *cells::LabelLayout::of(*beside.layout);
    std::vector<base::Vec3f> position, normal;
    for (const surfel::Surfel& s : reduced.items)
        position.push_back(s.position), normal.push_back(s.normal);
    const NumberedTree tree(position, normal, {});
    std::vector<tree::Neighbour> near;
    for (std::size_t i = 0; i < beside.size(); ++i) {
        const cells::Label wanted = from.at(beside.extraOf(i));
        tree.tree().nearest(beside.items[i].position, around, near);
        const auto have = [&](std::uint32_t partner) {
            return std::count_if(near.begin(), near.end(), [&](const tree::Neighbour& n) {
                return labels[NumberedTree::number(n)].partner == partner;
            });
        };
        if (have(wanted.partner) > 0)
            continue;
        for (const tree::Neighbour& n : near) {
            cells::Label& label = labels[NumberedTree::number(n)];
            if (label.meeting != cells::Meeting::None && have(label.partner) < 2)
                continue;
            label = wanted;
            break;
        }
    }
}

} // namespace

std::vector<Cell> cellsOf(const surface::Surface& model) {
    const surfel::SurfelList all = model.tree().surfels();
    const cells::LabelLayout labels = *cells::LabelLayout::of(*all.layout);
    std::map<std::uint32_t, Cell> byLabel;
    std::map<std::uint32_t, std::set<std::uint32_t>> partners;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const cells::Label label = labels.at(all.extraOf(i));
        Cell& cell = byLabel[label.cell];
        cell.surfels.layout = all.layout;
        cell.surfels.append(all.items[i], all.extraOf(i));
        if (label.partner != label.cell)
            partners[label.cell].insert(label.partner);
    }
    std::vector<Cell> out;
    for (auto& [label, cell] : byLabel) {
        cell.label = label;
        cell.partners = partners[label].size();
        out.push_back(std::move(cell));
    }
    return out;
}

surface::Surface surfaceOf(const surface::Surface& model, const Cell& cell) {
    surface::SurfaceDefinition definition = model.definition();
    definition.boundaryLimit = std::numeric_limits<float>::infinity();
    return {tree::SurfelTree::build(cell.surfels), definition};
}

void label(const Cell& cell, surfel::SurfelList& reduced) {
    const surfel::SurfelList beside = besideCreases(cell);
    if (beside.items.empty() || reduced.items.empty())
        return;
    std::vector<cells::Label> labels = nearestLabels(beside, reduced);
    keepCreases(beside, reduced, labels);
    cells::setLabels(reduced, labels);
}

surfel::SurfelList thinned(const Cell& cell, std::size_t count) {
    const surfel::SurfelList all = tree::SurfelTree::build(cell.surfels).surfels();
    const auto wider = static_cast<float>(std::sqrt(double(all.size()) / double(count)));
    surfel::SurfelList out;
    out.layout = all.layout;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = k * all.size() / count;
        surfel::Surfel s = all.items[i];
        s.support *= wider;
        out.append(s, all.extraOf(i));
    }
    label(cell, out);
    return out;
}

surfel::SurfelList joined(std::vector<surfel::SurfelList> lists) {
    const bool shaped = std::any_of(lists.begin(), lists.end(),
                                    [](const auto& list) { return surfel::shapeChannel(*list.layout) > 0; });
    surfel::SurfelList out;
    for (surfel::SurfelList& list : lists) {
        if (shaped)
            list = withShapes(list);
        out.layout = list.layout;
        out.items.insert(out.items.end(), list.items.begin(), list.items.end());
        out.extra.insert(out.extra.end(), list.extra.begin(), list.extra.end());
    }
    return out;
}

} // namespace reduce
