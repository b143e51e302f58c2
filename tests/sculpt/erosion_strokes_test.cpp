// Strokes along a relief leave it as it was: resampling under the brush wears nothing off.
#include "process/relief.h"
#include "sculpt/stroke_samples.h"
#include "support/registry.h"

#include <QTest>

using test::Relief;

class ErosionStrokesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void grabsOutAndBackLeaveRelief_data();
    void grabsOutAndBackLeaveRelief();
};

/// Along the waves: samples are pulled together and apart, their surface stays what it was.
static surface::Surface grabbed(const surface::Surface& start, float by) {
    constexpr auto s = float(Relief::spacing);
    const float from = by > 0 ? 0 : -by;
    std::vector<sculpt::StrokeSample> samples;
    for (int k = 0; k <= 8; ++k)
        samples.push_back(test::down(0, from + by * float(k) / 8));
    return test::stroked(start, test::settingsOf("grab", 10 * s), samples);
}

void ErosionStrokesTest::grabsOutAndBackLeaveRelief_data() {
    QTest::addColumn<double>("wavelength");
    QTest::addColumn<double>("least");
    QTest::newRow("6 spacings") << 6.0 << 0.95;
    QTest::newRow("10 spacings") << 10.0 << 0.98;
}

void ErosionStrokesTest::grabsOutAndBackLeaveRelief() {
    QFETCH(double, wavelength);
    QFETCH(double, least);
    const Relief relief(wavelength);
    surface::Surface now = relief.surface(60);
    constexpr double half = 8 * Relief::spacing;
    const double before = relief.leftIn(now, half);
    for (int k = 0; k < 50; ++k)
        for (const float by : {4.0f, -4.0f})
            now = grabbed(now, by * float(Relief::spacing));
    const double left = relief.leftIn(now, half) / before;
    const QByteArray told = QString("%1 of it left, %2 surfels").arg(left).arg(now.tree().size()).toUtf8();
    qInfo("%s", told.constData());
    QVERIFY2(left >= least && left < 1.02, told);
}

static const test::Registered<ErosionStrokesTest> registered;
#include "erosion_strokes_test.moc"
