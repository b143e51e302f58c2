#include "core/solid/link_creases.h"

#include "core/base/disjoint_sets.h"
#include "core/cells/creases/labelled_surface.h"
#include "core/cells/creases/link_bands.h"
#include "core/cells/creases/link_labels.h"

namespace solid {

using base::Vec3f;
using cells::Label;

namespace {

/// Cells and faces of their own for what no link leads between but over edges. Three faces that meet in a corner are on
/// no two sides.
void part(const cells::SurfelLinks& links, std::vector<Label>& labels) {
    base::DisjointSets pieces(links.size());
    for (std::uint32_t a = 0; a < links.size(); ++a)
        links.forLinks(a, [&](std::uint32_t b, cells::Cut cut) {
            if (cut == cells::Cut::None && labels[a].cell == labels[b].cell)
                pieces.join(a, b);
        });
    for (std::uint32_t i = 0; i < labels.size(); ++i)
        labels[i].cell = labels[i].partner = labels[i].face = pieces.find(i);
}

} // namespace

surface::Surface creasedWhere(const surface::Surface& surface,
                              const std::function<LeadsOver(const cells::SurfelLinks&)>& over, std::size_t& atEdge,
                              Sides sides) {
    surfel::SurfelList surfels = surface.tree().surfels();
    std::vector<Label> labels = cells::labelsOf(surface.tree());
    cells::SurfelLinks links(surface.tree(), surfels.items);
    std::vector<Vec3f> normals;
    for (const surfel::Surfel& each : surfels.items)
        normals.push_back(each.normal);
    links.cutWalls(normals);
    const LeadsOver leads = over(links);
    bool any = false;
    for (std::uint32_t a = 0; a < links.size(); ++a)
        for (std::uint32_t e = links.begin(a); e < links.end(a); ++e)
            if (links.link(e).other > a && leads(a, e)) {
                links.cut(e, cells::Cut::Crease);
                any = true;
            }
    if (!any)
        return surface;
    if (sides == Sides::Pieces)
        part(links, labels);
    std::vector<std::uint32_t> before, faces;
    for (const Label& label : labels) {
        before.push_back(label.cell);
        faces.push_back(label.face);
    }
    const std::vector<std::uint32_t> split = cells::splitAtCreases(links, before);
    cells::moveToCells(links, split, labels);
    const std::vector<Label> moved = labels;
    cells::labelByLinks(links, split, faces, normals, 1, labels);
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] != moved[i] && labels[i].meeting != cells::Meeting::None) {
            labels[i].sharpness = 255; // also where few links lead over it: it ends nowhere
            ++atEdge;
        }
    return cells::labelled(surface, std::move(surfels), labels);
}

} // namespace solid
