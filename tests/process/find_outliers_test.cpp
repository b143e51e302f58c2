// Strays go, and what is the model stays: dense and sparse, at borders and corners, whatever the way to tell.
#include "core/base/random.h"
#include "core/process/cleaning/find_outliers.h"
#include "core/process/estimation/spacing.h"
#include "process/uneven_sphere.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <numbers>
#include <QTest>

using namespace process;
using base::Vec3d;

class FindOutliersTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void unevenModelsLoseNothing_data();
    void unevenModelsLoseNothing();
    void straysAreFound_data();
    void straysAreFound();
    void aSixthInStraysIsFound();
    void noisySparseBodiesAreNoOutliers();
    void sparsePatchesAreNoOutliers();
    void smallPiecesApartAreIslands();
    void whatStandsOffASheetIsOffItsSurface();
    void noiseIsNotOffTheSurface();
    void threadsDoNotShow();
    void cancelStops();
    void tooFewPointsHaveNone();
};

using shapes::at, shapes::unevenSphere;

namespace {

/// A sheet with corners, random.
surfel::SurfelList sheet(std::size_t count, base::Random& random) {
    surfel::SurfelList out;
    while (out.size() < count) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        out.items.push_back(at({x, y, 0.2 * std::sin(3 * x) * std::cos(2 * y)}));
    }
    return out;
}

/// A ball whose points are drawn by chance, with noise of a part of their spacing.
void addBall(surfel::SurfelList& list, std::size_t count, const Vec3d& centre, double radius, double noise,
             base::Random& random) {
    const double spacing = radius * std::sqrt(4 * std::numbers::pi / double(count));
    for (std::size_t k = 0; k < count; ++k)
        list.items.push_back(at(centre + random.unitVector() * (radius + noise * spacing * random.normal())));
}

/// Of the points from `from` to `to`.
std::size_t foundAmong(const surfel::SurfelList& points, const OutlierQuestion& question, std::size_t from,
                       std::size_t to) {
    const Cloud cloud(points.items);
    const std::vector<std::uint8_t> found = findOutliers(cloud, question);
    std::size_t out = 0;
    for (std::size_t i = from; i < to; ++i)
        out += found[cloud.places()[i]];
    return out;
}

void eachWay() {
    QTest::addColumn<int>("way");
    QTest::newRow("statistical") << int(OutlierWay::Statistical);
    QTest::newRow("radius") << int(OutlierWay::Radius);
    QTest::newRow("islands") << int(OutlierWay::Islands);
    QTest::newRow("surface") << int(OutlierWay::Surface);
}

QByteArray told(std::size_t count) {
    return QByteArray::number(qulonglong(count)) + ", seed " + QByteArray::number(test::seed());
}

} // namespace

void FindOutliersTest::unevenModelsLoseNothing_data() {
    eachWay();
}

void FindOutliersTest::unevenModelsLoseNothing() {
    QFETCH(int, way);
    base::Random random(test::seed());
    const std::size_t n = test::effort(20000);
    for (const surfel::SurfelList& model : {unevenSphere(n, random), sheet(n, random)}) {
        const std::size_t lost = foundAmong(model, {OutlierWay(way), {}}, 0, model.size());
        QVERIFY2(lost <= n / 1000, told(lost)); // chance leaves a few points alone
    }
}

void FindOutliersTest::straysAreFound_data() {
    eachWay();
}

/// Far strays, one by one, all around a model whose density varies by 1 : 20.
void FindOutliersTest::straysAreFound() {
    QFETCH(int, way);
    base::Random random(test::seed());
    surfel::SurfelList model = unevenSphere(test::effort(20000), random);
    const std::size_t own = model.size(), strays = own / 100;
    for (std::size_t k = 0; k < strays; ++k) {
        Vec3d d = random.unitVector();
        d.z = -std::abs(d.z); // where the model is dense
        model.items.push_back(at(d * random.uniform(1.2, 2.5)));
    }
    const std::size_t found = foundAmong(model, {OutlierWay(way), {}}, own, model.size());
    QVERIFY2(found >= strays * 9 / 10, told(found));
    const std::size_t lost = foundAmong(model, {OutlierWay(way), {}}, 0, own);
    QVERIFY2(lost <= own / 500, told(lost));
}

/// So many strays that they hang together, as sparse parts of a model do.
void FindOutliersTest::aSixthInStraysIsFound() {
    base::Random random(test::seed());
    surfel::SurfelList list;
    constexpr std::size_t own = 8000;
    addBall(list, own, {}, 1, 0.2, random);
    for (std::size_t k = 0; k < own / 5; ++k) {
        Vec3d p;
        do
            p = Vec3d{random.uniform(-1.6, 1.6), random.uniform(-1.6, 1.6), random.uniform(-1.6, 1.6)};
        while (std::abs(length(p) - 1) < 0.1);
        list.items.push_back(at(p));
    }
    const std::size_t found = foundAmong(list, {}, own, list.size());
    QVERIFY2(found > own / 5 * 93 / 100, told(found));
    QVERIFY(foundAmong(list, {}, 0, own) <= own / 500);
}

