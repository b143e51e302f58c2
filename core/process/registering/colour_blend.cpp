#include "core/process/registering/colour_blend.h"

#include "core/base/parallel.h"
#include "core/base/ranked.h"
#include "core/process/cleaning/spread.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/neighbours/knn.h"
#include "core/surfel/colour_light.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>
#include <map>

namespace process {

using base::Vec3d;
using surfel::Colour, surfel::lightOf;

namespace {

constexpr std::size_t neighbours = 16;
constexpr double dark = 2.0 / 255; // linear light below which factors say little

struct Pair {
    std::uint32_t a, b;
};

Vec3d levelsOf(const Vec3d& light) {
    const auto out = [](double v) { return 255 * base::srgbOf(std::clamp(v, 0.0, 1.0)); };
    return {out(light.x), out(light.y), out(light.z)};
}

double meanSquare(std::span<const Pair> pairs, std::span<const Vec3d> light) {
    double sum = 0;
    for (const Pair& p : pairs)
        sum += lengthSq(levelsOf(light[p.a]) - levelsOf(light[p.b])) / 3;
    return pairs.empty() ? 0 : std::sqrt(sum / static_cast<double>(pairs.size()));
}

/// Rows of neighbours of points, by their numbers in the list: of each position the first point in it.
std::vector<std::vector<std::uint32_t>> neighbourRows(const surfel::SurfelList& points,
                                                      const base::Progress& progress) {
    const Cloud cloud(points.items, part(progress, 0, 0.3));
    std::vector<std::uint32_t> first(cloud.size(), ~0u);
    const PointPlaces places = cloud.places();
    std::vector<std::vector<std::uint32_t>> together(cloud.size()), out(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
        together[places[i]].push_back(i);
    std::vector<std::vector<std::uint32_t>> rows(cloud.size());
    cloud.forEach(neighbours, part(progress, 0.3, 1), "Finding neighbours",
                  [&](std::size_t i, const Neighbours& near) { rows[i] = near.index; });
    for (std::size_t i = 0; i < cloud.size(); ++i)
        for (const std::uint32_t point : together[i]) {
            for (const std::uint32_t other : together[i])
                if (other != point)
                    out[point].push_back(other);
            for (const std::uint32_t j : rows[i])
                out[point].push_back(together[j].front());
        }
    return out;
}

/// The nearest of each other scan that is as near as the neighbours of the own one are, and faces alike.
std::vector<Pair> pairsOf(const surfel::SurfelList& points, std::span<const std::uint32_t> scanOf,
                          const std::vector<std::vector<std::uint32_t>>& rows) {
    constexpr float alike = 0.7f; // cosine
    const bool normals = points.layout->normals;
    std::vector<Pair> out;
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
        std::uint32_t seen = scanOf[i];
        for (const std::uint32_t j : rows[i]) {
            const bool faces = !normals || std::abs(dot(points.items[i].normal, points.items[j].normal)) > alike;
            if (scanOf[j] == scanOf[i] || scanOf[j] == seen || !faces)
                continue;
            seen = scanOf[j];
            out.push_back({i, j});
        }
    }
    return out;
}

/// Logarithms of factors: the median of all pairs of two scans, put together by least squares.
std::vector<Vec3d> gainsOf(std::span<const Pair> pairs, std::span<const Vec3d> light,
                           std::span<const std::uint32_t> scanOf, std::size_t scans) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Pair>> byScans;
    for (const Pair& p : pairs)
        byScans[std::minmax(scanOf[p.a], scanOf[p.b])].push_back(scanOf[p.a] < scanOf[p.b] ? p : Pair{p.b, p.a});
    std::vector<Vec3d> out(scans);
    for (std::size_t c = 0; c < 3; ++c) {
        const auto n = static_cast<Eigen::Index>(scans);
        constexpr double hold = 1e-6; // all together stay as bright as they were
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n) * hold;
        Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
        for (const auto& [which, own] : byScans) {
            std::vector<double> ratios;
            for (const Pair& p : own)
                if (light[p.a][c] > dark && light[p.b][c] > dark && light[p.a][c] < 0.98 && light[p.b][c] < 0.98)
                    ratios.push_back(std::log(light[p.b][c] / light[p.a][c]));
            if (ratios.empty())
                continue;
            const auto weight = static_cast<double>(ratios.size()) / static_cast<double>(pairs.size());
            const double ratio = base::median(ratios); // g_a - g_b is to be it
            const auto a = static_cast<Eigen::Index>(which.first), b = static_cast<Eigen::Index>(which.second);
            matrix(a, a) += weight, matrix(b, b) += weight, matrix(a, b) -= weight, matrix(b, a) -= weight;
            right(a) += weight * ratio, right(b) -= weight * ratio;
        }
        const Eigen::VectorXd found = matrix.ldlt().solve(right);
        for (std::size_t k = 0; k < scans; ++k)
            out[k][c] = std::exp(found(static_cast<Eigen::Index>(k)));
    }
    return out;
}

