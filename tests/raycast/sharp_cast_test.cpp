// Pictures of models with cells: sharp edges and corners as they are, by full and adaptive casts and in what light
// meets.
#include "core/cells/labels.h"
#include "core/raycast/blocking.h"

#include "cells/solids.h"
#include "light_scenes.h"
#include "raycast_models.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using namespace views;
using base::Random;
using plane_solids::SampledSolid;

class SharpCastTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void solidsHaveTheirEdges_data();
    void solidsHaveTheirEdges();
    void adaptivePicturesKeepEdges();
    void lightPointsStayOnTheirFaces();
    void withoutLabelsNothingChanges();
};

namespace {

constexpr double spacing = 0.1;

SampledSolid sampledSolid(const plane_solids::Solid& solid, Random& random) {
    return plane_solids::sampled(solid, 2.4, spacing, random);
}

/// Rays that pass the solid's outline closer than this, in spacings, are not judged.
constexpr double outline = 1e-3;

struct Errors {
    int judged = 0, lost = 0, off = 0, turned = 0;
};

Errors against(const plane_solids::Solid& solid, const ImageRays& view, std::span<const Sample> samples) {
    Errors out;
    for (int row = 0; row < view.height; ++row)
        for (int column = 0; column < view.width; ++column) {
            const base::Rayd ray = view.ray(column, row);
            std::size_t plane = 0;
            const double t = solid.hit(ray, plane);
            const Sample& sample = samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) +
                                           static_cast<std::size_t>(column)];
            // how thick what the ray passes is, within some spacings
            double deepest = 1e9;
            const double from = t >= 0 ? t : length(ray.origin) - 2;
            for (double at = from; at < from + 4; at += 0.02)
                deepest = std::min(deepest, solid.value(ray.at(at)));
            if (std::abs(deepest) < 0.05 * spacing + outline)
                continue;
            ++out.judged;
            out.lost += (t >= 0) != sample.hit.hit ? 1 : 0;
            if (t < 0 || !sample.hit.hit)
                continue;
            out.off += std::abs(static_cast<double>(sample.hit.t) - t) > 1e-3 * spacing ? 1 : 0;
            out.turned += dot(base::cast<double>(sample.hit.outward), solid.planes[plane].n) < 0.9999 ? 1 : 0;
        }
    return out;
}

} // namespace

void SharpCastTest::solidsHaveTheirEdges_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("cube") << 0;
    QTest::newRow("L-block") << 1;
    QTest::newRow("random polyhedron") << 2;
}

void SharpCastTest::solidsHaveTheirEdges() {
    QFETCH(int, kind);
    const auto seed = test::seed();
    Random random(seed);
    const plane_solids::Solid solid = kind == 0   ? plane_solids::cube(0.8)
                                      : kind == 1 ? plane_solids::lBlock(0.9)
                                                  : plane_solids::polyhedron(random);
    const SampledSolid s = sampledSolid(solid, random);
    const ImageRays view = filling({}, 1.5, random.unitVector(), test::sanitized ? 40 : 120, kind == 1);
    const Errors errors = against(solid, view, full(plane_solids::surfaceOf(s.surfels), view));
    const QString where = QString("seed %1: %2 rays, %3 lost, %4 off, %5 turned")
                              .arg(seed)
                              .arg(errors.judged)
                              .arg(errors.lost)
                              .arg(errors.off)
                              .arg(errors.turned);
    QVERIFY2(errors.judged > (test::sanitized ? 500 : 5000), qPrintable(where));
    // of rays over an edge itself either face may be met
    QVERIFY2(errors.lost + errors.off <= errors.judged / 1000 && errors.turned <= errors.judged / 500,
             qPrintable(where));
}

