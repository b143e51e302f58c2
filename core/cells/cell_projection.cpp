#include "core/cells/cell_projection.h"

#include "core/base/ranked.h"
#include "core/cells/feet.h"
#include "core/cells/local_boolean.h"
#include "core/surface/rays/intersect.h"

#include <map>

namespace cells {

using base::Vec3d;
using surface::Evaluationd;
using surface::Need;
using surface::ProjectOptions;
using surface::Status;

const char* featureName(Feature feature) {
    constexpr const char* names[] = {"none", "face", "seam", "corner"};
    return names[static_cast<std::size_t>(feature)];
}

namespace {

constexpr std::size_t nearestSurfels = 32; ///< whose cells and creases are looked at, beside those in support
constexpr std::size_t mostStarts = 12;     ///< nearest cells and creases that are tried: labels may be anything
constexpr double partnersReach = 2.5;      ///< spacings: how far from a crease surfels have it as theirs, and a bit
constexpr double seamTolerance = 1e-9;     ///< of h: what iterations leave
constexpr double looseTolerance = 1e-3;    ///< of the spacing: where nothing is left otherwise
constexpr double atCorner = 0.25;          ///< of the spacing: other cells that belong to a corner of three

using Cells = std::vector<std::uint32_t>;

class CellProjector {
  public:
    CellProjector(const CellSurface& surface, const Vec3d& x, const ProjectOptions& options)
        : m_source(surface), m_x(x), m_feet(m_source, x, options) {}

    CellFoot run() {
        findStarts();
        for (const auto& [cell, start] : m_faceStarts)
            take({cell}, m_feet.face(cell, start.position));
        for (const auto& [pair, start] : m_seamStarts)
            if (start.distance - partnersReach * start.spacing < m_least)
                seam(pair, start.position);
        corners();
        return best();
    }

  private:
    struct Start {
        Vec3d position;
        double distance = 0, spacing = 0;
    };
    struct Candidate {
        Vec3d foot;
        Cells cells;
        double distance;
        bool strict;
    };
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    void findStarts() {
        m_source.moveTo(m_x);
        const surface::Surface& surface = m_source.surface().surface();
        std::vector<tree::Neighbour> near;
        surface.tree().nearest(base::cast<float>(m_x), nearestSurfels, near);
        for (const tree::Neighbour& each : near) {
            const double support = static_cast<double>(each.block->support(each.slot));
            note(base::cast<double>(each.block->position(each.slot)),
                 m_source.surface().labels().at(*each.block, each.slot), support);
        }
        const double support = near.empty() ? 0 : static_cast<double>(near.front().block->support(near.front().slot));
        m_source.forSurfels([&](const Vec3d& p, const Label& label, double) { note(p, label, support); });
        keepNearest(m_faceStarts);
        keepNearest(m_seamStarts);
        // a place where the cell has a meaning already is the best to start from
        for (auto& [cell, start] : m_faceStarts) {
            const std::size_t i = m_source.find(cell);
            if (i == CellSource::none)
                continue;
            const Evaluationd& at = m_source.at(i, Need::Value);
            if (valid(at) && at.offCentre <= surface::maxOffCentre * at.unit)
                start.position = m_x;
        }
    }
    template <class Starts>
    static void keepNearest(Starts& starts) {
        if (starts.size() <= mostStarts)
            return;
        std::vector<double> distances;
        for (const auto& each : starts)
            distances.push_back(each.second.distance);
        const double farthest = base::ranked(distances, mostStarts);
        std::erase_if(starts, [&](const auto& each) { return each.second.distance >= farthest; });
    }
    void note(const Vec3d& p, const Label& label, double support) {
        const Start start{p, base::distance(p, m_x), support * surface::spacingOfUnit};
        const auto keep = [&](auto& starts, const auto& key) {
            const auto [at, fresh] = starts.emplace(key, start);
            if (!fresh && start.distance < at->second.distance)
                at->second = start;
        };
        keep(m_faceStarts, label.cell);
        if (label.meeting != Meeting::None)
            keep(m_seamStarts, Pair(std::minmax(label.cell, label.partner)));
    }

    void seam(const Pair& pair, const Vec3d& start) {
        const auto foot = m_feet.seam(pair.first, pair.second, start);
        m_seamFeet[pair] = foot ? *foot : start;
        take({pair.first, pair.second}, foot);
    }

