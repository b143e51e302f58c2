// Evaluation of many positions in lanes, against the reference and against single evaluations.
#include "core/surface/definition_text.h"
#include "core/surface/evaluation/together.h"
#include "support/registry.h"
#include "support/threads.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;
using shapes::sameBits;

class TogetherTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void allNumbersFollowTheReference_data();
    void allNumbersFollowTheReference();
    void otherFramesFollowTheReferenceToo();
    void anyCompanyGivesTheSameBits();
    void scatteredAndRepeatedPositionsGiveTheSameBits();
    void placesWithoutSurfaceSaySo();
    void threadsDoNotChangeBits();
};

namespace {

Surface bumpyTorus(Weight weight = Weight::Wendland, bool shrinkFree = true, Frame frame = Frame::Normals) {
    const double support = weight == Weight::Gaussian ? 0.35 : 0.21;
    surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.06, support), 0.01, test::seed());
    base::Random random(test::seed());
    for (surfel::Surfel& s : list.items)
        s.support *= static_cast<float>(random.uniform(0.9, 1.1));
    return shapes::surfaceOf(list, shapes::definitionOf(frame, shrinkFree, weight));
}

/// Places about the surfels in their order, and their normals.
struct Places {
    std::vector<Vec3f> x, side;
    explicit Places(const Surface& surface, double away = 0.03) {
        base::Random random(test::seed() + 1);
        for (const surfel::Surfel& s : surface.tree().surfels().items) {
            x.push_back(s.position + base::cast<float>(random.unitVector() * random.uniform(0, away)));
            side.push_back(s.normal);
        }
    }
};

std::vector<TogetherAt> evaluated(const Surface& surface, std::span<const Vec3f> x, std::span<const Vec3f> side) {
    std::vector<TogetherAt> out(x.size());
    evaluateTogether(surface, x, side, out);
    return out;
}

bool same(const TogetherAt& a, const TogetherAt& b) {
    return a.status == b.status && sameBits(a.value, b.value) && sameBits(a.unit, b.unit) &&
           sameBits(a.offCentre, b.offCentre) && sameBits(a.agreement, b.agreement) && sameBits(a.bend, b.bend) &&
           sameBits(a.centroid, b.centroid) && sameBits(a.gradient, b.gradient);
}

/// What differs from the reference, in units of h, or nothing.
QString difference(const TogetherAt& a, const Evaluationd& b, const Vec3d& x) {
    const double h = b.unit;
    const auto away = [](const Vec3f& p, const Vec3d& q) { return distance(base::cast<double>(p), q); };
    if (a.status != b.status)
        return QString("status %1, not %2").arg(statusName(a.status), statusName(b.status));
    if (std::abs(static_cast<double>(a.value) - b.value) > 3e-6 * h)
        return QString("value %1 h").arg((static_cast<double>(a.value) - b.value) / h);
    if (std::abs(static_cast<double>(a.unit) - h) > 1e-5 * h)
        return "unit";
    if (away(a.centroid, b.centroid) > 5e-6 * h || std::abs(static_cast<double>(a.offCentre) - b.offCentre) > 5e-6 * h)
        return "centroid";
    if (std::abs(static_cast<double>(a.agreement) - b.agreement) > 5e-6)
        return "agreement";
    if (away(a.gradient, b.gradient) > 3e-5)
        return QString("gradient %1").arg(away(a.gradient, b.gradient));
    const Vec3d e = x - b.centroid;
    const double bend = dot(e, b.normalGradient * e);
    if (std::abs(static_cast<double>(a.bend) - bend) > 1e-5 * h)
        return QString("bend %1 h, not %2").arg(static_cast<double>(a.bend) / h).arg(bend / h);
    return {};
}

void compareWithReference(const Surface& surface) {
    const Places places(surface);
    const std::vector<TogetherAt> all = evaluated(surface, places.x, places.side);
    for (std::size_t i = 0; i < all.size(); i += 3) {
        const Vec3d x = base::cast<double>(places.x[i]);
        const Evaluationd expected = surface.evaluateReference(x, Need::Gradient, {places.side[i]});
        const QString found = difference(all[i], expected, x);
        QVERIFY2(found.isEmpty(), qPrintable(QString("%1: %2, seed %3").arg(i).arg(found).arg(test::seed())));
    }
}

} // namespace

