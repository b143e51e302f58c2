#include "core/sculpt/falloff.h"

#include "core/base/error.h"
#include "support/registry.h"

#include <cmath>
#include <QTest>

using namespace sculpt;

class FalloffTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void curvesRunFromOneToTheirRimWithoutRising();
    void slopesAreTheDerivatives();
    void smoothIsFlatAtBothEnds();
    void batchGivesTheRowsCurves();
    void plateauIsFlatAndTheRestIsTheCurve();
    void unknownNamesAreRefusedWithTheKnownOnes();
};

void FalloffTest::curvesRunFromOneToTheirRimWithoutRising() {
    for (const FalloffRow& row : falloffTable()) {
        QCOMPARE(row.weight(0), 1.0f);
        if (row.value != Falloff::Constant)
            QCOMPARE(row.weight(1), 0.0f);
        for (int k = 1; k <= 1000; ++k)
            QVERIFY(row.weight(k / 1000.0f) <= row.weight((k - 1) / 1000.0f));
        QCOMPARE(weight(row.value, 1.0f), 0.0f);
        QCOMPARE(weight(row.value, 7.0f), 0.0f);
        QCOMPARE(falloff(row.id), row.value);
    }
}

void FalloffTest::slopesAreTheDerivatives() {
    for (const FalloffRow& row : falloffTable())
        for (int k = 1; k < 95; ++k) {
            const double r = k / 100.0, e = 1e-3;
            const double difference = (double(row.weight(float(r + e))) - double(row.weight(float(r - e)))) /
                                      (double(float(r + e)) - double(float(r - e)));
            QVERIFY2(std::abs(double(row.slope(float(r))) - difference) < 2e-3, row.id);
        }
}

void FalloffTest::smoothIsFlatAtBothEnds() {
    QCOMPARE(row(Falloff::Smooth).slope(0), 0.0f);
    QCOMPARE(row(Falloff::Smooth).slope(1), 0.0f);
}

void FalloffTest::batchGivesTheRowsCurves() {
    std::vector<float> r, w(120), s(120);
    for (int k = 0; k < 120; ++k)
        r.push_back(k / 100.0f);
    for (const FalloffRow& row : falloffTable()) {
        weights(row.value, 0, r, w, s);
        for (std::size_t k = 0; k < r.size(); ++k) {
            QCOMPARE(w[k], weight(row.value, r[k]));
            QCOMPARE(s[k], r[k] > 0 && r[k] < 1 ? row.slope(r[k]) : 0.0f);
        }
    }
}

void FalloffTest::plateauIsFlatAndTheRestIsTheCurve() {
    const float p = 0.25f;
    const std::vector<float> r{0.0f, 0.2f, 0.25f, 0.5f, 0.75f, 0.9f, 1.0f, 2.0f};
    std::vector<float> w(r.size()), s(r.size());
    for (const FalloffRow& row : falloffTable()) {
        weights(row.value, p, r, w, s);
        for (std::size_t k = 0; k < r.size(); ++k) {
            const float t = (r[k] - p) / (1 - p);
            QVERIFY(std::abs(w[k] - (r[k] >= 1 ? 0 : t <= 0 ? 1 : row.weight(t))) < 1e-5f);
            if (t <= 0)
                QCOMPARE(s[k], 0.0f);
            else if (r[k] < 1)
                QVERIFY(std::abs(s[k] - row.slope(t) / (1 - p)) < 1e-3f);
        }
    }
}

void FalloffTest::unknownNamesAreRefusedWithTheKnownOnes() {
    try {
        falloff("cubist");
        QFAIL("accepted");
    } catch (const base::Error& e) {
        QVERIFY(e.message().find("cubist") != std::string::npos);
        QVERIFY(e.message().find("smooth") != std::string::npos);
    }
}

static const test::Registered<FalloffTest> registered;
#include "falloff_test.moc"
