#include "core/solid/loops/shape_patch.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/projection/project.h"

#include <Eigen/SparseCholesky>
#include <numbers>
#include <optional>
#include <queue>
#include <span>

namespace solid {

using base::Vec3d;
using Matrix = Eigen::SparseMatrix<double>;
using Columns = Eigen::MatrixXd;

namespace {

/// The patch with rings of the surface around it: ring 0 is the loop, what follows lies ever farther from the hole.
struct Ringed {
    std::vector<Vec3d> positions;
    std::vector<mesh::Triangle> triangles;
    std::vector<std::uint8_t> free; ///< of each position
    std::size_t inner = 0;          ///< positions of the patch, which stand first
};

constexpr int rings = 2;

/// How far one ring lies from the next, in spacings: a part of the hole's radius where that is more, up to this many.
/// Beside the loop surfels are on one side only, and the surface leans by some hundredths: narrow rings would carry
/// that, and the noise of a scan, up to the middle.
constexpr double widestStep = 2, stepOfRadius = 0.3;

Ringed ringed(const surface::Surface& surface, const Loop& loop, const Patch& patch) {
    Ringed out{patch.positions, patch.triangles, {}, patch.positions.size()};
    const auto n = static_cast<std::uint32_t>(loop.size()), first = static_cast<std::uint32_t>(patch.positions.size());
    out.free.assign(patch.positions.size(), 1);
    std::fill_n(out.free.begin(), n, 0);
    const double radius = loop.length / (2 * std::numbers::pi);
    out.positions.resize(first + std::size_t(rings) * n);
    out.free.resize(out.positions.size(), 0);
    base::parallelFor(n, 4, [&](std::size_t i) {
        const LoopPoint& p = loop.points[i];
        const double step = std::clamp(stepOfRadius * radius, p.spacing, widestStep * p.spacing);
        for (int ring = 1; ring <= rings; ++ring) {
            Vec3d place = p.position - p.outward * (step * ring);
            const auto foot =
                surface::projectReference(surface, place, {.checkBoundary = false}, {base::cast<float>(p.normal)});
            if (foot.ok() && distance(foot.foot, place) < step * ring)
                place = foot.foot;
            out.positions[first + static_cast<std::size_t>(ring - 1) * n + i] = place;
        }
    });
    for (int ring = 1; ring <= rings; ++ring)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t j = (i + 1) % n, outer = first + static_cast<std::uint32_t>(ring - 1) * n,
                                inner = ring == 1 ? 0 : outer - n;
            out.triangles.push_back({inner + i, outer + i, inner + j});
            out.triangles.push_back({inner + j, outer + i, outer + j});
        }
    return out;
}

/// Areas of triangles count as no less than so much of the sum of their sides' squares (0.14 where these are equal).
constexpr double thinnest = 0.02;

/// Stiffness by cotangents and lumped areas, of lengths in units of `unit`. It is never negative, as a sum of what
/// triangles contribute, nor does it see planes, while weights of single edges, of obtuse angles, may well be below
/// zero: kept above, they would look like curvature, which bends large patches more than the surface around does.
struct Measures {
    Matrix stiffness;
    Eigen::VectorXd areas;
};

Measures measuresOf(const std::vector<Vec3d>& x, const std::vector<mesh::Triangle>& triangles, double unit) {
    const auto n = static_cast<Eigen::Index>(x.size());
    Measures out{Matrix(n, n), Eigen::VectorXd::Constant(n, 1e-3)};
    std::vector<Eigen::Triplet<double>> entries;
    for (const mesh::Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<int>(t[k]), b = static_cast<int>(t[(k + 1) % 3]);
            const Vec3d c = x[t[(k + 2) % 3]], u = (x[t[k]] - c) / unit, v = (x[t[(k + 1) % 3]] - c) / unit;
            const double twice = length(cross(u, v));
            const double sides = lengthSq(u) + lengthSq(v) + lengthSq(u - v);
            const double weight = 0.5 * dot(u, v) / std::max({twice, 2 * thinnest * sides, 1e-12});
            entries.emplace_back(a, b, weight), entries.emplace_back(b, a, weight);
            out.areas[a] += twice / 6;
        }
    Matrix sums(n, n);
    sums.setFromTriplets(entries.begin(), entries.end());
    entries.clear();
    for (int column = 0; column < sums.outerSize(); ++column)
        for (Matrix::InnerIterator it(sums, column); it; ++it) {
            entries.emplace_back(it.row(), column, -it.value()), entries.emplace_back(column, column, it.value());
        }
    out.stiffness.setFromTriplets(entries.begin(), entries.end());
    return out;
}

/// Values of the free vertices, for given ones of the others, of least |grad u|^2 (order 1) or |grad laplace u|^2 (3).
bool solve(const Measures& measures, const std::vector<std::uint8_t>& free, int order, Columns& values) {
    Matrix whole = measures.stiffness;
    const Eigen::VectorXd perArea = measures.areas.cwiseInverse();
    for (int k = 1; k < order; ++k)
        whole = (measures.stiffness * perArea.asDiagonal() * whole).eval();
    std::vector<int> place(free.size(), -1);
    int count = 0;
    for (std::size_t v = 0; v < free.size(); ++v)
        if (free[v])
            place[v] = count++;
    if (count == 0)
        return true;
    std::vector<Eigen::Triplet<double>> entries;
    Columns right = Columns::Zero(count, values.cols());
    for (int column = 0; column < whole.outerSize(); ++column)
        for (Matrix::InnerIterator it(whole, column); it; ++it) {
            const int row = place[static_cast<std::size_t>(it.row())], at = place[static_cast<std::size_t>(column)];
            if (row < 0)
                continue;
            if (at >= 0)
                entries.emplace_back(row, at, it.value());
            else
                right.row(row) -= it.value() * values.row(column);
        }
    Matrix system(count, count);
    system.setFromTriplets(entries.begin(), entries.end());
    base::CancelScope::check();
    const Eigen::SimplicialLDLT<Matrix> solver(system);
    if (solver.info() != Eigen::Success)
        return false;
    const Columns found = solver.solve(right);
    if (solver.info() != Eigen::Success || !found.allFinite())
        return false;
    for (std::size_t v = 0; v < free.size(); ++v)
        if (place[v] >= 0)
            values.row(static_cast<Eigen::Index>(v)) = found.row(place[v]);
    return true;
}

double extentOf(const Loop& loop) {
    double out = 0;
    for (const LoopPoint& p : loop.points)
        out = std::max(out, distance(p.position, loop.middle));
    return out;
}

/// Does a solution stay about its loop?
bool staysNear(const Loop& loop, std::span<const Vec3d> positions) {
    const double most = 2 * extentOf(loop) + 4 * loop.meanSpacing();
    return std::all_of(positions.begin(), positions.end(),
                       [&](const Vec3d& p) { return distance(p, loop.middle) <= most; });
}

using Positions = std::optional<std::vector<Vec3d>>;

/// Of the patch and its rings, of least energy of that order. Nothing where it swings away from the loop.
Positions shaped(const Ringed& from, const Loop& loop, int order, const base::Progress& progress) {
    constexpr int passes = 12;   // areas and angles are those of the last shape
    constexpr double step = 0.6; // of the way: all of it goes to and fro where noise around the hole decides
    const double unit = loop.meanSpacing();
    std::vector<Vec3d> out = from.positions;
    Columns values(static_cast<Eigen::Index>(out.size()), 3);
    for (int pass = 0; pass < passes; ++pass) {
        progress.step(static_cast<double>(pass) / passes, "Shaping");
        for (std::size_t v = 0; v < out.size(); ++v)
            for (std::size_t k = 0; k < 3; ++k)
                values(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)) =
                    (out[v][k] - loop.middle[k]) / unit;
        if (!solve(measuresOf(out, from.triangles, unit), from.free, order, values))
            return {};
        for (std::size_t v = 0; v < out.size(); ++v) {
            const auto row = static_cast<Eigen::Index>(v);
            if (from.free[v])
                out[v] += (loop.middle + Vec3d{values(row, 0), values(row, 1), values(row, 2)} * unit - out[v]) * step;
        }
        if (!staysNear(loop, std::span(out).first(from.inner)))
            return {};
    }
    return out;
}

