// Splats show what the surface is: their masks are those of rays, however unevenly it was sampled.
#include "cells/solids.h"
#include "core/process/estimation/prepare.h"
#include "render/masks.h"
#include "render/render_models.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using base::Vec3d;
using test::MaskGap;

class MasksTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void splatsCoverWhatRaysHit_data();
    void splatsCoverWhatRaysHit();
    void fewSamplesShowTheirOutline_data();
    void fewSamplesShowTheirOutline();
    void discsEndAtSharpEdges_data();
    void discsEndAtSharpEdges();
    void discsEndAtCornersOfCells_data();
    void discsEndAtCornersOfCells();
    void gapsAndStraysAreCounted();
};

namespace {

/// Random samples of a lumpy ball as a scan brings them, positions alone: no distance is kept, and the spacing grows
/// `ratio` times from its lower end to its upper.
surfel::SurfelList scanOf(std::size_t count, double ratio, std::uint64_t seed) {
    base::Random random(seed);
    surfel::SurfelList out;
    while (out.size() < count) {
        const Vec3d d = random.unitVector();
        if (random.uniform() > std::pow(ratio, -1 - d.z))
            continue;
        surfel::Surfel s;
        s.position = base::cast<float>(d * (1 + 0.15 * std::sin(3 * d.x) * std::sin(4 * d.y)));
        out.items.push_back(s);
    }
    return out;
}

/// Adds eight samples about each where z > `from`, and leaves the supports as they were: as a stroke that fills in.
surface::Surface withDensePlace(const surface::Surface& surface, double from, std::uint64_t seed) {
    surfel::SurfelList list = surface.tree().surfels();
    base::Random random(seed);
    const std::size_t size = list.size();
    for (std::size_t i = 0; i < size; ++i)
        for (int k = 0; list.items[i].position.z > float(from) && k < 8; ++k) {
            surfel::Surfel s = list.items[i];
            const base::Vec3f way = base::cast<float>(random.unitVector()) * (0.2f * s.support);
            s.position += way - s.normal * dot(way, s.normal);
            list.items.push_back(s);
        }
    return {tree::SurfelTree::build(list), surface.definition()};
}

/// Random samples of the sides of a prism with exact normals; of a star where every other corner lies within.
surfel::SurfelList prismOf(int corners, double inner, double spacing, std::uint64_t seed) {
    base::Random random(seed);
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    const auto corner = [&](int k) {
        const double a = 2 * std::numbers::pi * k / corners, r = k % 2 ? inner : 1;
        return Vec3d{r * std::cos(a), r * std::sin(a), 0};
    };
    const Vec3d up{0, 0, 0.6};
    const auto fill = [&](const Vec3d& at, const Vec3d& u, const Vec3d& v, double part) {
        const Vec3d n = cross(u, v);
        for (auto left = static_cast<int>(3 * length(n) * part / (spacing * spacing)); left > 0; --left) {
            double a = random.uniform(), b = random.uniform();
            if (part < 1 && a + b > 1)
                a = 1 - a, b = 1 - b;
            surfel::Surfel s;
            s.position = base::cast<float>(at + u * a + v * b);
            s.normal = base::cast<float>(normalized(n));
            out.append(s, {});
        }
    };
    for (int k = 0; k < corners; ++k) {
        const Vec3d a = corner(k), b = corner(k + 1);
        fill(a, b - a, up, 1);
        fill({0, 0, 0}, b, a, 0.5);
        fill(up, a, b, 0.5);
    }
    return out;
}

MaskGap gapOf(const surface::Surface& surface, const render::RenderOptions& options, std::size_t most) {
    const std::vector<render::Camera> views = test::allAround(surface.tree().bounds(), 240, 180);
    return test::maskGap(surface, options, std::span(views).first(std::min(most, views.size())));
}

} // namespace

