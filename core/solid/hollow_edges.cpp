#include "core/solid/hollow_edges.h"

#include "core/base/parallel.h"
#include "core/cells/labels.h"
#include "core/solid/link_creases.h"
#include "core/solid/seam_labels.h"

#include <cmath>
#include <numbers>

namespace solid {

using base::Vec3d;
using cells::Label;

namespace {

/// One cell, as those above it say nothing of which edges it is near.
surface::Surface wallOfOneCell(const surface::Surface& model, const surfel::SurfelList& inner) {
    surfel::SurfelList out;
    out.layout = inner.layout;
    std::vector<std::uint32_t> words;
    for (std::size_t i = 0; i < inner.size(); ++i) {
        const auto had = inner.extraOf(i);
        words.assign(had.begin(), had.end());
        writeLabel(*out.layout, Label{}, words);
        out.append(inner.items[i], words);
    }
    return {tree::SurfelTree::build(out), model.definition()};
}

/// Across the wall along the normal: at an edge of the inner wall both faces are as near.
std::uint32_t faceAbove(const tree::SurfelTree& model, const surfel::Surfel& inner) {
    std::vector<tree::Neighbour> near;
    model.nearest(inner.position, 1, near);
    const Vec3d x = base::cast<double>(inner.position), n = base::normalized(base::cast<double>(inner.normal));
    return nearestLabel(model, x - n * std::sqrt(static_cast<double>(near[0].distanceSq))).face;
}

/// Sharp where it turns towards itself between places below two faces: below an edge inwards it goes round instead.
surface::Surface withEdges(const surface::Surface& model, const surface::Surface& wall) {
    const double leastTurn = std::cos(8 * std::numbers::pi / 180);
    constexpr double onEdge = 0.05; // spacings: surfels on the edge itself turn neither way
    std::size_t atEdge = 0;
    return creasedWhere(
        wall,
        [&](const cells::SurfelLinks& links) -> LeadsOver {
            std::vector<std::uint32_t> faces(links.size());
            base::parallelFor(faces.size(), 64, [&](std::size_t i) {
                faces[i] = faceAbove(model.tree(), links.surfel(static_cast<std::uint32_t>(i)));
            });
            return [faces = std::move(faces), &links, leastTurn](std::uint32_t a, std::uint32_t e) {
                const std::uint32_t b = links.link(e).other;
                const Vec3d na = base::cast<double>(links.surfel(a).normal),
                            nb = base::cast<double>(links.surfel(b).normal);
                const Vec3d turn = nb - na;
                return faces[a] != faces[b] && dot(na, nb) < leastTurn &&
                       dot(turn, links.at(b) - links.at(a)) < onEdge * links.spacing(a) * length(turn);
            };
        },
        atEdge, Sides::Pieces);
}

} // namespace

surface::Surface withInnerWall(const surface::Surface& model, surfel::SurfelList inner) {
    tree::Edit edit;
    if (!cells::LabelLayout::of(*model.tree().layout())) {
        edit.inserted = std::move(inner);
        return {model.tree().apply(edit), model.definition()};
    }
    const surface::Surface wall = withEdges(model, wallOfOneCell(model, inner));
    const tree::SurfelTree whole = labelled(model.tree(), wall.tree());
    const surfel::SurfelList all = wall.tree().surfels();
    const auto own = cells::LabelLayout::of(*all.layout);
    const std::uint32_t offset = firstFree(whole);
    Translation translation(*all.layout, *whole.layout());
    edit.inserted.layout = whole.layout();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::span<std::uint32_t> words = translation(all.extraOf(i));
        writeLabel(*whole.layout(), own->at(all.extraOf(i)).shifted(offset), words);
        edit.inserted.append(all.items[i], words);
    }
    return {whole.apply(edit), model.definition()};
}

} // namespace solid
