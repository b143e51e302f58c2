// Reduced sets with ellipsoidal supports: where they win, how they lie, what auto takes, and that nothing gets lost.
#include "core/base/parallel.h"
#include "core/reduce/reduce.h"
#include "core/surfel/shape.h"
#include "reduce/reduced_models.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using namespace reduce;
using test::Shape;
using test::Vec3d;
using test::Vec3f;

class ReducedEllipsoidsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void onACylinderTheyHalveTheError();
    void onACylinderTheyLieAlongIt();
    void autoTakesWhatWins();
    void closedShapesKeepTheirSurface();
    void aFieldOfTheModelComesAlong();
    void aShapedModelIsReducedToBalls();
    void sameBitsAtAnyThreadCount();
    void cancellingStops();
};

namespace {

QByteArray told(const Reduced& r) {
    return (summaryOf(r.report) + "; surf rms " + std::to_string(r.report.surfaceRms) + ", normals " +
            std::to_string(r.report.normalsDeg) + ", least " + std::to_string(r.report.leastSupports))
        .c_str();
}

bool shaped(const surface::Surface& surface) {
    return surfel::shapeChannel(*surface.tree().layout()) > 0;
}

/// fn(position, normal, radius, b)
template <class Fn>
void forSupports(const surface::Surface& surface, const Fn& fn) {
    const int channel = surfel::shapeChannel(*surface.tree().layout());
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            fn(block.position(slot), block.normal(slot), block.support(slot), surfel::shapeOf(block, slot, channel));
    });
}

/// Of so many in every build: beside rims supports are balls, and of fewer those are most.
constexpr std::size_t manyOfACylinder = 10000;

const Reduced& ellipsoidsOfACylinder() {
    static const Reduced made =
        reduceToCount(test::cylinder(manyOfACylinder).surface, manyOfACylinder / 10, Shapes::Ellipsoids);
    return made;
}

} // namespace

void ReducedEllipsoidsTest::onACylinderTheyHalveTheError() {
    const Shape shape = test::cylinder(manyOfACylinder);
    const Reduced balls = reduceToCount(shape.surface, manyOfACylinder / 10, Shapes::Spheres);
    const Reduced& ellipsoids = ellipsoidsOfACylinder();
    const QByteArray all = told(balls) + " | " + told(ellipsoids);
    qInfo("%s", all.constData());
    QVERIFY(!balls.report.ellipsoids && ellipsoids.report.ellipsoids);
    QCOMPARE(ellipsoids.report.count, balls.report.count);
    // Beside the rims all are balls.
    std::vector<base::Vec3f> middle = test::positionsOf(shape.surface);
    std::erase_if(middle, [](const base::Vec3f& x) { return std::abs(x.z) > 0.5F; });
    const double balled = test::errorsOf(balls.surface, shape, middle).rms;
    const double drawn = test::errorsOf(ellipsoids.surface, shape, middle).rms;
    QVERIFY2(drawn < 0.5 * balled, all + QByteArray::number(drawn / balled));
    QVERIFY2(ellipsoids.report.surfaceRms < 0.8 * balls.report.surfaceRms, all);
    QVERIFY2(ellipsoids.report.holes == 0 && ellipsoids.report.leastSupports >= 3, all);
}

void ReducedEllipsoidsTest::onACylinderTheyLieAlongIt() {
    const Reduced& result = ellipsoidsOfACylinder();
    int all = 0, along = 0;
    forSupports(result.surface, [&](const Vec3f& p, const Vec3f& n, float, const Vec3f& b) {
        QVERIFY(std::abs(dot(b, n)) < 1e-4f && surfel::aspectOf(b) <= 1.001f * surfel::mostAspect);
        if (std::abs(p.z) > 1.5f) // the rim
            return;
        ++all;
        along += surfel::aspectOf(b) > 1.5f && std::abs(normalized(b).z) < 0.3f; // b is the short axis
    });
    QVERIFY2(along > 0.95 * all, qPrintable(QString("%1 of %2").arg(along).arg(all)));
}

