// Scenes in tests: their command, two models to begin with, and where surfels stand.
#pragma once

#include "core/base/random.h"
#include "core/session/scene/scene.h"
#include "support/registry.h"
#include "workbench.h"

namespace test::scenes {

using base::Vec3d;
using session::Scene, session::SceneModel;

inline json scene(const char* what, const json& more = json::object()) {
    json out{{"op", "scene"}, {"do", what}};
    out.update(more);
    return out;
}

inline const SceneModel& model(const Workbench& bench, const char* name) {
    const Scene& all = bench.document.scene();
    const int index = all.indexOf(std::string_view(name));
    if (index < 0)
        throw std::logic_error(name);
    return all.models[static_cast<std::size_t>(index)];
}

inline json randomPose(base::Random& random, double reach = 2) {
    const process::Rigid turned = process::motionOf(
        {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)},
        {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)});
    return session::matrixOf(turned);
}

/// "ball", which is active, and "ring", somewhere.
inline void makeScene(Workbench& bench, base::Random& random) {
    bench.run({{"op", "new"}, {"sample", "torus"}, {"count", 2500}});
    bench.run({{"op", "save"}, {"path", bench.path("ring.ply").string()}});
    bench.run(test::newSphere(2000));
    bench.run(scene("rename", {{"to", "ball"}}));
    bench.run(scene("add", {{"path", bench.path("ring.ply").string()}, {"matrix", randomPose(random)}}));
    bench.run(scene("activate", {{"name", "ball"}}));
}

/// Where each surfel stands in the scene.
inline std::vector<Vec3d> placesOf(const SceneModel& model) {
    std::vector<Vec3d> out;
    for (const surfel::Surfel& s : model.surface.tree().surfels().items)
        out.push_back(model.pose(base::cast<double>(s.position) + model.origin()));
    return out;
}

/// Greatest distance of any place from the nearest of the others, both ways.
inline double apart(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
    double out = a.size() == b.size() ? 0 : 1e30;
    const auto reach = [&out](const std::vector<Vec3d>& from, const std::vector<Vec3d>& to) {
        for (const Vec3d& x : from) {
            double least = 1e30;
            for (const Vec3d& y : to)
                least = std::min(least, distance(x, y));
            out = std::max(out, least);
        }
    };
    reach(a, b);
    reach(b, a);
    return out;
}

inline std::vector<Vec3d> allPlaces(const Workbench& bench) {
    std::vector<Vec3d> out;
    for (const SceneModel& each : bench.document.scene().models) {
        const std::vector<Vec3d> own = placesOf(each);
        out.insert(out.end(), own.begin(), own.end());
    }
    return out;
}

} // namespace test::scenes
