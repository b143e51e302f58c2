// Crumbs of folds, that no sheet bears, are removed by resampling; corners and thin plates are none.
#include "core/process/resampling/resample.h"
#include "process/even_shapes.h"
#include "support/registry.h"

#include <QTest>

class StrayTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aCrumbAcrossTheSurfaceGoes();
    void thinPlatesKeepEverySurfel();
    void maskedCrumbsStay();
};

constexpr double spacing = 0.02;

/// A plane of surfels that face up, and two that face sideways in its middle.
static surfel::SurfelList withCrumb(float mask) {
    surfel::SurfelList out = test::planePoints(40, spacing);
    for (const double x : {0.3, 0.9}) {
        surfel::Surfel crumb = test::surfelAt({x * spacing, 0.4 * spacing, 0.1 * spacing}, {1, 0, 0}, spacing);
        crumb.mask = mask;
        out.append(crumb, {});
    }
    return out;
}

static surface::Surface resampled(const surface::Surface& surface) {
    process::ResampleOptions options;
    options.spacing = float(spacing);
    return {surface.tree().apply(process::resample(surface, process::selectAll(surface.tree()), options)),
            surface.definition()};
}

static std::size_t sideways(const surface::Surface& surface) {
    const auto all = surface.tree().surfels().items;
    return std::size_t(std::count_if(all.begin(), all.end(), [](const auto& each) { return each.normal.x > 0.9f; }));
}

void StrayTest::aCrumbAcrossTheSurfaceGoes() {
    const surface::Surface before = test::surfaceOf(withCrumb(0)), after = resampled(before);
    QCOMPARE(sideways(before), std::size_t(2));
    QCOMPARE(sideways(after), std::size_t(0));
    const auto foot = surface::project(after, base::Vec3f{0.005f, 0.003f, 0.01f}, {});
    QVERIFY(foot.ok() && std::abs(foot.foot.z) < 1e-3 * spacing);
}

void StrayTest::maskedCrumbsStay() {
    QCOMPARE(sideways(resampled(test::surfaceOf(withCrumb(1)))), std::size_t(2));
}

void StrayTest::thinPlatesKeepEverySurfel() {
    surfel::SurfelList plate = test::planePoints(30, spacing);
    for (const surfel::Surfel& each : test::planePoints(30, spacing).items) {
        surfel::Surfel below = each;
        below.position.z = -float(spacing);
        below.normal = {0, 0, -1};
        plate.append(below, {});
    }
    const surface::Surface before = test::surfaceOf(plate);
    QCOMPARE(test::hashOf(resampled(before)), test::hashOf(before));
}

static const test::Registered<StrayTest> registered;
#include "stray_test.moc"