void MasksTest::splatsCoverWhatRaysHit_data() {
    QTest::addColumn<double>("ratio");
    QTest::addColumn<double>("denseFrom");
    QTest::addColumn<double>("mostStrays");
    QTest::newRow("even") << 1.0 << 2.0 << 0.1;
    QTest::newRow("spacing 1 to 5") << 5.0 << 2.0 << 0.1;
    // At its sparse end the radius of a disc is an eighth of the ball's: flat discs stand out of it by more than a
    // pixel, and farther where chance has drawn the points, which asks for larger supports (process/README 1.2).
    QTest::newRow("spacing 1 to 20") << 20.0 << 2.0 << 0.8;
    QTest::newRow("a dense place") << 1.0 << 0.4 << 0.1;
}

void MasksTest::splatsCoverWhatRaysHit() {
    QFETCH(double, ratio);
    QFETCH(double, denseFrom);
    QFETCH(double, mostStrays);
    surface::Surface surface = process::prepare(scanOf(40000, ratio, test::seed()), {});
    if (denseFrom < 1)
        surface = withDensePlace(surface, denseFrom, test::seed());
    const render::RenderOptions options = test::atRest(surface);
    // Fewer points would stand out farther.
    const auto views = std::size_t(test::effort(12));
    const MaskGap all = gapOf(surface, options, views);
    QVERIFY(all.hit > 4000 * views);
    const QString found = QString("%1 % holes, %2 % strays, scale %3, seed %4")
                              .arg(all.holesPercent())
                              .arg(all.straysPercent())
                              .arg(options.splatScale)
                              .arg(test::seed());
    QVERIFY2(all.holesPercent() < 0.1, qPrintable(found));
    QVERIFY2(all.straysPercent() < mostStrays, qPrintable(found));
}

void MasksTest::fewSamplesShowTheirOutline_data() {
    QTest::addColumn<double>("ratio");
    QTest::addColumn<double>("mostStrays");
    QTest::newRow("even") << 1.0 << 0.1;
    // A disc at its sparse end is a fifth of the ball's radius.
    QTest::newRow("spacing 1 to 3") << 3.0 << 0.1;
}

/// At rest finer discs are drawn (finer_blocks.h). In a view that moves the same discs stand out as they are.
void MasksTest::fewSamplesShowTheirOutline() {
    QFETCH(double, ratio);
    QFETCH(double, mostStrays);
    const surface::Surface surface = process::prepare(scanOf(1200, ratio, test::seed()), {});
    render::RenderOptions options = test::atRest(surface);
    const auto views = std::size_t(test::effort(10));
    const MaskGap resting = gapOf(surface, options, views);
    options.detailPx = 1.01f;
    const MaskGap moving = gapOf(surface, options, views);
    const QString found = QString("%1 % holes, %2 % strays, moving %3 %, seed %4")
                              .arg(resting.holesPercent())
                              .arg(resting.straysPercent())
                              .arg(moving.straysPercent())
                              .arg(test::seed());
    QVERIFY2(resting.holesPercent() < 0.1 && resting.straysPercent() < mostStrays, qPrintable(found));
    QVERIFY2(moving.straysPercent() > 3 * resting.straysPercent() && moving.straysPercent() > 0.1, qPrintable(found));
}

void MasksTest::discsEndAtSharpEdges_data() {
    QTest::addColumn<int>("corners");
    QTest::addColumn<double>("inner");
    QTest::newRow("box") << 4 << 1.0;
    QTest::newRow("wedges of 60 degrees") << 3 << 1.0;
    QTest::newRow("star") << 12 << 0.6;
    QTest::newRow("disc") << 60 << 1.0;
}

