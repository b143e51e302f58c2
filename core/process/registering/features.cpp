#include "core/process/registering/features.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/process/cleaning/thin.h"
#include "core/process/estimation/keep_points.h"
#include "core/process/neighbours/knn.h"

#include <nanoflann.hpp>
#include <numbers>

namespace process {

using base::Vec3d;

namespace {

constexpr std::size_t bins = 11, around = 60;
constexpr double reach = 5; ///< of the spacing

/// The bin of a number between two ends.
std::size_t binOf(double value, double low, double high) {
    const double part = (value - low) / (high - low) * bins;
    return static_cast<std::size_t>(std::clamp(part, 0.0, bins - 1.0));
}

/// The angles between two oriented points in the frame that they make [Rusu09, II].
void count(const Vec3d& p, const Vec3d& n, const Vec3d& q, const Vec3d& m, Feature& out) {
    const Vec3d way = base::normalized(q - p), v = base::normalized(cross(n, way));
    if (v == Vec3d{})
        return;
    const Vec3d w = cross(n, v);
    out[binOf(dot(v, m), -1, 1)] += 1;
    out[bins + binOf(dot(n, way), -1, 1)] += 1;
    out[2 * bins + binOf(std::atan2(dot(w, m), dot(n, m)), -std::numbers::pi, std::numbers::pi)] += 1;
}

/// Each third to the sum 100.
void normalise(Feature& f) {
    for (std::size_t third = 0; third < 3; ++third) {
        float sum = 0;
        for (std::size_t k = 0; k < bins; ++k)
            sum += f[third * bins + k];
        for (std::size_t k = 0; sum > 0 && k < bins; ++k)
            f[third * bins + k] *= 100 / sum;
    }
}

struct FeatureList {
    std::span<const Feature> f;
    std::uint32_t* asked = nullptr; ///< while the tree is built, by one thread
    std::size_t kdtree_get_point_count() const { return f.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t axis) const {
        if (asked && ++*asked % (1u << 18) == 0) // the only way into the library's loop
            base::CancelScope::check();
        return f[i][axis];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

using FeatureTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Adaptor<float, FeatureList, float, std::uint32_t>,
                                                        FeatureList, 33, std::uint32_t>;

} // namespace

Features featuresOf(const surface::Surface& surface, float spacing, const base::Progress& progress) {
    surfel::SurfelList points = surface.tree().surfels();
    const std::vector<std::uint8_t> removed = thinned(points, spacing, progress);
    keepPoints(points, [&](std::size_t i) { return removed[i] == 0; });
    const Cloud cloud(points.items, progress);
    Features out;
    out.oriented = points.layout->normals && points.layout->oriented;
    out.position.resize(cloud.size()), out.normal.resize(cloud.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        out.position[cloud.places()[i]] = base::cast<double>(points.items[i].position);
        out.normal[cloud.places()[i]] = base::cast<double>(points.items[i].normal);
    }
    if (cloud.size() < 4)
        return out;
    const double farSq = reach * reach * static_cast<double>(spacing) * static_cast<double>(spacing);
    std::vector<Feature> own(cloud.size(), Feature{});
    const auto forNear = [&](const Neighbours& near, const auto& body) {
        for (std::size_t k = 0; k < near.size() && static_cast<double>(near.distanceSq[k]) <= farSq; ++k)
            body(near.index[k], std::sqrt(static_cast<double>(near.distanceSq[k])));
    };
    cloud.forEach(around, progress, "Describing", [&](std::size_t i, const Neighbours& near) {
        forNear(near, [&](std::uint32_t j, double) {
            const double side = out.oriented || dot(out.normal[i], out.normal[j]) >= 0 ? 1 : -1;
            count(out.position[i], out.normal[i], out.position[j], out.normal[j] * side, own[i]);
        });
        normalise(own[i]);
    });
    out.feature = own;
    cloud.forEach(around, progress, "Describing", [&](std::size_t i, const Neighbours& near) {
        double all = 0;
        Feature sum{};
        forNear(near, [&](std::uint32_t j, double d) {
            const double weight = static_cast<double>(spacing) / std::max(d, 1e-30);
            all += weight;
            for (std::size_t k = 0; k < sum.size(); ++k)
                sum[k] += static_cast<float>(weight) * own[j][k];
        });
        for (std::size_t k = 0; all > 0 && k < sum.size(); ++k)
            out.feature[i][k] += sum[k] / static_cast<float>(all);
        normalise(out.feature[i]);
    });
    return out;
}

std::vector<std::uint32_t> mostAlike(const Features& from, const Features& to) {
    std::uint32_t asked = 0;
    FeatureList list{to.feature, &asked};
    const FeatureTree tree(33, list, nanoflann::KDTreeSingleIndexAdaptorParams(16));
    list.asked = nullptr; // what follows asks from many threads
    std::vector<std::uint32_t> out(from.feature.size());
    base::parallelFor(out.size(), 64, [&](std::size_t i) {
        float distanceSq = 0;
        nanoflann::KNNResultSet<float, std::uint32_t, std::size_t> result(1);
        result.init(&out[i], &distanceSq);
        tree.findNeighbors(result, from.feature[i].data(), nanoflann::SearchParams());
    });
    return out;
}

} // namespace process