bool take(const Positions& found, const Loop& loop, Patch& patch) {
    for (std::size_t v = loop.size(); found && v < patch.positions.size(); ++v)
        patch.positions[v] = (*found)[v];
    return found.has_value();
}

} // namespace

bool shapePatch(const surface::Surface& surface, const Loop& loop, Shape shape, Patch& patch,
                const base::Progress& progress) {
    constexpr double beyond = 0.15; // of the loop's extent
    const Ringed from = ringed(surface, loop, patch);
    if (shape == Shape::Flat)
        return take(shaped(from, loop, 1, progress), loop, patch);
    const auto bent = shaped(from, loop, 2, process::part(progress, 0, 0.4));
    const auto smooth = shaped(from, loop, 3, process::part(progress, 0.4, 1));
    double apart = 0;
    for (std::size_t v = 0; bent && smooth && v < patch.positions.size(); ++v)
        apart = std::max(apart, distance((*bent)[v], (*smooth)[v]));
    return take(smooth && apart <= beyond * extentOf(loop) ? smooth : bent, loop, patch);
}

std::vector<Vec3d> patchNormals(const Loop& loop, const Patch& patch) {
    std::vector<Vec3d> out(patch.positions.size());
    for (const mesh::Triangle& t : patch.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d u = patch.positions[t[(k + 1) % 3]] - patch.positions[t[k]],
                        v = patch.positions[t[(k + 2) % 3]] - patch.positions[t[k]], n = cross(u, v);
            out[t[k]] += normalized(n) * std::atan2(length(n), dot(u, v));
        }
    for (std::size_t v = 0; v < out.size(); ++v)
        out[v] = v < loop.size() ? loop.points[v].normal : normalized(out[v], loop.points[0].normal);
    return out;
}