/// As the full cast has them, and no less sharp.
void SharpCastTest::adaptivePicturesKeepEdges() {
    const auto seed = test::seed();
    Random random(seed);
    const SampledSolid s = sampledSolid(plane_solids::cube(0.8), random);
    const Surface model = plane_solids::surfaceOf(s.surfels);
    const ImageRays view = filling({}, 1.5, random.unitVector(), test::sanitized ? 60 : 200);
    const std::vector<Sample> every = full(model, view);
    const Cast adaptive = fresh(model, view, 1);
    int hits = 0, otherwise = 0, turned = 0;
    for (std::size_t i = 0; i < every.size(); ++i) {
        otherwise += every[i].hit.hit != adaptive.samples[i].hit.hit ? 1 : 0;
        if (!every[i].hit.hit || !adaptive.samples[i].hit.hit)
            continue;
        ++hits;
        turned += dot(every[i].hit.outward, adaptive.samples[i].hit.outward) < 0.99f ? 1 : 0;
    }
    const QString where =
        QString("seed %1: %2 hits, outline %3, turned %4").arg(seed).arg(hits).arg(otherwise).arg(turned);
    QVERIFY2(hits > 500 && otherwise <= 1 && turned <= hits / 500, qPrintable(where));
    QVERIFY(adaptive.counts.rays < every.size());
}

void SharpCastTest::lightPointsStayOnTheirFaces() {
    const auto seed = test::seed();
    Random random(seed);
    const SampledSolid s = sampledSolid(plane_solids::cube(0.8), random);
    const scenes::LightScene scene(plane_solids::surfaceOf(s.surfels), scenes::lightingOf(), scenes::viewer());
    const ImageRays view = filling({}, 1.5, random.unitVector(), 40);
    std::vector<Sample> samples = full(scene.surface.surface(), view);
    for (Sample& sample : samples) // as interpolation leaves them
        sample.hit.position += sample.hit.normal * static_cast<float>(0.05 * spacing);
    std::vector<scenes::LightPoint> points(samples.size());
    findLightPoints(scene, raycast::seenThrough(view, samples), 0, points);
    int judged = 0, off = 0;
    std::vector<base::Rayf> away;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (samples[i].hit.hit) {
            ++judged;
            off += std::abs(s.solid.value(base::cast<double>(points[i].x))) > 1e-2 * spacing ? 1 : 0;
            away.push_back({secondaryOrigin(points[i], points[i].n), points[i].n});
        }
    // a cube stands in nobody's light that is right above a face of it
    std::vector<std::uint8_t> blocked(away.size());
    findBlocked(scene, away, 10, blocked);
    const auto dark = std::count(blocked.begin(), blocked.end(), 1);
    const QString where = QString("seed %1: %2 points, %3 off, %4 dark").arg(seed).arg(judged).arg(off).arg(dark);
    QVERIFY2(judged > 300 && off <= judged / 100 && dark <= judged / 200, qPrintable(where));
}

void SharpCastTest::withoutLabelsNothingChanges() {
    Random random(7);
    surfel::SurfelList plain = sampledSolid(plane_solids::cube(0.8), random).surfels;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    surfel::SurfelList bare;
    bare.layout = layout;
    for (const surfel::Surfel& each : plain.items)
        bare.append(each, {});
    const Surface model = plane_solids::surfaceOf(bare);
    const ImageRays view = filling({}, 1.5, {0.5, 0.7, -0.4}, 60);
    const std::vector<Sample> samples = full(model, view);
    std::size_t hits = 0;
    for (int row = 0; row < view.height; ++row)
        for (int column = 0; column < view.width; ++column) {
            const base::Rayd ray = view.ray(column, row);
            const auto expected =
                intersect(model, base::Rayf{base::cast<float>(ray.origin), base::cast<float>(ray.direction)});
            const auto& hit = samples[static_cast<std::size_t>(row * view.width + column)].hit;
            QCOMPARE(hit.hit, expected.hit);
            if (hit.hit) {
                QCOMPARE(hit.position, expected.position);
                QCOMPARE(hit.normal, expected.normal);
                ++hits;
            }
        }
    QVERIFY(hits > 500);
}

static const test::Registered<SharpCastTest> registered;
#include "sharp_cast_test.moc"
