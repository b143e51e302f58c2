#include "core/complexes/complex.h"

#include "core/base/error.h"
#include "core/surface/points_by_cell.h"

#include <algorithm>
#include <string>

namespace complexes {

using base::Vec3d;

namespace {

/// The points of each cell in lists of their own.
std::vector<surfel::SurfelList> byCell(const surface::Surface& surface, std::size_t cells) {
    const surfel::SurfelList all = surface.tree().surfels();
    std::vector<surfel::SurfelList> out;
    for (const std::vector<std::uint32_t>& numbers : surface::pointsByCell(all, cells)) {
        out.emplace_back().layout = all.layout;
        for (const std::uint32_t i : numbers)
            out.back().append(all.items[i], all.extraOf(i));
    }
    return out;
}

void takePoints(Cell& cell, const surfel::SurfelList& points, const surface::SurfaceDefinition& definition) {
    for (const surfel::Surfel& each : points.items) {
        const Vec3d p = base::cast<double>(each.position);
        cell.centre += p / static_cast<double>(points.size());
        const double h = static_cast<double>(each.support);
        cell.bounds.extend(p - Vec3d{h, h, h});
        cell.bounds.extend(p + Vec3d{h, h, h});
    }
    cell.oriented = points.size() > 0 && points.layout->normals && points.layout->oriented && cell.dimension == 2 &&
                    std::none_of(points.items.begin(), points.items.end(),
                                 [](const surfel::Surfel& s) { return s.normal == base::Vec3f{}; });
    surface::SurfaceDefinition own = definition;
    own.connectivity = nullptr;
    own.manifold = cell.dimension == 2 ? surface::Manifold::Surface : surface::Manifold::Curve;
    own.boundary = surface::Boundary::None;
    own.boundaryLimit = std::numeric_limits<float>::infinity();
    cell.own = {tree::SurfelTree::build(points), own};
}

/// What a cell knows of those that bound it.
void takeBoundary(Cell& cell, const std::vector<Cell>& cells) {
    std::sort(cell.boundary.begin(), cell.boundary.end());
    cell.boundary.erase(std::unique(cell.boundary.begin(), cell.boundary.end()), cell.boundary.end());
    Vec3d sum;
    for (const std::uint32_t b : cell.boundary) {
        cell.bounds.extend(cells[b].bounds);
        sum += cells[b].centre / static_cast<double>(cell.boundary.size());
        if (cell.dimension == 2)
            cell.sharedEnds.insert(cell.sharedEnds.end(), cells[b].boundary.begin(), cells[b].boundary.end());
    }
    std::sort(cell.sharedEnds.begin(), cell.sharedEnds.end());
    cell.sharedEnds.erase(std::unique(cell.sharedEnds.begin(), cell.sharedEnds.end()), cell.sharedEnds.end());
    if (cell.own.tree().empty())
        cell.centre = sum;
}

} // namespace

std::optional<Complex> Complex::of(const surface::Surface& surface) {
    const surface::SurfaceDefinition& definition = surface.definition();
    if (definition.manifold != surface::Manifold::Complex)
        return std::nullopt;
    if (!definition.connectivity || definition.connectivity->cells.empty())
        throw base::Error("the model does not tell how its cells hang together", {},
                          "open a file with an element complex_cell, or choose another manifold");
    requireSound(*definition.connectivity);
    const std::vector<surface::ComplexCell>& given = definition.connectivity->cells;
    const std::vector<surfel::SurfelList> points = byCell(surface, given.size());
    auto cells = std::make_shared<std::vector<Cell>>(given.size());
    for (int dimension = 0; dimension <= 2; ++dimension)
        for (std::size_t i = 0; i < given.size(); ++i) {
            if (given[i].dimension != dimension)
                continue;
            Cell& cell = (*cells)[i];
            cell.dimension = dimension;
            cell.boundary = given[i].boundary;
            if (dimension == 0 ? points[i].size() != 1 : dimension == 1 && points[i].size() == 0)
                throw base::Error("cell " + std::to_string(i) + " of the complex, a " +
                                      (dimension == 0 ? "point" : "curve") + ", has " +
                                      std::to_string(points[i].size()) + " samples",
                                  {}, dimension == 0 ? "give it one" : "give it some");
            takePoints(cell, points[i], definition);
            takeBoundary(cell, *cells);
            if (cell.own.tree().empty() && cell.boundary.empty())
                throw base::Error("cell " + std::to_string(i) + " of the complex has neither samples nor a boundary",
                                  {}, "give it some");
        }
    for (const surface::ComplexCell& cell : given)
        for (const std::uint32_t b : cell.boundary)
            (*cells)[b].bounding = true;
    for (std::size_t k = 0; k < definition.connectivity->tangents.size(); ++k)
        for (const std::uint32_t cell : definition.connectivity->tangents[k].cells)
            (*cells)[cell].tangents.push_back(static_cast<std::uint32_t>(k));
    Complex out;
    out.m_surface = surface;
    out.m_cells = std::move(cells);
    return out;
}

double Complex::reach(std::uint32_t point) const {
    const float support = (*m_cells)[point].own.tree().maxSupport(); // of its one sample
    return reachOfUnit * static_cast<double>(surface::unitOf(weight(), support));
}

} // namespace complexes