std::vector<std::vector<double>> spreadOver(const Patch& patch, const std::vector<std::vector<double>>& values) {
    const std::size_t width = values.empty() ? 0 : values[0].size();
    std::vector<std::vector<double>> out(patch.positions.size(), std::vector<double>(width, 0));
    if (width == 0)
        return out;
    Columns columns = Columns::Zero(static_cast<Eigen::Index>(out.size()), static_cast<Eigen::Index>(width));
    for (std::size_t v = 0; v < values.size(); ++v)
        for (std::size_t k = 0; k < width; ++k)
            columns(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)) = values[v][k];
    std::vector<std::uint8_t> free(out.size(), 1);
    std::fill_n(free.begin(), patch.loopSize, 0);
    double unit = 0;
    for (const double spacing : patch.spacings)
        unit += spacing / static_cast<double>(patch.spacings.size());
    const bool found = solve(measuresOf(patch.positions, patch.triangles, unit), free, 1, columns);
    const std::vector<std::uint32_t> nearest = nearestOfLoop(patch);
    for (std::size_t v = 0; v < out.size(); ++v)
        for (std::size_t k = 0; k < width; ++k)
            out[v][k] =
                found ? columns(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(k)) : values[nearest[v]][k];
    return out;
}

std::vector<std::uint32_t> nearestOfLoop(const Patch& patch) {
    std::vector<std::vector<std::uint32_t>> beside(patch.positions.size());
    for (const mesh::Triangle& t : patch.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            beside[t[k]].push_back(t[(k + 1) % 3]);
            beside[t[k]].push_back(t[(k + 2) % 3]);
        }
    struct Reached {
        double way;
        std::uint32_t vertex, from;
        bool operator>(const Reached& o) const { return way != o.way ? way > o.way : vertex > o.vertex; }
    };
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    std::vector<std::uint32_t> out(patch.positions.size(), 0);
    std::vector<std::uint8_t> done(patch.positions.size(), 0);
    for (std::uint32_t v = 0; v < patch.loopSize; ++v)
        open.push({0, v, v});
    while (!open.empty()) {
        const Reached at = open.top();
        open.pop();
        if (done[at.vertex])
            continue;
        done[at.vertex] = 1;
        out[at.vertex] = at.from;
        for (const std::uint32_t next : beside[at.vertex])
            if (!done[next])
                open.push({at.way + distance(patch.positions[at.vertex], patch.positions[next]), next, at.from});
    }
    return out;
}

} // namespace solid