/// What each point lacks of the middle of both scans, known in pairs, spread over neighbours of the own scan.
std::vector<Vec3d> faded(std::span<const Pair> pairs, std::span<const Vec3d> light,
                         std::span<const std::uint32_t> scanOf, const std::vector<std::vector<std::uint32_t>>& rows,
                         int fade, const base::Progress& progress) {
    std::vector<Vec3d> known(light.size()), now(light.size());
    std::vector<double> weight(light.size(), 0);
    for (const Pair& p : pairs) {
        known[p.a] += (light[p.b] - light[p.a]) * 0.5, weight[p.a] += 1;
        known[p.b] += (light[p.a] - light[p.b]) * 0.5, weight[p.b] += 1;
    }
    const double screen = 1.0 / (fade * fade); // decays by e over about as many neighbours
    for (int round = 0; round < 4 * fade; ++round) {
        progress.step(static_cast<double>(round) / (4 * fade), "Blending colours");
        std::vector<Vec3d> next(light.size());
        base::parallelFor(light.size(), 1024, [&](std::size_t i) {
            Vec3d sum = known[i];
            double all = weight[i];
            double own = 0;
            for (const std::uint32_t j : rows[i])
                if (scanOf[j] == scanOf[i])
                    sum += now[j], own += 1;
            all += own * (1 + screen);
            next[i] = all > 0 ? sum / all : Vec3d();
        });
        now.swap(next);
    }
    return now;
}

} // namespace

BlendedColours blendColours(const surfel::SurfelList& points, std::span<const std::uint32_t> scanOf, std::size_t scans,
                            int fade, const base::Progress& progress) {
    BlendedColours out;
    const auto rows = neighbourRows(points, part(progress, 0, 0.5));
    const std::vector<Pair> pairs = pairsOf(points, scanOf, rows);
    std::vector<Vec3d> light;
    for (const surfel::Surfel& each : points.items)
        light.push_back(lightOf(each.colour));
    out.pairs = pairs.size();
    out.before = meanSquare(pairs, light);
    out.gains = gainsOf(pairs, light, scanOf, scans);
    for (std::size_t i = 0; i < light.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            light[i][c] *= out.gains[scanOf[i]][c];
    if (fade > 0 && !pairs.empty()) {
        const std::vector<Vec3d> more = faded(pairs, light, scanOf, rows, fade, part(progress, 0.5, 1));
        for (std::size_t i = 0; i < light.size(); ++i)
            light[i] += more[i];
    }
    out.after = meanSquare(pairs, light);
    out.colours.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3d v = levelsOf(light[i]);
        const auto level = [](double each) { return static_cast<Colour>(std::lround(each)); };
        const bool kept = out.gains[scanOf[i]] == Vec3d{1, 1, 1} && lightOf(points.items[i].colour) == light[i];
        out.colours[i] =
            kept ? points.items[i].colour
                 : (level(v.x) | level(v.y) << 8 | level(v.z) << 16 | (points.items[i].colour & 0xff000000u));
    }
    return out;
}

} // namespace process