void ReducedEllipsoidsTest::autoTakesWhatWins() {
    QVERIFY(shaped(reduceToCount(test::cylinder(8000).surface, 800, Shapes::Auto).surface));
    const std::size_t count = test::sanitized ? 4000 : 8000;
    // Whether or not the other is made as well, it is one of the two, to the bit.
    for (const bool round : {true, false}) {
        const Shape shape = round ? test::sphere(count) : test::torus(count);
        const Reduced taken = reduceToCount(shape.surface, count / 10, Shapes::Auto);
        const Shapes asked = round ? Shapes::Spheres : Shapes::Ellipsoids;
        const Reduced same = reduceToCount(shape.surface, count / 10, asked);
        QCOMPARE(shaped(taken.surface), !round);
        QCOMPARE(taken.surface.tree().contentHash().text(), same.surface.tree().contentHash().text());
    }
}

void ReducedEllipsoidsTest::closedShapesKeepTheirSurface() {
    const std::size_t count = std::size_t(test::effort(10000));
    for (const Shape& shape : {test::sphere(count), test::torus(count)}) {
        const Reduced result = reduceToCount(shape.surface, count / 10, Shapes::Ellipsoids);
        result.surface.tree().validate();
        const test::Errors errors = test::errorsOf(result.surface, shape, test::positionsOf(shape.surface));
        const QByteArray all = told(result);
        qInfo("%s", all.constData());
        QVERIFY2(errors.rms < 0.03 * shape.spacing && errors.lost == 0, all);
        QVERIFY2(result.report.holes == 0 && result.report.leastSupports >= 3, all);
    }
}

void ReducedEllipsoidsTest::aFieldOfTheModelComesAlong() {
    const Shape shape = test::cylinder(4000);
    surfel::SurfelList list = shape.surface.tree().surfels();
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->add("height", surfel::ScalarType::Float32);
    list.layout = layout;
    for (const surfel::Surfel& s : list.items)
        list.extra.push_back(std::bit_cast<std::uint32_t>(s.position.z));
    const surface::Surface model(tree::SurfelTree::build(list), shape.surface.definition());
    const Reduced result = reduceToCount(model, 400, Shapes::Ellipsoids);
    const surfel::SurfelList out = result.surface.tree().surfels();
    QVERIFY(out.layout->find("height") && shaped(result.surface));
    for (std::size_t i = 0; i < out.size(); ++i)
        QVERIFY(std::abs(surfel::read(*out.layout->find("height"), out.extraOf(i)) - double(out.items[i].position.z)) <
                0.2);
}

void ReducedEllipsoidsTest::aShapedModelIsReducedToBalls() {
    const Reduced first = reduceToCount(test::cylinder(6000).surface, 2000, Shapes::Ellipsoids);
    const Reduced second = reduceToCount(first.surface, 500, Shapes::Spheres);
    QVERIFY(shaped(first.surface) && !shaped(second.surface));
    QCOMPARE(second.surface.tree().layout()->words(), std::size_t(1)); // that of rims
    QVERIFY2(second.report.holes == 0, told(second));
    const Reduced third = reduceToCount(first.surface, 500, Shapes::Ellipsoids);
    QVERIFY2(shaped(third.surface) && third.report.holes == 0, told(third));
}

void ReducedEllipsoidsTest::sameBitsAtAnyThreadCount() {
    const Shape shape = test::cylinder(4000);
    const int threads = base::threadCount();
    std::vector<std::string> hashes;
    for (const int n : {1, 2, 5}) {
        base::setThreadCount(n);
        const Reduced result = reduceToCount(shape.surface, 400, Shapes::Ellipsoids);
        hashes.push_back(result.surface.tree().contentHash().text());
    }
    base::setThreadCount(threads);
    QCOMPARE(hashes[0], hashes[1]);
    QCOMPARE(hashes[0], hashes[2]);
}

void ReducedEllipsoidsTest::cancellingStops() {
    const Shape shape = test::cylinder(3000);
    for (int after = 0; after < 60; after += 7) {
        std::atomic<bool> cancel = false;
        int reports = 0;
        base::Progress progress;
        progress.cancel = &cancel;
        progress.report = [&](double, std::string_view) { cancel = ++reports > after; };
        try {
            reduceByRatio(shape.surface, 0.1, Shapes::Auto, progress);
            QVERIFY(after > 10);
        } catch (const base::Cancelled&) {
        }
    }
}

static const test::Registered<ReducedEllipsoidsTest> registered;
#include "ellipsoids_test.moc"
