#include "core/reduce/refine_cells.h"

#include "core/base/parallel.h"
#include "core/cells/crease_labels.h"
#include "core/cells/feet.h"
#include "core/cells/local_boolean.h"

namespace reduce {

using base::Vec3d;

namespace {

constexpr std::size_t grain = 256;
/// Of h: what the float feet of a cell are beyond another one where they are on both.
constexpr double loose = 1e-5, looseOnSeam = 1e-3;

struct SeamFoot {
    double distance = 0;
    std::uint32_t cell = 0;
    cells::Meeting meeting = cells::Meeting::None;
    bool real = false; ///< both cells have it as surface; else it is beyond the seam's end
};

bool isSeam(cells::CellSource& source, std::uint32_t a, std::uint32_t b, const Vec3d& x) {
    source.moveTo(x);
    for (const std::uint32_t cell : {a, b}) {
        const std::size_t i = source.find(cell);
        if (i == cells::CellSource::none ||
            !isFace(source, i, looseOnSeam * source.at(i, surface::Need::Gradient).unit))
            return false;
    }
    return true;
}

/// The nearest seam of the cell within reach.
std::optional<SeamFoot> nearestSeam(cells::CellSource& source, std::uint32_t cell, const Vec3d& x, double reach) {
    source.moveTo(x);
    const std::size_t own = source.find(cell);
    if (own == cells::CellSource::none || source.alone())
        return std::nullopt;
    std::vector<SeamFoot> met;
    for (std::size_t j = 0; j < source.count(); ++j)
        if (const cells::Meeting how = j == own ? cells::Meeting::None : source.meeting(own, j);
            how != cells::Meeting::None)
            met.push_back({0, source.cell(j), how, false});
    std::optional<SeamFoot> best;
    for (SeamFoot& each : met) {
        cells::Feet feet(source, x, {});
        const auto foot = feet.seam(cell, each.cell, x);
        if (!foot || !((each.distance = base::distance(*foot, x)) < reach))
            continue;
        each.real = isSeam(source, cell, each.cell, *foot);
        if (!best || each.real > best->real || (each.real == best->real && each.distance < best->distance))
            best = each;
    }
    return best;
}

} // namespace

void keepOnFace(const cells::CellSurface& surface, std::uint32_t cell, Places& places) {
    std::vector<std::uint8_t> kept(places.size());
    base::parallelChunks(places.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        cells::CellSource source(surface);
        for (std::size_t k = begin; k < end; ++k) {
            source.moveTo(base::cast<double>(places.position[k]));
            const std::size_t i = source.find(cell);
            kept[k] =
                i != cells::CellSource::none && isFace(source, i, loose * source.at(i, surface::Need::Gradient).unit);
        }
    });
    std::size_t out = 0;
    for (std::size_t k = 0; k < places.size(); ++k)
        if (kept[k]) {
            places.position[out] = places.position[k], places.normal[out] = places.normal[k];
            places.area[out++] = places.area[k];
        }
    places.position.resize(out), places.normal.resize(out), places.area.resize(out);
}

void labelBySeams(const cells::CellSurface& surface, float spacing, surfel::SurfelList& surfels) {
    const cells::LabelLayout layout = *cells::LabelLayout::of(*surfels.layout);
    std::vector<cells::Label> labels(surfels.size());
    base::parallelChunks(surfels.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        cells::CellSource source(surface);
        for (std::size_t k = begin; k < end; ++k) {
            cells::Label& label = labels[k];
            label = layout.at(surfels.extraOf(k));
            const auto seam = nearestSeam(source, label.cell, base::cast<double>(surfels.items[k].position),
                                          cells::partnerReach * static_cast<double>(spacing));
            label.partner = seam ? seam->cell : label.cell;
            label.meeting = seam ? seam->meeting : cells::Meeting::None;
        }
    });
    cells::setLabels(surfels, labels);
}

} // namespace reduce
