#include "core/solid/tube.h"

#include "core/base/cancel_scope.h"
#include "core/base/cells.h"
#include "core/base/error.h"
#include "core/base/segment.h"
#include "core/process/resampling/resample.h"
#include "core/solid/hexagonal.h"

#include <algorithm>
#include <numbers>

namespace solid {

using base::Vec3d;
using std::numbers::pi;

// --- the curve ---

/// From b to c, by Barry and Goldman's pyramid.
static Vec3d onCurve(const Vec3d (&p)[4], const double (&knot)[4], double t) {
    const auto mix = [&](const Vec3d& a, const Vec3d& b, int i, int j) {
        return a * ((knot[j] - t) / (knot[j] - knot[i])) + b * ((t - knot[i]) / (knot[j] - knot[i]));
    };
    const Vec3d a1 = mix(p[0], p[1], 0, 1), a2 = mix(p[1], p[2], 1, 2), a3 = mix(p[2], p[3], 2, 3);
    return mix(mix(a1, a2, 0, 2), mix(a2, a3, 1, 3), 1, 2);
}

/// Halved until the middle lies on the line between both ends.
static void refine(const Vec3d (&p)[4], const double (&knot)[4], double from, double to, double tolerance, int depth,
                   std::vector<Vec3d>& out) {
    const Vec3d a = onCurve(p, knot, from), b = onCurve(p, knot, to), middle = onCurve(p, knot, 0.5 * (from + to));
    if (depth > 0 && (depth > 8 || distance(middle, nearestOnSegment(a, b, middle)) > tolerance)) {
        refine(p, knot, from, 0.5 * (from + to), tolerance, depth - 1, out);
        refine(p, knot, 0.5 * (from + to), to, tolerance, depth - 1, out);
    } else {
        out.push_back(b);
    }
}

std::vector<Vec3d> curveThrough(std::span<const Vec3d> places, double radius, bool smooth) {
    std::vector<Vec3d> own;
    for (const Vec3d& p : places)
        if (own.empty() || p != own.back())
            own.push_back(p);
    if (own.size() < 3 || !smooth)
        return own;
    const bool closed = own.front() == own.back();
    const auto count = std::ssize(own);
    const auto place = [&](std::ptrdiff_t i) {
        if (i < 0)
            return closed ? own[static_cast<std::size_t>(count - 2)] : own[0] * 2 - own[1];
        if (i >= count)
            return closed ? own[1] : own[own.size() - 1] * 2 - own[own.size() - 2];
        return own[static_cast<std::size_t>(i)];
    };
    std::vector<Vec3d> out{own.front()};
    for (std::ptrdiff_t i = 0; i + 1 < count; ++i) {
        const Vec3d p[4] = {place(i - 1), place(i), place(i + 1), place(i + 2)};
        double knot[4] = {};
        for (int k = 1; k < 4; ++k)
            knot[k] = knot[k - 1] + std::sqrt(distance(p[k - 1], p[k]));
        constexpr int halvings = 10;
        refine(p, knot, knot[1], knot[2], 1e-3 * radius, halvings, out);
    }
    return out;
}

// --- the side ---

static SegmentRuns runsOf(std::span<const Vec3d> line) {
    std::vector<base::Box3d> boxes(line.size() - 1);
    for (std::size_t k = 0; k < boxes.size(); ++k)
        boxes[k].extend(line[k]), boxes[k].extend(line[k + 1]);
    return SegmentRuns(boxes);
}

TubeSide::TubeSide(std::vector<Vec3d> line, double radius)
    : m_line(std::move(line)), m_radius(radius), m_runs(runsOf(m_line)) {}

Vec3d TubeSide::nearest(const Vec3d& x) const {
    const auto on = [&](std::size_t k) { return nearestOnSegment(m_line[k], m_line[k + 1], x); };
    return on(m_runs.nearest(x, [&](std::size_t k) { return distanceSq(on(k), x); }));
}

SideValue TubeSide::at(const Vec3d& x) const {
    const Vec3d apart = x - nearest(x);
    return {length(apart) - m_radius, normalized(apart, {0, 0, 1}), true};
}

SideFoot TubeSide::foot(const Vec3d& x) const {
    const SideValue found = at(x);
    return {x - found.gradient * found.value, found.value, found.gradient, true};
}

bool TubeSide::meets(const base::Box3d& box) const {
    return std::abs(at(box.centre()).value) <= 0.5 * box.diagonal() * (1 + 1e-9);
}

// --- its surfels ---

namespace {

constexpr std::size_t mostSurfels = 20'000'000;

class TubeSampler {
  public:
    TubeSampler(const TubeSide& side, double spacing, const surface::SurfaceDefinition& definition)
        : m_side(side), m_spacing(spacing), m_support(process::supportOf(definition, static_cast<float>(spacing))) {
        auto layout = std::make_shared<surfel::AttributeLayout>();
        layout->normals = layout->oriented = true;
        m_out.layout = layout;
    }

