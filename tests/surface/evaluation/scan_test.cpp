// Real scans against brute force in both precisions. The folder is POINTCLAY_DATA.
#include "core/process/estimation/prepare.h"
#include "core/surface/projection/project.h"
#include "support/registry.h"
#include "surface/projection/brute_feet.h"
#include "surface/scans.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;

class ScanTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void precisionsAgreeWithBruteForce_data();
    void precisionsAgreeWithBruteForce();
};

void ScanTest::precisionsAgreeWithBruteForce_data() {
    QTest::addColumn<QString>("file");
    for (const char* file : {"bunny/bun_zipper.ply", "dragon_res2.ply", "kitten.xyz"})
        QTest::addRow("%s", file) << QString(file);
}

void ScanTest::precisionsAgreeWithBruteForce() {
    QFETCH(QString, file);
    surfel::SurfelList points;
    if (const char* why = scans::load(file, points))
        QSKIP(why);
    process::PrepareOptions options;
    options.definition.boundary = Boundary::None;
    const Surface surface = process::prepare(std::move(points), options);
    const surfel::SurfelList list = surface.tree().surfels();
    const brute::Model all = brute::modelOf(list, surface.definition());
    const double most = double(surface.tree().maxSupport());
    base::Random random(test::seed());
    int compared = 0, projected = 0;
    double worstFoot = 0;
    for (int i = 0; i < 120; ++i) {
        const surfel::Surfel& near = list.items[random.below(list.size())];
        const Vec3f x = near.position + base::cast<float>(random.unitVector() * (0.2 * double(near.support)));
        const Evaluationd d = surface.evaluateReference(base::cast<double>(x));
        // No more can reach x or its foot; the whole scan for each step of a projection takes a minute.
        const brute::Model local = brute::near(all, base::cast<double>(x), 1.2 * most + 2 * double(near.support));
        const brute::Answer b = brute::evaluate(local, base::cast<double>(x));
        const Evaluationf f = surface.evaluate(x);
        if (!d.ok() || !f.ok())
            continue;
        ++compared;
        const QString where = QString("round %1, seed %2").arg(i).arg(test::seed());
        QVERIFY2(std::abs(d.value - b.f) <= 1e-9 * b.unit && distance(d.gradient, b.g) <= 1e-9, qPrintable(where));
        QVERIFY2(std::abs(double(f.value) - b.f) <= 2e-5 * b.unit, qPrintable(where));
        QVERIFY2(distance(base::cast<double>(f.gradient), b.g) <= 2e-4, qPrintable(where));
        const Projection<double> p = projectReference(surface, base::cast<double>(x));
        const Projection<float> q = project(surface, x);
        Vec3d foot;
        if (!p.ok() || !q.ok() || d.agreement < 0.9 ||
            !brute::project(local, base::cast<double>(x), Projector::Orthogonal, foot))
            continue;
        ++projected;
        QVERIFY2(distance(p.foot, foot) <= 1e-9 * b.unit, qPrintable(where));
        worstFoot = std::max(worstFoot, distance(base::cast<double>(q.foot), foot) / b.unit);
        QVERIFY2(worstFoot <= 2e-5, qPrintable(where + QString(": %1 h").arg(worstFoot)));
    }
    QVERIFY2(compared > 100 && projected > 80, qPrintable(QString("%1, %2").arg(compared).arg(projected)));
}

static const test::Registered<ScanTest> registered;
#include "scan_test.moc"
