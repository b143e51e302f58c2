// Real scans at full size: few rays, nearly all pixels right, and fewer still in the next view. The folder is
// POINTCLAY_DATA.
#include "core/process/estimation/prepare.h"
#include "raycast_models.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "surface/scans.h"

#include <QTest>

using namespace views;

class ScanCastTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void raysAreFewAndRight_data();
    void raysAreFewAndRight();
};

void ScanCastTest::raysAreFewAndRight_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("pixelsPerRay");
    QTest::newRow("bunny") << QString("bunny/bun_zipper.ply") << 16;
    QTest::newRow("dragon") << QString("dragon_res2.ply") << 8;
}

void ScanCastTest::raysAreFewAndRight() {
    if (test::sanitized)
        QSKIP("minutes under a sanitizer");
    QFETCH(QString, file);
    QFETCH(int, pixelsPerRay);
    surfel::SurfelList points;
    if (const char* why = scans::load(file, points))
        QSKIP(why);
    const Surface model = process::prepare(std::move(points), {});
    const ImageRays view = filling(centreOf(model), 0.72 * radiusOf(model), {0.3, -0.2, -1}, 1024);
    AdaptiveCast caster(model);
    const Cast first = once(caster, view, 1);
    const auto d = difference(first.samples, full(model, view));
    QVERIFY2(d.share() >= 0.995 && d.falseHits == 0, qPrintable(QString("%1 of %2").arg(d.passed).arg(d.hits)));
    QVERIFY(first.counts.rays * static_cast<std::size_t>(pixelsPerRay) <= first.counts.pixels);
    const Cast second = once(caster, turned(view, centreOf(model), {0, 1, 0}, 1), 1);
    QVERIFY(second.counts.rays * 4 <= first.counts.rays);
}

static const test::Registered<ScanCastTest> registered;
#include "scan_cast_test.moc"