    surfel::SurfelList sample() {
        const auto line = m_side.line();
        const bool closed = line.front() == line.back();
        m_across = base::perpendicular(normalized(line[1] - line[0]));
        if (!closed)
            end(line[0], normalized(line[0] - line[1]));
        // rows by the way along the outer side of bends, where that is longest
        const double step = rowStep * m_spacing;
        double next = 0.5 * step;
        const auto walk = [&](double way, const auto& row) {
            for (; next < way; next += step)
                row(next);
            next -= way;
        };
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            base::CancelScope::check();
            const Vec3d along = normalized(line[k + 1] - line[k]);
            walk(distance(line[k], line[k + 1]),
                 [&](double way) { ring(line[k] + along * way, along, m_side.radius(), 0); });
            if (k + 2 == line.size() && !closed)
                break;
            const Vec3d on = normalized(k + 2 < line.size() ? line[k + 2] - line[k + 1] : line[1] - line[0]);
            const double turn = std::acos(std::clamp(dot(along, on), -1.0, 1.0));
            if (constexpr double back = pi - 1e-6; turn > back) { // no plane to turn in
                end(line[k + 1], along);
                continue;
            }
            walk(turn * m_side.radius(), [&](double way) {
                const double share = way / (turn * m_side.radius());
                ring(line[k + 1], normalized(along * std::sin((1 - share) * turn) + on * std::sin(share * turn)),
                     m_side.radius(), 0);
            });
            m_across = normalized(m_across - on * dot(m_across, on), base::perpendicular(on));
        }
        if (!closed)
            end(line.back(), normalized(line.back() - line[line.size() - 2]));
        return std::move(m_out);
    }

  private:
    void end(const Vec3d& middle, const Vec3d& outwards) {
        const double radius = m_side.radius();
        const auto rows = static_cast<int>(std::max(1.0, std::round(0.5 * pi * radius / (rowStep * m_spacing))));
        for (int row = 0; row < rows; ++row) {
            const double angle = 0.5 * pi * (row + 0.5) / rows;
            ring(middle, outwards, radius * std::cos(angle), radius * std::sin(angle));
        }
    }
    /// About an axis, at a height over its middle.
    void ring(const Vec3d& middle, const Vec3d& axis, double radius, double height) {
        const Vec3d u = normalized(m_across - axis * dot(m_across, axis), base::perpendicular(axis)),
                    v = cross(axis, u);
        const auto count = static_cast<int>(std::max(3.0, std::round(2 * pi * radius * rowStep / m_spacing)));
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * pi * (k + 0.5 * (m_rows & 1)) / count;
            const Vec3d away = u * std::cos(angle) + v * std::sin(angle);
            add(middle + away * radius + axis * height, away * radius + axis * height);
        }
        ++m_rows;
    }
    void add(const Vec3d& p, const Vec3d& normal) {
        if (m_out.size() >= mostSurfels)
            throw base::Error("a tube of that size with points so close would have more than 20 million of them", "",
                              "choose a larger spacing or a smaller radius");
        if (std::abs(m_side.at(p).value) > 0.01 * m_spacing) // inside another part
            return;
        constexpr double apart = 0.65;
        const base::Cell cell = base::cellOf(p, Vec3d(), 1 / (apart * m_spacing));
        bool free = true;
        base::forCellsAround(cell, [&](const base::Cell& around) {
            if (const std::vector<Vec3d>* there = m_taken.find(around))
                for (const Vec3d& q : *there)
                    free = free && distance(p, q) >= apart * m_spacing;
        });
        if (!free)
            return;
        m_taken.at(cell).push_back(p);
        surfel::Surfel s;
        s.position = base::cast<float>(p);
        s.normal = base::cast<float>(normalized(normal));
        s.support = m_support;
        m_out.append(s, {});
    }

    const TubeSide& m_side;
    double m_spacing;
    float m_support;
    int m_rows = 0;
    Vec3d m_across; ///< carried along the line with the least turning
    surfel::SurfelList m_out;
    base::CellMap<std::vector<Vec3d>> m_taken;
};

} // namespace

surfel::SurfelList surfelsOf(const TubeSide& side, double spacing, const surface::SurfaceDefinition& definition) {
    return TubeSampler(side, spacing, definition).sample();
}

} // namespace solid
