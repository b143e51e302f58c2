#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/base/ranked.h"
#include "core/base/row_of_id.h"
#include "core/process/cleaning/spread.h"
#include "core/process/measuring/primitive_start.h"
#include "core/process/measuring/primitive_step.h"

#include <limits>

namespace process {

using base::Vec3d;

namespace {

/// Points that starts are judged by, starts, and those of them that are followed.
constexpr std::size_t judges = 1000, starts = 600, followed = 6;
/// Standard deviations within which a point belongs to the shape.
constexpr double belongs = 3;
/// Points around 0, in units of their extent.
struct Scaled {
    Vec3d centre;
    double scale = 0;
    double finest = 0; ///< what float coordinates hold
    std::vector<Vec3d> points;
};

Scaled scaled(const surfel::SurfelList& list) {
    Scaled out;
    const auto n = static_cast<double>(list.size());
    for (const surfel::Surfel& s : list.items)
        out.centre += base::cast<double>(s.position) / n;
    for (const surfel::Surfel& s : list.items)
        out.scale += lengthSq(base::cast<double>(s.position) - out.centre) / n;
    out.scale = std::sqrt(out.scale);
    if (!(out.scale > 0))
        throw base::Error("all points stand in one place", {}, "there is nothing to fit");
    double farthest = 0;
    for (const surfel::Surfel& s : list.items)
        farthest = std::max(farthest, length(base::cast<double>(s.position)));
    out.finest = farthest * static_cast<double>(std::numeric_limits<float>::epsilon()) / out.scale;
    for (const surfel::Surfel& s : list.items)
        out.points.push_back((base::cast<double>(s.position) - out.centre) / out.scale);
    return out;
}

double medianDistance(const Primitive& p, std::span<const Vec3d> points) {
    std::vector<double> d;
    for (const Vec3d& x : points)
        d.push_back(std::abs(p.distance(x)));
    return base::median(d);
}

/// An even choice.
std::vector<Vec3d> judgesOf(std::span<const Vec3d> points) {
    const std::size_t count = std::min(judges, points.size());
    std::vector<Vec3d> out;
    for (std::size_t k = 0; k < count; ++k)
        out.push_back(points[k * points.size() / count]);
    return out;
}

struct Candidate {
    std::optional<Primitive> primitive;
    double median = std::numeric_limits<double>::infinity();
};

std::vector<Candidate> candidates(const surfel::SurfelList& list, const Scaled& data, Shape shape,
                                  std::span<const Vec3d> judged) {
    const std::size_t needed = startPoints(shape);
    std::vector<Candidate> out(starts);
    base::parallelFor(starts, 8, [&](std::size_t k) {
        base::Random random(k);
        std::vector<OrientedPoint> some;
        for (std::size_t j = 0; j < needed; ++j) {
            const std::size_t i = random.below(data.points.size());
            some.push_back({data.points[i], base::normalized(base::cast<double>(list.items[i].normal), {0, 0, 1})});
        }
        out[k].primitive = startFrom(shape, some);
        if (out[k].primitive)
            out[k].median = medianDistance(*out[k].primitive, judged);
    });
    std::erase_if(out, [](const Candidate& c) { return !(c.median < std::numeric_limits<double>::infinity()); });
    std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.median < b.median; });
    return out;
}

/// Of the best starts the one that is best after some steps.
Primitive bestStart(const surfel::SurfelList& list, const Scaled& data, Shape shape, const base::Progress& progress) {
    constexpr int steps = 15;
    const std::vector<Vec3d> judged = judgesOf(data.points);
    progress.step(0, "Fitting");
    std::vector<Candidate> found = candidates(list, data, shape, judged);
    if (found.empty())
        throw base::Error(std::string("no ") + shapeTable()[static_cast<std::size_t>(shape)].id +
                              " goes through these points",
                          {}, "try another shape");
    found.resize(std::min(found.size(), followed));
    for (Candidate& c : found) {
        progress.step(0.3, "Fitting");
        for (int round = 0; round < 2; ++round) {
            const double reach = robustReach * std::max(deviationOverMad * c.median, data.finest);
            c.primitive = descend(*c.primitive, judged, reach, steps);
            c.median = medianDistance(*c.primitive, judged);
        }
    }
    return *std::min_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
                return a.median < b.median;
            })->primitive;
}

/// Of the points that belong to the shape: from the median of all, then of those that it lets in, so that strays do not
/// count.
double deviationFrom(const Primitive& p, const Scaled& data) {
    std::vector<double> d;
    for (const Vec3d& x : data.points)
        d.push_back(std::abs(p.distance(x)));
    double sigma = std::max(deviationOverMad * base::median(d), data.finest);
    for (int round = 0; round < 3; ++round) {
        std::erase_if(d, [&](double each) { return each > robustReach * sigma; });
        sigma = std::max(deviationOverMad * base::median(d), data.finest);
    }
    return sigma;
}

double largest(const Vec3d& v) {
    double out = v.x;
    for (const double each : {v.y, v.z})
        out = std::abs(each) > std::abs(out) ? each : out;
    return out;
}

/// In the points' own units, with its place and the side of its axis where they are told.
Primitive unscaled(Primitive p, const Scaled& data, const Vec3d& middle) {
    p.place = data.centre + p.place * data.scale;
    p.radius *= data.scale, p.tube *= data.scale;
    if (p.shape == Shape::Plane)
        p.place = middle - p.axis * dot(middle - p.place, p.axis);
    if (p.shape == Shape::Cylinder)
        p.place += p.axis * dot(middle - p.place, p.axis);
    if (p.shape == Shape::Sphere)
        p.axis = {0, 0, 1};
    else if (p.shape != Shape::Cone && largest(p.axis) < 0)
        p.axis = -p.axis;
    return p;
}

} // namespace

PrimitiveFit fitPrimitive(const surfel::SurfelList& points, Shape shape, const base::Progress& progress) {
    constexpr int rounds = 4, steps = 40;
    const ShapeRow& row = shapeTable()[static_cast<std::size_t>(shape)];
    if (points.size() < row.fewest)
        throw base::Error(std::string("a ") + row.id + " needs at least " + std::to_string(row.fewest) + " points", {},
                          "there are only " + std::to_string(points.size()));
    const Scaled data = scaled(points);
    Primitive p = bestStart(points, data, shape, progress);
    for (int round = 0; round < rounds; ++round) {
        progress.step(0.5 + 0.1 * round, "Fitting");
        p = descend(p, data.points, robustReach * deviationFrom(p, data), steps);
    }
    PrimitiveFit out;
    out.sigma = deviationFrom(p, data);
    Vec3d middle;
    double squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double d = std::abs(p.distance(data.points[i]));
        out.inlier.push_back(d <= belongs * out.sigma);
        if (!out.inlier.back())
            continue;
        ++out.inliers;
        squares += d * d, out.max = std::max(out.max, d * data.scale);
        middle += base::cast<double>(points.items[i].position);
    }
    const auto count = static_cast<double>(std::max<std::size_t>(out.inliers, 1));
    out.rms = std::sqrt(squares / count) * data.scale;
    out.sigma *= data.scale;
    out.primitive = unscaled(p, data, middle / count);
    return out;
}

} // namespace process