    /// Of any three cells of which two pairs at least meet.
    void corners() {
        std::map<Cells, Vec3d> triples;
        for (const auto& [a, startA] : m_seamFeet)
            for (const auto& [b, startB] : m_seamFeet) {
                Cells cells{a.first, a.second, b.first, b.second};
                std::sort(cells.begin(), cells.end());
                cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
                if (cells.size() == 3)
                    triples.emplace(cells, startA);
            }
        for (auto& [cells, start] : triples)
            if (auto foot = m_feet.corner(cells, start)) {
                Cells all = withOthers(cells, *foot);
                if (all.size() > 3)
                    foot = m_feet.corner(all, *foot);
                take(all, foot);
            }
    }
    /// Further cells that meet one of a corner's and pass it by closely.
    Cells withOthers(const Cells& cells, const Vec3d& foot) {
        m_source.moveTo(foot);
        Cells out = cells;
        for (std::size_t i = 0; i < m_source.count(); ++i) {
            if (std::find(cells.begin(), cells.end(), m_source.cell(i)) != cells.end())
                continue;
            const bool meets = std::any_of(cells.begin(), cells.end(), [&](std::uint32_t cell) {
                const std::size_t j = m_source.find(cell);
                return j != CellSource::none && m_source.meeting(i, j) != Meeting::None;
            });
            const Evaluationd& at = m_source.at(i, Need::Value);
            if (meets && valid(at) && std::abs(at.value) < atCorner * surface::spacingOfUnit * at.unit)
                out.push_back(m_source.cell(i));
        }
        std::sort(out.begin(), out.end());
        return out;
    }

    /// Keeps a foot that all its cells agree is surface.
    void take(const Cells& cells, const std::optional<Vec3d>& foot) {
        if (!foot)
            return;
        m_source.moveTo(*foot);
        double unit = 0, residual = 0;
        for (const std::uint32_t cell : cells) {
            const std::size_t i = m_source.find(cell);
            if (i == CellSource::none)
                return;
            const Evaluationd& at = m_source.at(i, Need::Gradient);
            unit = at.unit;
            residual = std::max(residual, std::abs(at.value));
        }
        const double loose = looseTolerance * surface::spacingOfUnit * unit;
        const double exact = cells.size() == 1 ? cutTolerance(unit, length(*foot)) : seamTolerance * unit;
        if (!(residual <= loose))
            return;
        const double strict = cells.size() > 3 ? std::max(exact, 2 * residual) : exact;
        if (cells.size() <= 3 && !(residual <= seamTolerance * unit))
            return;
        const double distance = base::distance(*foot, m_x);
        const bool kept = accepted(cells, strict);
        if (!kept && !accepted(cells, loose))
            return;
        m_candidates.push_back({*foot, cells, distance, kept});
        if (kept)
            m_least = std::min(m_least, distance);
    }
    bool accepted(const Cells& cells, double tolerance) {
        return std::all_of(cells.begin(), cells.end(),
                           [&](std::uint32_t cell) { return isFace(m_source, m_source.find(cell), tolerance); });
    }

    CellFoot best() {
        CellFoot out;
        out.mixed = true;
        out.projection.iterations = m_feet.iterations();
        out.projection.evaluations = m_feet.evaluations();
        const Candidate* nearest = nullptr;
        for (const Candidate& each : m_candidates)
            if (!nearest || each.strict > nearest->strict ||
                (each.strict == nearest->strict && each.distance < nearest->distance))
                nearest = &each;
        if (!nearest) {
            out.projection.status = m_faceStarts.empty() ? Status::Outside : Status::NotConverged;
            return out;
        }
        m_source.moveTo(nearest->foot);
        out.projection.foot = nearest->foot;
        out.projection.at = m_source.at(m_source.find(nearest->cells.front()), Need::Gradient);
        out.projection.at.status = out.projection.status = Status::Ok;
        const double near = featureTolerance * surface::spacingOfUnit * out.projection.at.unit;
        out.cells = nearest->cells;
        for (const Candidate& each : m_candidates)
            if (each.cells.size() > out.cells.size() && base::distance(each.foot, nearest->foot) <= near)
                out.cells = each.cells;
        out.feature = out.cells.size() == 1 ? Feature::Face : out.cells.size() == 2 ? Feature::Seam : Feature::Corner;
        return out;
    }

    CellSource m_source;
    Vec3d m_x;
    Feet m_feet;
    std::map<std::uint32_t, Start> m_faceStarts;
    std::map<Pair, Start> m_seamStarts;
    std::map<Pair, Vec3d> m_seamFeet; ///< or where they were looked for
    std::vector<Candidate> m_candidates;
    double m_least = std::numeric_limits<double>::infinity(); ///< distance of the nearest foot that is strictly surface
};

} // namespace

CellFoot projectCells(const CellSurface& surface, const Vec3d& x, const ProjectOptions& options) {
    return CellProjector(surface, x, options).run();
}

CellFoot project(const CellSurface& surface, const Vec3d& x, const ProjectOptions& options) {
    CellSource source(surface);
    source.moveTo(x);
    if (source.count() > 1)
        return projectCells(surface, x, options);
    CellFoot out;
    out.projection = projectReference(surface.surface(), x, options);
    if (out.projection.status != Status::Ok && out.projection.status != Status::BeyondBoundary)
        return projectCells(surface, x, options);
    source.moveTo(out.projection.foot);
    if (source.count() != 1 || cutOff(source, 0, cutTolerance(out.projection.at.unit, length(out.projection.foot))))
        return projectCells(surface, x, options);
    out.feature = Feature::Face;
    out.cells = {source.cell(0)};
    return out;
}

} // namespace cells
