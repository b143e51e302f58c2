#include "core/solid/slivers.h"

#include "core/base/cells.h"
#include "core/cells/labels.h"
#include "core/surface/definition.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <cmath>

namespace solid {

using base::Vec3d;

namespace {

constexpr double beside = 1.5;              ///< spacings along a seam within which a face that goes on has feet
constexpr double apart = 0.8;               ///< spacings between places
constexpr double aside[] = {0.4, 0.2, 0.1}; ///< spacings from the seam, the widest that the face has room for
constexpr double facing = 0.9;              ///< cosine between normals of one face
constexpr double steepest = 0.1;            ///< sine of the angle at the seam below which no edge is seen

/// Places on the seam by cell.
class Places {
  public:
    explicit Places(double width) : m_width(width) {}

    void add(const Vec3d& place, std::uint32_t cell) { m_cells.at(at(place)).push_back({place, cell}); }
    /// `reach`: at most the width.
    bool has(const Vec3d& place, std::uint32_t cell, double reach) const {
        bool found = false;
        base::forCellsAround(at(place), [&](const base::Cell& around) {
            if (const std::vector<Known>* there = m_cells.find(around))
                for (const Known& each : *there)
                    found = found || (each.cell == cell && distance(each.place, place) < reach);
        });
        return found;
    }

  private:
    struct Known {
        Vec3d place;
        std::uint32_t cell;
    };
    base::Cell at(const Vec3d& place) const { return base::cellOf(place, Vec3d(), 1 / m_width); }

    double m_width;
    base::CellMap<std::vector<Known>> m_cells;
};

/// On the face with that normal, beside the seam, on the side that stays; nothing where the face has no room there.
bool placeBeside(const Side& side, const Side& other, bool inside, double spacing, const Vec3d& normal, Sliver& out) {
    const SideValue seam = other.at(out.position);
    const Vec3d gradient = inside ? -seam.gradient : seam.gradient, along = gradient - normal * dot(gradient, normal);
    if (!seam.near || !(length(along) > steepest * length(gradient)))
        return false;
    for (const double share : aside) {
        const double step = share * spacing;
        const Vec3d x = out.position + base::normalized(along) * step;
        const SideValue here = side.at(x);
        if (!here.near || !(dot(base::normalized(here.gradient), normal) > facing) || std::abs(here.value) > step / 2)
            continue;
        const Vec3d foot = x - here.gradient * (here.value / lengthSq(here.gradient));
        const SideValue beyond = other.at(foot);
        if ((inside ? -beyond.value : beyond.value) > steepest * step / 2 &&
            std::abs(side.at(foot).value) < step / 10) {
            out.position = foot;
            out.normal = base::normalized(here.gradient);
            return true;
        }
    }
    return false;
}

} // namespace

std::vector<Sliver> sliversOf(const tree::SurfelTree& tree, const Side& side, const Side& other, bool inside,
                              const SeamFeet& own, const SeamFeet& others) {
    std::vector<Sliver> out;
    const auto layout = cells::LabelLayout::of(*tree.layout());
    if (!layout)
        return out;
    const int shape = surfel::shapeChannel(*tree.layout());
    struct Asked {
        const SeamFoot* foot;
        tree::Neighbour nearest;
        double spacing;
    };
    std::vector<Asked> asked;
    std::vector<tree::Neighbour> near;
    double widest = 0;
    for (const std::vector<SeamFoot>& block : others)
        for (const SeamFoot& foot : block) {
            tree.nearest(base::cast<float>(foot.place), 1, near);
            const auto ball = static_cast<double>(surfel::ballOf(*near[0].block, near[0].slot, shape));
            asked.push_back({&foot, near[0], ball * surface::spacingOfUnit});
            widest = std::max({widest, asked.back().spacing, foot.spacing});
        }
    if (asked.empty())
        return out;
    Places known(beside * widest);
    for (const std::vector<SeamFoot>& block : own)
        for (const SeamFoot& foot : block)
            known.add(foot.place, foot.cell);
    for (const Asked& each : asked) {
        const std::uint32_t cell = layout->cellAt(*each.nearest.block, each.nearest.slot);
        if (known.has(each.foot->place, cell, beside * std::max(each.spacing, each.foot->spacing)))
            continue;
        const Vec3d normal = base::normalized(base::cast<double>(each.nearest.block->normal(each.nearest.slot)));
        Sliver sliver{each.foot->place, normal, each.nearest, each.foot->cell};
        if (std::any_of(out.begin(), out.end(),
                        [&](const Sliver& o) { return distance(o.position, sliver.position) < apart * each.spacing; }))
            continue;
        if (placeBeside(side, other, inside, each.spacing, normal, sliver))
            out.push_back(sliver);
    }
    return out;
}

} // namespace solid
