#include "core/sculpt/brush_curve.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/sculpt/falloff.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;

class BrushCurveTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void twoPointsMakeTheLineBitForBit();
    void curvesGoThroughTheirPointsAndNeverBeyondThem();
    void slopesAreTheDerivativesAndContinuous();
    void theCurveIsConstantBeyondItsEnds();
    void falloffsFollowTheCurveOutsideThePlateau();
    void whatIsNoCurveIsRefusedByName();
};

/// Rising x, any y.
static CurvePoints randomPoints(base::Random& random) {
    CurvePoints out;
    const std::size_t count = 2 + random.below(BrushCurve::maxPoints - 1);
    for (std::size_t i = 0; i < count; ++i)
        out.push_back({float((double(i) + random.uniform(0.1, 0.9)) / double(count)), float(random.uniform())});
    return out;
}

void BrushCurveTest::twoPointsMakeTheLineBitForBit() {
    const CurvePoint identity[] = {{0, 0}, {1, 1}}, full[] = {{0, 1}, {1, 1}}, fall[] = {{0, 1}, {1, 0}};
    for (int k = 0; k <= 1000; ++k) {
        const float x = float(k) / 1000;
        QCOMPARE(BrushCurve(identity).value(x), x);
        QCOMPARE(BrushCurve(full).value(x), 1.0f);
        QCOMPARE(BrushCurve(fall).value(x), weight(Falloff::Linear, x));
    }
}

void BrushCurveTest::curvesGoThroughTheirPointsAndNeverBeyondThem() {
    base::Random random(test::seed());
    for (int round = 0; round < 300; ++round) {
        const CurvePoints points = randomPoints(random);
        const BrushCurve curve(points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            QVERIFY(std::abs(curve.value(points[i].x) - points[i].y) < 1e-5f);
            if (i == 0)
                continue;
            const auto [low, high] = std::minmax(points[i - 1].y, points[i].y);
            float before = points[i - 1].y;
            for (int k = 1; k <= 50; ++k) {
                const float y = curve.value(points[i - 1].x + (points[i].x - points[i - 1].x) * float(k) / 50);
                QVERIFY2(y >= low - 1e-5f && y <= high + 1e-5f, qPrintable(QString("seed %1").arg(test::seed())));
                QVERIFY((y - before) * (points[i].y - points[i - 1].y) >= -1e-6f); // monotone
                before = y;
            }
        }
    }
}

void BrushCurveTest::slopesAreTheDerivativesAndContinuous() {
    base::Random random(test::seed());
    for (int round = 0; round < 300; ++round) {
        const CurvePoints points = randomPoints(random);
        const BrushCurve curve(points);
        const double e = 2e-4;
        for (int k = 0; k < 50; ++k) {
            const double x = random.uniform(double(points.front().x) + e, double(points.back().x) - e);
            const float lo = float(x - e), hi = float(x + e);
            const double difference = (double(curve.value(hi)) - double(curve.value(lo))) / (double(hi) - double(lo));
            // Curvature is bounded by slope over gap: 16 points lie at least 1/80 apart.
            QVERIFY2(std::abs(double(curve.slope(float(x))) - difference) < 0.02 * (1 + std::abs(difference)) + 0.7,
                     qPrintable(QString("%1, seed %2").arg(x).arg(test::seed())));
        }
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            const float x = points[i].x;
            QVERIFY(std::abs(curve.slope(std::nextafter(x, 0.0f)) - curve.slope(x)) <
                    1e-3f * (1 + std::abs(curve.slope(x))));
        }
    }
    // A quadratic-like curve, where the difference quotient is good to 1e-3.
    const CurvePoint wide[] = {{0, 1}, {0.5f, 0.75f}, {1, 0}};
    const BrushCurve curve(wide);
    for (int k = 1; k < 100; ++k) {
        const double x = k / 100.0, e = 1e-3;
        const double difference = (double(curve.value(float(x + e))) - double(curve.value(float(x - e)))) /
                                  (double(float(x + e)) - double(float(x - e)));
        QVERIFY(std::abs(double(curve.slope(float(x))) - difference) < 4e-3);
    }
}

void BrushCurveTest::theCurveIsConstantBeyondItsEnds() {
    const CurvePoint points[] = {{0.25f, 0.9f}, {0.5f, 0.2f}, {0.75f, 0.4f}};
    const BrushCurve curve(points);
    QCOMPARE(curve.value(0), 0.9f);
    QCOMPARE(curve.value(1), 0.4f);
    QCOMPARE(curve.slope(0.1f), 0.0f);
    QCOMPARE(curve.slope(0.9f), 0.0f);
}

void BrushCurveTest::falloffsFollowTheCurveOutsideThePlateau() {
    const CurvePoint points[] = {{0, 1}, {0.3f, 0.8f}, {0.6f, 0.1f}, {1, 0}};
    const BrushCurve curve(points);
    const float r[] = {0, 0.1f, 0.4f, 0.7f, 0.99f, 1, 2};
    float w[7], s[7];
    weights(Falloff::Custom, 0.25f, r, w, s, &curve);
    for (int k = 0; k < 7; ++k) {
        const float t = (r[k] - 0.25f) / 0.75f;
        QVERIFY(std::abs(w[k] - (r[k] >= 1 ? 0 : t <= 0 ? 1 : curve.value(t))) < 1e-6f);
        QVERIFY(std::abs(s[k] - (r[k] >= 1 || t <= 0 ? 0 : curve.slope(t) / 0.75f)) < 1e-5f);
    }
}

void BrushCurveTest::whatIsNoCurveIsRefusedByName() {
    const auto refused = [](const CurvePoints& points) {
        try {
            BrushCurve curve(points, "pressure-radius");
        } catch (const base::Error& error) {
            return error.message().find("pressure-radius") != std::string::npos;
        }
        return false;
    };
    QVERIFY(refused({}));
    QVERIFY(refused({{0, 0}}));
    QVERIFY(refused({{0, 0}, {0, 1}}));
    QVERIFY(refused({{0.5f, 0}, {0.2f, 1}}));
    QVERIFY(refused({{0, 0}, {1, 1.5f}}));
    QVERIFY(refused({{0, std::nanf("")}, {1, 1}}));
    QVERIFY(refused(CurvePoints(17, {0.5f, 0.5f})));
}

static const test::Registered<BrushCurveTest> registered;
#include "brush_curve_test.moc"
