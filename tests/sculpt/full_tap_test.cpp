// A tap of the window (StrokeSettings::fullTap) leaves as much as a stroke that goes over its place.
#include "core/sculpt/contact.h"
#include "sculpt/stroke_samples.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;

class FullTapTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void initTestCase();
    void tapsAreAsHighAsStrokes();
    void tremblingTapsAreTaps();
    void anchoredStampsAreAsHighAsStrokes();
    void withoutFullTapNothingIsAdded();

  private:
    surface::Surface m_plane, m_sphere;
};

using test::down, test::settingsOf;

void FullTapTest::initTestCase() {
    m_plane = test::surfaceOf(test::planePoints(80, 0.02));
    m_sphere = test::surfaceOf(test::spherePoints(3000));
}

/// Above the plane, in the middle of a stroke across it.
static float heightOf(const surface::Surface& surface) {
    const auto there = contact(surface, down(0, 0).ray);
    return there ? there->position.z : 0;
}

void FullTapTest::tapsAreAsHighAsStrokes() {
    for (const Falloff falloff : {Falloff::Smooth, Falloff::Sharp})
        for (const float spacing : {0.05f, 0.25f})
            for (const float strength : {0.2f, 1.0f}) {
                StrokeSettings settings = settingsOf("draw", 0.25f);
                settings.falloff = falloff, settings.spacing = spacing, settings.strength = strength;
                settings.fullTap = true;
                const float stroke = heightOf(test::stroked(m_plane, settings, {down(-0.5f, 0), down(0.5f, 0, 1)}));
                const float tap = heightOf(test::stroked(m_plane, settings, {down(0, 0)}));
                const QString told = QString("%1: %2 for %3").arg(row(falloff).id).arg(tap).arg(stroke);
                // Half a radius high, a stroke climbs its own front and comes out higher.
                const float most = strength > 0.5f ? 0.25f : 0.12f;
                QVERIFY2(stroke > 0 && std::abs(tap / stroke - 1) < most, qPrintable(told));
            }
}

void FullTapTest::tremblingTapsAreTaps() {
    StrokeSettings settings = settingsOf("draw", 0.25f);
    settings.fullTap = true;
    const float tap = heightOf(test::stroked(m_plane, settings, {down(0, 0)}));
    float before = tap;
    for (const float reach : {0.01f, 0.02f, 0.03f, 0.04f, 0.05f, 0.06f}) { // up to a quarter of the radius
        const float now = heightOf(test::stroked(m_plane, settings, {down(0, 0), down(reach, 0, 0.1f)}));
        QVERIFY2(now <= 1.05f * before && now > 0.1f * tap, qPrintable(QString("%1 at %2").arg(now).arg(reach)));
        before = now;
    }
    QVERIFY(before < 0.75f * tap); // and a stroke is a stroke
}

void FullTapTest::anchoredStampsAreAsHighAsStrokes() {
    StrokeSettings settings = settingsOf("draw", 0.25f, StrokeMethod::Anchored);
    settings.fullTap = true;
    const float stamp = heightOf(test::stroked(m_plane, settings, {down(0, 0), down(0.25f, 0, 1)}));
    settings.method = StrokeMethod::Space;
    const float stroke = heightOf(test::stroked(m_plane, settings, {down(-0.5f, 0), down(0.5f, 0, 1)}));
    QVERIFY2(std::abs(stamp / stroke - 1) < 0.12f, qPrintable(QString("%1 for %2").arg(stamp).arg(stroke)));
}

void FullTapTest::withoutFullTapNothingIsAdded() {
    for (const ToolRow& each : toolTable()) {
        if (each.needs.source)
            continue;
        StrokeSettings settings = settingsOf(each.id, 0.2f);
        Stroke plain(m_sphere, settings);
        plain.add(down(0, 0));
        QVERIFY2(plain.dabs() <= 1, each.id);
        plain.finish();
        QVERIFY2(plain.dabs() <= 1, each.id);
        settings.fullTap = true; // and a stroke that goes on is the same with it
        const std::vector<StrokeSample> way{down(-0.3f, 0), down(0.3f, 0.1f, 1)};
        const auto full = test::hashOf(test::stroked(m_sphere, settings, way));
        settings.fullTap = false;
        QVERIFY2(full == test::hashOf(test::stroked(m_sphere, settings, way)), each.id);
    }
}

static const test::Registered<FullTapTest> registered;
#include "full_tap_test.moc"
