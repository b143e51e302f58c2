// A baseline is worth something only where it computes the same: the naive ways against the float64 reference.
#include "app/bench/naive/naive_surface.h"

#include "app/bench/scene.h"
#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using bench::NaiveEvaluation;
using bench::NaiveSurface;
using bench::Scene;
using surface::Need;
using surface::Projector;

class NaiveSurfaceTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void evaluationsAreTheReferences();
    void unevenSupportsAreFound();
    void feetAreTheReferences();
    void otherDefinitionsAreRefused();
};

static bool near(const Vec3d& a, const Vec3d& b, double tolerance) {
    return distance(a, b) <= tolerance;
}

void NaiveSurfaceTest::evaluationsAreTheReferences() {
    Scene scene({3000, 0.1});
    const NaiveSurface& naive = scene.naive();
    for (std::size_t i = 0; i < scene.coherent().size(); i += 7) {
        const Vec3d x = base::cast<double>(scene.coherent()[i]);
        const NaiveEvaluation value = naive.evaluate(x, Need::Value), all = naive.evaluate(x, Need::Hessian);
        const surface::Evaluationd e = scene.surface().evaluateReference(x, Need::Hessian);
        if (e.agreement < 0.95)
            continue; // the second pass for near sheets is ours alone
        QVERIFY(e.ok() && value.valid && all.valid);
        QVERIFY(std::abs(value.value - e.value) < 1e-12 && std::abs(all.value - e.value) < 1e-12);
        QVERIFY(near(value.centroid, e.centroid, 1e-12) && near(value.normal, e.normal, 1e-12));
        QVERIFY(near(all.gradient, e.gradient, 1e-10));
        QVERIFY(near(naive.evaluate(x, Need::Gradient).gradient, e.gradient, 1e-10));
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                QVERIFY2(std::abs(all.hessian.m[a][b] - e.hessian.m[a][b]) < 1e-7,
                         qPrintable(QString::number(all.hessian.m[a][b] - e.hessian.m[a][b])));
    }
}

void NaiveSurfaceTest::unevenSupportsAreFound() {
    surfel::SurfelList list = bench::bumpyPoints({3000, 0.02});
    base::Random random(test::seed());
    for (surfel::Surfel& s : list.items)
        s.support *= static_cast<float>(std::exp2(random.uniform(-1.5, 2.5)));
    Scene scene(surface::Surface(tree::SurfelTree::build(list), {}));
    int compared = 0;
    for (std::size_t i = 0; i < scene.coherent().size(); i += 7) {
        const Vec3d x = base::cast<double>(scene.coherent()[i]);
        const surface::Evaluationd e = scene.surface().evaluateReference(x, Need::Gradient);
        if (!e.ok() || e.agreement < 0.95)
            continue;
        const NaiveEvaluation value = scene.naive().evaluate(x, Need::Gradient);
        QVERIFY2(value.valid && std::abs(value.value - e.value) < 1e-11 && near(value.gradient, e.gradient, 1e-9),
                 qPrintable(QString("seed %1").arg(test::seed())));
        QVERIFY(std::abs(value.unit - e.unit) < 1e-11);
        ++compared;
    }
    QVERIFY2(compared > 100, qPrintable(QString::number(compared)));
}

void NaiveSurfaceTest::feetAreTheReferences() {
    Scene scene({3000, 0.02});
    for (const Projector projector : {Projector::Almost, Projector::Orthogonal}) {
        int ok = 0, all = 0;
        for (std::size_t i = 0; i < scene.coherent().size(); i += 11, ++all) {
            const Vec3d x = base::cast<double>(scene.coherent()[i]);
            Vec3d foot;
            const bool done = scene.naive().project(x, projector, 1e-9, foot);
            const auto expected = projectReference(scene.surface(), x, {projector});
            const double h = static_cast<double>(scene.surface().tree().maxSupport());
            ok += done && expected.ok() && near(foot, expected.foot, 1e-6 * h) ? 1 : 0;
        }
        QVERIFY2(ok > 0.99 * all, qPrintable(QString("%1 of %2").arg(ok).arg(all)));
    }
}

void NaiveSurfaceTest::otherDefinitionsAreRefused() {
    const Scene scene({500, 0});
    QVERIFY(NaiveSurface::speaks(scene.surface()));
    surface::SurfaceDefinition other = scene.surface().definition();
    other.frame = surface::Frame::Apss;
    QVERIFY(!NaiveSurface::speaks({scene.surface().tree(), other}));
    auto layout = std::make_shared<surfel::AttributeLayout>(*scene.surface().tree().layout());
    layout->oriented = false;
    const surface::Surface unoriented(scene.surface().tree().withLayout(layout), scene.surface().definition());
    QVERIFY(!NaiveSurface::speaks(unoriented));
}

static const test::Registered<NaiveSurfaceTest> registered;
#include "naive_surface_test.moc"
