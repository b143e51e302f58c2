#include "core/cells/crease_labels.h"

#include "core/base/cells.h"
#include "core/base/parallel.h"
#include "core/base/segment.h"

#include <cassert>
#include <cmath>

namespace cells {

using base::Vec3d;

static double distanceSqTo(const CreasePiece& piece, const Vec3d& p) {
    return base::distanceSq(p, nearestOnSegment(piece.from, piece.to, p));
}

std::vector<Label> labelsByCreases(std::span<const surfel::Surfel> surfels, std::span<const std::uint32_t> cells,
                                   std::span<const CreasePiece> creases, double spacing) {
    assert(cells.size() == surfels.size());
    const double reach = partnerReach * spacing, side = reach + spacing; // of a grid: marks are a spacing apart at most
    base::CellMap<std::vector<std::uint32_t>> grid;
    for (std::uint32_t i = 0; i < creases.size(); ++i) {
        const CreasePiece& piece = creases[i];
        const auto marks = static_cast<std::size_t>(std::ceil(base::distance(piece.from, piece.to) / spacing)) + 1;
        for (std::size_t k = 0; k <= marks; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(marks);
            std::vector<std::uint32_t>& there =
                grid.at(base::cellOf(piece.from + (piece.to - piece.from) * share, Vec3d(), 1 / side));
            if (there.empty() || there.back() != i)
                there.push_back(i);
        }
    }
    std::vector<Label> out(surfels.size());
    base::parallelFor(surfels.size(), 512, [&](std::size_t i) {
        Label& label = out[i];
        label.cell = label.partner = label.face = cells[i];
        const Vec3d p = base::cast<double>(surfels[i].position);
        double least = reach * reach;
        std::uint32_t nearest = 0;
        bool found = false;
        base::forCellsAround(base::cellOf(p, Vec3d(), 1 / side), [&](const base::Cell& around) {
            const std::vector<std::uint32_t>* there = grid.find(around);
            if (!there)
                return;
            for (const std::uint32_t c : *there) {
                if (creases[c].left == creases[c].right ||
                    (creases[c].left != label.cell && creases[c].right != label.cell))
                    continue;
                const double distanceSq = distanceSqTo(creases[c], p);
                if (distanceSq < least || (found && distanceSq == least && c < nearest)) {
                    least = distanceSq;
                    nearest = c;
                    found = true;
                }
            }
        });
        if (!found)
            return;
        label.partner = creases[nearest].left == label.cell ? creases[nearest].right : creases[nearest].left;
        label.meeting = creases[nearest].meeting;
    });
    return out;
}

} // namespace cells