void MasksTest::discsEndAtSharpEdges() {
    QFETCH(int, corners);
    QFETCH(double, inner);
    // A disc is five pixels wide, as chance has drawn the points: without cuts 1.5 to 3 % of the pixels are strays.
    surface::SurfaceDefinition definition;
    definition.oneSheet = false;
    const surface::Surface surface =
        process::prepare(prismOf(corners, inner, 0.04, test::seed()), {definition, false, false, nullptr});
    const MaskGap all = gapOf(surface, test::atRest(surface), std::size_t(test::effort(12)));
    const QString found =
        QString("%1 % holes, %2 % strays, seed %3").arg(all.holesPercent()).arg(all.straysPercent()).arg(test::seed());
    QVERIFY2(all.holesPercent() < 0.1, qPrintable(found));
    QVERIFY2(all.straysPercent() < 0.7, qPrintable(found));
}

void MasksTest::discsEndAtCornersOfCells_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("cube") << 0;
    QTest::newRow("L-block") << 1;
    QTest::newRow("pyramid") << 2;
    QTest::newRow("polyhedron") << 3;
}

/// Models with cells, a spacing of eight pixels: neither corners nor edges fray, and nothing shows through them. Depths
/// tell where the inside of the far side does.
void MasksTest::discsEndAtCornersOfCells() {
    QFETCH(int, kind);
    base::Random random(test::seed());
    const plane_solids::Solid solid = kind == 0   ? plane_solids::cube(0.8)
                                      : kind == 1 ? plane_solids::lBlock(0.9)
                                      : kind == 2 ? plane_solids::pyramid(4, 1, 1.2)
                                                  : plane_solids::polyhedron(random);
    const surface::Surface surface = plane_solids::surfaceOf(plane_solids::sampled(solid, 2.4, 0.1, random).surfels);
    const render::RenderOptions options = test::atRest(surface);
    render::CpuSplatter splatter;
    MaskGap all;
    std::size_t through = 0;
    std::vector<render::Camera> views = test::allAround(surface.tree().bounds(), 240, 180);
    views.resize(test::sanitized ? 1 : 2);
    for (const render::Camera& camera : views) {
        render::Image rays;
        rays.resize(camera.width, camera.height);
        render::RayCounts counts;
        render::rayCast(surface, camera, options, rays, counts);
        const render::Image splats = test::drawn(splatter, surface.tree(), camera, options);
        all += test::maskGap(rays, splats);
        for (std::size_t i = 0; i < rays.depth.size(); ++i)
            through +=
                std::isfinite(rays.depth[i]) && std::isfinite(splats.depth[i]) && splats.depth[i] > rays.depth[i] + 0.2f
                    ? 1
                    : 0;
    }
    const QString found = QString("%1 % holes, %2 % strays, %3 of %4 pixels show through, seed %5")
                              .arg(all.holesPercent())
                              .arg(all.straysPercent())
                              .arg(through)
                              .arg(all.hit)
                              .arg(test::seed());
    QVERIFY2(all.hit > 5000 && all.holesPercent() < 0.02 && all.straysPercent() < 0.3, qPrintable(found));
    QVERIFY2(500 * through <= all.hit, qPrintable(found));
}

void MasksTest::gapsAndStraysAreCounted() {
    render::Image rays, splats;
    rays.resize(9, 9), splats.resize(9, 9);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 5; ++x)
            rays.depth[std::size_t(9 * y + x)] = splats.depth[std::size_t(9 * y + x)] = 1;
    QCOMPARE(test::maskGap(rays, splats).holes + test::maskGap(rays, splats).strays, std::size_t(0));
    splats.depth[9 * 4 + 2] = std::numeric_limits<float>::infinity(); // inside
    splats.depth[9 * 4 + 4] = std::numeric_limits<float>::infinity(); // at the outline
    splats.depth[9 * 6 + 5] = 1;                                      // at the outline
    splats.depth[9 * 6 + 7] = 1;                                      // outside
    const test::MaskGap found = test::maskGap(rays, splats);
    QCOMPARE(found.hit, std::size_t(45));
    QCOMPARE(found.holes, std::size_t(1));
    QCOMPARE(found.strays, std::size_t(1));
}

static const test::Registered<MasksTest> registered;
#include "masks_test.moc"
