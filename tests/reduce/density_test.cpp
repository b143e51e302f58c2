// Where samples go: to where a first set errs more than elsewhere, and nowhere else.
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/reduce/coverage.h"
#include "core/reduce/density.h"
#include "core/reduce/density_by_result.h"
#include "core/reduce/fit.h"
#include "core/reduce/placement.h"
#include "reduce/reduced_models.h"
#include "support/registry.h"

#include <numeric>
#include <QTest>

using namespace reduce;

class DensityTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatErrsGetsMoreSamples();
};

/// A sphere and a first set on it, tilted at random from z = 0 upwards.
static void tiltUpperHalf(Sites& sites) {
    base::Random random(test::seed());
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (sites.position[i].z > 0)
            sites.normal[i] = normalized(sites.normal[i] + base::cast<float>(random.unitVector() * 0.25));
}

void DensityTest::whatErrsGetsMoreSamples() {
    constexpr std::size_t count = 400;
    Dense dense = denseOf(test::sphere(6000).surface, 1);
    const NumberedTree tree(dense.places.position, dense.places.normal, {});
    measureAreas(dense.places, tree);
    const std::vector<float> even = sharesByError(dense.places, tree, count);
    Sites sites = place(dense.surface, dense.places, tree, even, count);
    cover(dense.places, supportsOver, sites);
    fit(dense.places, sites);
    tiltUpperHalf(sites);
    const int threads = base::threadCount();
    base::setThreadCount(1);
    const std::vector<float> anew = sharesByResult(dense.places, sites, even, count, {}, true);
    base::setThreadCount(3);
    QVERIFY(sharesByResult(dense.places, sites, even, count, {}, true) == anew);
    base::setThreadCount(threads);
    QVERIFY(std::abs(std::accumulate(anew.begin(), anew.end(), 0.0) / double(count) - 1) < 0.01);
    double upper = 0, lower = 0, upperBefore = 0, lowerBefore = 0;
    for (std::size_t i = 0; i < anew.size(); ++i) {
        const float z = dense.places.position[i].z;
        (z > 0.3f ? upper : lower) += z > 0.3f || z < -0.3f ? double(anew[i]) : 0;
        (z > 0.3f ? upperBefore : lowerBefore) += z > 0.3f || z < -0.3f ? double(even[i]) : 0;
    }
    const QByteArray told =
        QString("%1 : %2, before %3 : %4").arg(upper).arg(lower).arg(upperBefore).arg(lowerBefore).toUtf8();
    qInfo("%s", told.constData());
    QVERIFY2(upper > 1.5 * lower && upperBefore < 1.1 * lowerBefore, told);
}

static const test::Registered<DensityTest> registered;
#include "density_test.moc"