/// Two and a half times as coarse, and noisy: it fills space better than a surface does, but not as strays do.
void FindOutliersTest::noisySparseBodiesAreNoOutliers() {
    base::Random random(test::seed());
    for (const double noise : {0.0, 0.35, 0.55})
        for (const double away : {3.05, 2.8, 0.0}) { // beside, touching, and a small one within
            surfel::SurfelList list;
            addBall(list, test::sanitized ? 2400 : 12000, {}, 1, noise, random);
            const std::size_t count = list.size() / 8 + random.below(list.size() / 8);
            addBall(list, count, {away, 0, 0}, away > 0 ? 2 : 0.8, noise, random);
            const std::size_t lost = foundAmong(list, {}, 0, list.size());
            QVERIFY2(lost <= list.size() / 150, told(lost) + ", noise " + QByteArray::number(noise));
        }
}

/// Round holes of a dense sphere, filled with a ninth of its density: no way to tell may call these strays.
void FindOutliersTest::sparsePatchesAreNoOutliers() {
    base::Random random(test::seed());
    std::vector<Vec3d> holes;
    for (int k = 0; k < 6; ++k)
        holes.push_back(random.unitVector());
    surfel::SurfelList list;
    while (list.size() < std::size_t(test::effort(20000))) {
        const Vec3d d = random.unitVector();
        const auto holds = [&](const Vec3d& c) { return dot(c, d) > 0.97; };
        if (std::none_of(holes.begin(), holes.end(), holds) || random.uniform() < 0.11)
            list.items.push_back(at(d));
    }
    for (const OutlierWay way :
         {OutlierWay::Statistical, OutlierWay::Radius, OutlierWay::Islands, OutlierWay::Surface}) {
        const std::size_t lost = foundAmong(list, {way, {}}, 0, list.size());
        QVERIFY2(lost <= list.size() / 1000, told(lost));
    }
}

void FindOutliersTest::smallPiecesApartAreIslands() {
    base::Random random(test::seed());
    surfel::SurfelList list = sheet(10000, random);
    const std::size_t own = list.size();
    for (int k = 0; k < 60; ++k) // a crumb as dense as the sheet, above it
        list.items.push_back(at(Vec3d{0.3, 0.2, 0.7} + random.unitVector() * 0.05));
    QCOMPARE(foundAmong(list, {OutlierWay::Islands, {}}, own, list.size()), std::size_t(60));
    QVERIFY(foundAmong(list, {OutlierWay::Islands, {}}, 0, own) < 10);
    QCOMPARE(foundAmong(list, {OutlierWay::Islands, 50}, own, list.size()), std::size_t(0)); // it may be that large
}

/// Half a spacing off a smooth sheet is no place for one of its points; neighbours know.
void FindOutliersTest::whatStandsOffASheetIsOffItsSurface() {
    base::Random random(test::seed());
    surfel::SurfelList list = sheet(10000, random);
    const float s = summarise(spacings(list.items)).median;
    const std::size_t own = list.size();
    for (std::size_t k = 0; k < 200; ++k) {
        surfel::Surfel stray = list.items[k * 50];
        stray.position.z += (k % 2 ? 1.0f : -1.0f) * s * float(random.uniform(0.8, 3));
        list.items.push_back(stray);
    }
    const std::size_t found = foundAmong(list, {OutlierWay::Surface, {}}, own, list.size());
    QVERIFY2(found >= 195, told(found));
    const std::size_t lost = foundAmong(list, {OutlierWay::Surface, {}}, 0, own);
    QVERIFY2(lost <= 10, told(lost));
}

void FindOutliersTest::noiseIsNotOffTheSurface() {
    base::Random random(test::seed());
    surfel::SurfelList list = sheet(10000, random);
    const float s = summarise(spacings(list.items)).median;
    for (surfel::Surfel& each : list.items)
        each.position.z += 0.4f * s * float(random.normal());
    const std::size_t lost = foundAmong(list, {OutlierWay::Surface, {}}, 0, list.size());
    QVERIFY2(lost <= 50, told(lost)); // 4 standard deviations, estimated from 16
}

void FindOutliersTest::threadsDoNotShow() {
    base::Random random(test::seed());
    const surfel::SurfelList list = unevenSphere(test::effort(10000), random);
    for (const OutlierWay way :
         {OutlierWay::Statistical, OutlierWay::Radius, OutlierWay::Islands, OutlierWay::Surface}) {
        base::setThreadCount(1);
        const auto one = findOutliers(Cloud(list.items), {way, {}});
        base::setThreadCount(2);
        QVERIFY(findOutliers(Cloud(list.items), {way, {}}) == one);
        base::setThreadCount(0);
    }
}

void FindOutliersTest::cancelStops() {
    base::Random random(test::seed());
    const surfel::SurfelList list = unevenSphere(5000, random);
    const Cloud cloud(list.items);
    const std::atomic<bool> cancel = true;
    for (const OutlierWay way : {OutlierWay::Statistical, OutlierWay::Radius, OutlierWay::Islands, OutlierWay::Surface})
        QVERIFY_EXCEPTION_THROWN(findOutliers(cloud, {way, {}}, {{}, &cancel}), base::Cancelled);
}

void FindOutliersTest::tooFewPointsHaveNone() {
    surfel::SurfelList list;
    for (int k = 0; k < 5; ++k)
        list.items.push_back(at({double(k * k), 0, 0}));
    for (const OutlierWay way : {OutlierWay::Statistical, OutlierWay::Radius, OutlierWay::Islands, OutlierWay::Surface})
        QCOMPARE(foundAmong(list, {way, {}}, 0, list.size()), std::size_t(0));
}

static const test::Registered<FindOutliersTest> registered;
#include "find_outliers_test.moc"