void TogetherTest::allNumbersFollowTheReference_data() {
    QTest::addColumn<int>("weight");
    QTest::addColumn<bool>("shrinkFree");
    for (const auto& weight : weightNames())
        for (const bool shrinkFree : {true, false})
            QTest::addRow("%s mu=%d", weight.name, shrinkFree) << static_cast<int>(weight.value) << shrinkFree;
}

void TogetherTest::allNumbersFollowTheReference() {
    QFETCH(int, weight);
    QFETCH(bool, shrinkFree);
    compareWithReference(bumpyTorus(static_cast<Weight>(weight), shrinkFree));
}

void TogetherTest::otherFramesFollowTheReferenceToo() {
    compareWithReference(bumpyTorus(Weight::Wendland, true, Frame::Hyperplanes));
    compareWithReference(shapes::surfaceOf(shapes::plates(12, 0.1, 0.35, 0.1))); // near sheets
}

void TogetherTest::anyCompanyGivesTheSameBits() {
    const Surface surface = bumpyTorus();
    const Places places(surface);
    const std::vector<TogetherAt> all = evaluated(surface, places.x, places.side);
    base::Random random(test::seed());
    for (int round = 0; round < 60; ++round) {
        std::vector<std::size_t> which;
        const double share = random.uniform(0.001, 0.5);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (random.uniform(0, 1) < share)
                which.push_back(i);
        std::vector<Vec3f> x, side;
        for (const std::size_t i : which)
            x.push_back(places.x[i]), side.push_back(places.side[i]);
        const std::vector<TogetherAt> some = evaluated(surface, x, side);
        for (std::size_t k = 0; k < which.size(); ++k)
            QVERIFY2(same(some[k], all[which[k]]), qPrintable(QString("%1, seed %2").arg(k).arg(test::seed())));
    }
}

void TogetherTest::scatteredAndRepeatedPositionsGiveTheSameBits() {
    const Surface surface = bumpyTorus();
    const Places places(surface);
    const std::vector<TogetherAt> all = evaluated(surface, places.x, places.side);
    base::Random random(test::seed());
    std::vector<std::size_t> which;
    for (int k = 0; k < 3000; ++k)
        which.push_back(k % 7 < 3 ? which.empty() ? 0 : which.back()
                                  : static_cast<std::size_t>(random.uniform(0, double(all.size()) - 0.5)));
    std::vector<Vec3f> x, side;
    for (const std::size_t i : which)
        x.push_back(places.x[i]), side.push_back(places.side[i]);
    const std::vector<TogetherAt> some = evaluated(surface, x, side);
    for (std::size_t k = 0; k < which.size(); ++k)
        QVERIFY2(same(some[k], all[which[k]]), qPrintable(QString("%1, seed %2").arg(k).arg(test::seed())));
}

void TogetherTest::placesWithoutSurfaceSaySo() {
    const Surface surface = bumpyTorus();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<Vec3f> x, side(100, Vec3f{0, 0, 1});
    for (int i = 0; i < 100; ++i)
        x.push_back(i % 3 == 0 ? Vec3f{nan, 0, 0} : Vec3f{static_cast<float>(5 + i), 0, 1e9f});
    for (const TogetherAt& each : evaluated(surface, x, side))
        QVERIFY(each.status == Status::Outside);
    for (const TogetherAt& each : evaluated(Surface(), x, side))
        QVERIFY(each.status == Status::Outside);
    QVERIFY(evaluated(surface, {}, {}).empty());
}

void TogetherTest::threadsDoNotChangeBits() {
    const Surface surface = bumpyTorus();
    const Places places(surface);
    const auto work = [&] { return evaluated(surface, places.x, places.side); };
    const std::vector<TogetherAt> one = test::onThreads(1, work), four = test::onThreads(4, work);
    QVERIFY(std::equal(one.begin(), one.end(), four.begin(), four.end(), same));
}

static const test::Registered<TogetherTest> registered;
#include "together_test.moc"
