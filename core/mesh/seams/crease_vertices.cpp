#include "core/mesh/seams/crease_vertices.h"

#include "core/base/parallel.h"
#include "core/cells/cell_value.h"
#include "core/cells/feet.h"
#include "core/cells/local_boolean.h"

namespace mesh {

using base::Vec3d, base::Vec3f;
using surface::Evaluationd;
using surface::Need;

namespace {

constexpr std::size_t grain = 256;
constexpr double farthest = 0.6;       ///< of h: of a vertex from its face
constexpr double settled = 1e-7;       ///< of h: steps after which none is needed
constexpr double loose = 3e-4;         ///< of h: how far a seam may be beyond what cuts it off
constexpr double leastSharpness = 0.3; ///< of a crease that is to be a chain of edges

/// Newton's method along the gradient of whichever cell is surface there.
void land(cells::CellSource& source, const Vec3d& start, CreaseVertex& out) {
    Vec3d x = start;
    for (int k = 0; k < 12; ++k) {
        const cells::CellValue here = cells::evaluate(source, x, Need::Gradient);
        if (here.cell == cells::noCell || !cells::valid(here.at) || !(lengthSq(here.at.gradient) > 1e-2))
            return;
        const Vec3d step = here.at.gradient * (-here.at.value / lengthSq(here.at.gradient));
        x += step;
        if (!(base::distance(x, start) < farthest * here.at.unit))
            return;
        if (length(step) > settled * here.at.unit && k < 11)
            continue;
        if (length(step) > loose * here.at.unit) // to and fro between two faces
            return;
        source.moveTo(x);
        const std::size_t i = source.find(here.cell);
        if (i == cells::CellSource::none || cutOff(source, i, loose * here.at.unit)) // f is zero, but nothing is there
            return;
        out.cells = {here.cell};
        out.own = here.cell;
        out.position = x;
        out.normal = base::cast<float>(base::normalized(here.at.gradient));
        return;
    }
}

} // namespace

std::vector<CreaseVertex> ontoFaces(const cells::CellSurface& surface, const Mesh& mesh) {
    std::vector<CreaseVertex> out(mesh.positions.size());
    base::parallelChunks(out.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        cells::CellSource source(surface);
        for (std::size_t v = begin; v < end; ++v) {
            out[v].position = mesh.positions[v];
            out[v].normal = mesh.normals[v];
            source.moveTo(mesh.positions[v]);
            out[v].mixed = source.count() > 1;
            if (source.count() == 1) {
                out[v].own = source.cell(0);
                out[v].cells = {out[v].own};
            } else if (out[v].mixed && movable(mesh, v)) {
                land(source, mesh.positions[v], out[v]);
            }
        }
    });
    return out;
}

bool CreaseFinder::meet(std::uint32_t a, std::uint32_t b) {
    const std::size_t i = m_source.find(a), j = m_source.find(b);
    return i != cells::CellSource::none && j != cells::CellSource::none &&
           m_source.meeting(i, j) != cells::Meeting::None && m_source.sharpness(i, j) > leastSharpness;
}

/// The place as it is where all its cells have it as surface.
std::optional<CreasePlace> CreaseFinder::accepted(const CellsAt& cells, const Vec3d& x) {
    m_source.moveTo(x);
    CreasePlace out{cells, x, {}};
    Vec3d normal;
    for (const std::uint32_t cell : cells) {
        const std::size_t i = m_source.find(cell);
        if (i == cells::CellSource::none)
            return std::nullopt;
        const Evaluationd& at = m_source.at(i, Need::Gradient);
        if (!cells::valid(at) || !(std::abs(at.value) < loose * at.unit) || cutOff(m_source, i, loose * at.unit))
            return std::nullopt;
        normal += base::normalized(at.gradient);
    }
    out.normal = base::cast<float>(base::normalized(normal));
    return out;
}

std::optional<CreasePlace> CreaseFinder::seam(std::uint32_t a, std::uint32_t b, const Vec3d& x, double reach) {
    m_source.moveTo(x);
    if (!meet(a, b))
        return std::nullopt;
    cells::Feet feet(m_source, x, {});
    const auto foot = feet.seam(a, b, x);
    if (!foot || !(base::distance(*foot, x) < reach))
        return std::nullopt;
    if (const auto place = accepted({a, b}, *foot))
        return place;
    // a third cell ends the seam before
    m_source.moveTo(*foot);
    std::optional<CreasePlace> best;
    std::vector<std::uint32_t> others;
    for (std::size_t k = 0; k < m_source.count(); ++k)
        if (m_source.cell(k) != a && m_source.cell(k) != b)
            others.push_back(m_source.cell(k));
    for (const std::uint32_t other : others) {
        m_source.moveTo(*foot);
        if (!meet(a, other) && !meet(b, other))
            continue;
        const auto place = corner({a, b, other}, *foot, reach);
        if (place && (!best || base::distance(place->position, x) < base::distance(best->position, x)))
            best = place;
    }
    return best;
}

std::optional<CreasePlace> CreaseFinder::corner(const CellsAt& cells, const Vec3d& x, double reach) {
    m_source.moveTo(x);
    cells::Feet feet(m_source, x, {});
    const auto foot = feet.corner({cells.begin(), cells.count()}, x);
    if (!foot || !(base::distance(*foot, x) < reach))
        return std::nullopt;
    return accepted(cells, *foot);
}

std::optional<CreasePlace> CreaseFinder::between(const CellsAt& a, const CellsAt& b, const Vec3d& x, double reach) {
    std::optional<CreasePlace> best;
    for (const std::uint32_t i : a)
        for (const std::uint32_t j : b) {
            const auto place = seam(i, j, x, reach);
            if (place && (!best || base::distance(place->position, x) < base::distance(best->position, x)))
                best = place;
        }
    return best;
}

} // namespace mesh
