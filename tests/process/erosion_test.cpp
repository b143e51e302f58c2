// Resampling again and again wears nothing off: what the fit of new samples to the surface before is for.
#include "core/base/parallel.h"
#include "core/process/resampling/resample.h"
#include "core/process/resampling/resample_fit.h"
#include "process/relief.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using namespace process;
using test::Relief;

class ErosionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void reliefKeepsItsHeight_data();
    void reliefKeepsItsHeight();
    void noiseIsNotMadeRougher();
    void theFitTakesNothingAway();
    void bordersAndMaskedSurfelsStay();
    void sameBitsAtAnyThreadCount();
};

static surface::Surface inTurns(surface::Surface now, int rounds, Fit fit) {
    for (int round = 0; round < rounds; ++round)
        now = resampleAll(now, float(Relief::spacing * (round % 2 ? 0.95 : 1.05)), 12, {}, fit).surface;
    return now;
}

void ErosionTest::reliefKeepsItsHeight_data() {
    QTest::addColumn<double>("wavelength");
    QTest::addColumn<int>("rounds");
    QTest::addColumn<double>("least");
    QTest::newRow("6 spacings") << 6.0 << 20 << 0.98;
    if (test::sanitized) // seconds a row there
        return;
    QTest::newRow("10 spacings") << 10.0 << 20 << 0.995;
    QTest::newRow("6 spacings, again and again") << 6.0 << test::effort(200) << 0.97;
    QTest::newRow("10 spacings, again and again") << 10.0 << test::effort(200) << 0.99;
}

void ErosionTest::reliefKeepsItsHeight() {
    QFETCH(double, wavelength);
    QFETCH(int, rounds);
    QFETCH(double, least);
    const Relief relief(wavelength);
    const surface::Surface start = relief.surface(44);
    constexpr double half = 10 * Relief::spacing;
    const double before = relief.leftIn(start, half);
    const double left = relief.leftIn(inTurns(start, rounds, Fit::On), half) / before;
    const QByteArray told = QString("%1 of it left").arg(left).toUtf8();
    qInfo("%s", told.constData());
    QVERIFY2(left >= least && left < 2 - least, told);
    if (rounds == 20) {
        const double without = relief.leftIn(inTurns(start, rounds, Fit::Off), half) / before;
        QVERIFY2(1 - without > 10 * std::abs(1 - left), qPrintable(QString::number(without)));
    }
}

/// Distances from the unit sphere of places all over a surface, rms.
static double roughness(const surface::Surface& surface) {
    base::Random random(3);
    double sum = 0;
    int count = 0;
    for (int k = 0; k < 2000; ++k) {
        const auto foot = surface::project(surface, base::cast<float>(random.unitVector()), {});
        if (!foot.ok())
            continue;
        const double off = double(length(foot.foot)) - 1;
        sum += off * off, ++count;
    }
    return std::sqrt(sum / count);
}

void ErosionTest::noiseIsNotMadeRougher() {
    constexpr std::size_t count = 4000;
    const double s = test::sphereSpacing(count);
    base::Random random(test::seed());
    const surface::Surface noisy = test::changed(test::surfaceOf(test::spherePoints(count)), [&](surfel::Surfel& each) {
        each.position *= float(1 + 0.15 * s * random.normal());
        each.normal = base::cast<float>(
            normalized(base::cast<double>(each.normal) + random.unitVector() * (0.2 * random.uniform())));
    });
    const double before = roughness(noisy);
    for (const double factor : {0.8, 1.2, 2.0}) {
        const auto after = [&](Fit fit) {
            return roughness(resampleAll(noisy, float(factor * s), 12, {}, fit).surface);
        };
        const double on = after(Fit::On), off = after(Fit::Off);
        const QByteArray told = QString("%1: %2 s became %3, without the fit %4")
                                    .arg(factor)
                                    .arg(before / s)
                                    .arg(on / s)
                                    .arg(off / s)
                                    .toUtf8();
        qInfo("%s", told.constData());
        QVERIFY2(on < 1.1 * std::max(before, off), told);
    }
}

void ErosionTest::theFitTakesNothingAway() {
    const surface::Surface start = Relief(8).surface(24);
    ResampleOptions options;
    options.spacing = float(0.6 * Relief::spacing);
    const auto after = [&](int fitRounds) {
        options.fitRounds = fitRounds;
        const tree::SurfelTree tree = start.tree().apply(resample(start, selectAll(start.tree()), options));
        tree.validate();
        return tree;
    };
    const tree::SurfelTree on = after(2), off = after(0);
    QVERIFY(on.contentHash() != off.contentHash());
    QCOMPARE(on.size(), off.size()); // the fit moves along normals, and takes nothing away
}

void ErosionTest::bordersAndMaskedSurfelsStay() {
    const Relief relief(8);
    const surface::Surface start =
        test::changed(relief.surface(40), [](surfel::Surfel& each) { each.mask = each.position.x < -0.1f ? 1 : 0; });
    // Other supports for all: everything has another surface now.
    const surface::Surface wider = test::changed(start, [](surfel::Surfel& each) { each.support *= 1.15f; });
    const tree::SurfelTree after =
        fitted(wider.tree(), start, [](const base::Vec3f&) { return float(Relief::spacing); });
    const auto before = wider.tree().surfels().items, now = after.surfels().items;
    QCOMPARE(before.size(), now.size());
    std::size_t moved = 0, stayed = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const bool same = now[i].position == before[i].position && now[i].normal == before[i].normal;
        const auto at = start.evaluate(before[i].position, surface::Need::Value);
        if (before[i].mask >= 1 || at.offCentre > 0.13f * at.unit) {
            QVERIFY(same);
            ++stayed;
        } else if (!same) {
            ++moved;
            QVERIFY(distance(now[i].position, before[i].position) <= 0.2501f * float(Relief::spacing));
        }
    }
    QVERIFY(moved > 300 && stayed > 200);
}

void ErosionTest::sameBitsAtAnyThreadCount() {
    const surface::Surface start = Relief(7).surface(40);
    const int threads = base::threadCount();
    std::string hash[2];
    for (const int k : {0, 1}) {
        base::setThreadCount(1 + 2 * k);
        hash[k] = resampleAll(start, float(0.9 * Relief::spacing), 4).surface.tree().contentHash().text();
    }
    base::setThreadCount(threads);
    QCOMPARE(hash[0], hash[1]);
}

static const test::Registered<ErosionTest> registered;
#include "erosion_test.moc"
