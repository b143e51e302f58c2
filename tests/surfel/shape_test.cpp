// Shapes of supports: their attributes, their bounds, and what deformations make of them.
#include "core/surfel/shape.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using namespace surfel;
using base::Mat3d, base::Vec3d, base::Vec3f;

class ShapeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void shapesAreThreeAttributesInARow();
    void aTakenNameIsAnError();
    void withoutShapeTheOthersStay();
    void soundShapesAreShortAndAcrossTheNormal();
    void deformedEllipsesAreTheMovedOnes();
    void aTurnTurnsAndAScaleScales();
    void aspectsAreCappedByGrowing();
};

namespace {

Mat3d randomMap(base::Random& random, double strength) {
    Mat3d out = Mat3d::identity();
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            out[r][c] += random.uniform(-strength, strength);
    return out;
}

} // namespace

void ShapeTest::shapesAreThreeAttributesInARow() {
    AttributeLayout layout;
    QCOMPARE(shapeChannel(layout), 0);
    layout.add("scan", ScalarType::Float64);
    addShape(layout);
    addShape(layout);
    QCOMPARE(shapeChannel(layout), int(Extra) + 2);
    QCOMPARE(layout.words(), std::size_t(5));
    const MutableBlockPtr block = SurfelBlock::create(20, layout.words());
    const Vec3f b{1, -2, 0.5f};
    setShape(*block, 17, shapeChannel(layout), b);
    QCOMPARE(shapeOf(*block, 17, shapeChannel(layout)), b);
    QCOMPARE(shapeOf(*block, 17, 0), Vec3f());
    std::vector<std::uint32_t> words(layout.words());
    block->extra(17, words);
    QCOMPARE(shapeIn(words, shapeWord(layout)), b);
    AttributeLayout other; // in another order, or of another type, they are attributes as any
    other.add(shapeNames[1], ScalarType::Float32), other.add(shapeNames[0], ScalarType::Float32);
    other.add(shapeNames[2], ScalarType::Float32);
    QCOMPARE(shapeChannel(other), 0);
}

void ShapeTest::aTakenNameIsAnError() {
    AttributeLayout layout;
    layout.add(shapeNames[1], ScalarType::Int32);
    QVERIFY_THROWS_EXCEPTION(base::Error, addShape(layout));
}

void ShapeTest::withoutShapeTheOthersStay() {
    auto layout = std::make_shared<AttributeLayout>();
    layout->add("before", ScalarType::UInt32);
    addShape(*layout);
    layout->add("behind", ScalarType::UInt32);
    SurfelList list;
    list.layout = layout;
    for (std::uint32_t i = 0; i < 5; ++i)
        list.append({}, std::vector<std::uint32_t>{i, 1, 2, 3, 10 + i});
    const SurfelList plain = withoutShape(list);
    QCOMPARE(plain.layout->words(), std::size_t(2));
    QCOMPARE(shapeChannel(*plain.layout), 0);
    for (std::uint32_t i = 0; i < 5; ++i)
        QVERIFY(plain.extraOf(i)[0] == i && plain.extraOf(i)[1] == 10 + i);
}

void ShapeTest::soundShapesAreShortAndAcrossTheNormal() {
    base::Random random(test::seed());
    for (int i = 0; i < 1000; ++i) {
        const Vec3f n = base::cast<float>(random.unitVector());
        const Vec3f b = soundShape(base::cast<float>(random.unitVector() * random.uniform(0, 20)), n);
        QVERIFY(std::abs(dot(b, n)) < 1e-5f);
        QVERIFY(length(b) <= 1.0001f * longestShape && aspectOf(b) <= 1.0001f * mostAspect);
    }
    for (int i = 0; i < 1000; ++i) { // once is enough
        const Vec3f n = base::cast<float>(random.unitVector());
        const Vec3f b = soundShape(base::cast<float>(random.unitVector() * random.uniform(0, 20)), n);
        QVERIFY(distance(soundShape(b, n), b) <= 2e-5f * length(b));
    }
    QCOMPARE(soundShape({std::numeric_limits<float>::infinity(), 0, 0}, {0, 0, 1}), Vec3f());
    QCOMPARE(soundShape({0.5f, 0, 0}, {0, 0, 1}), Vec3f(0.5f, 0, 0));
}

/// The points of the ellipse go to points of the new one, along the new normal.
void ShapeTest::deformedEllipsesAreTheMovedOnes() {
    base::Random random(test::seed());
    int compared = 0;
    for (int i = 0; i < 500; ++i) {
        const Mat3d map = randomMap(random, 0.3);
        const Vec3d n = random.unitVector(), u = base::perpendicular(n), v = cross(n, u);
        const double angle = random.uniform(0, 6.3), aspect = i % 5 == 0 ? 1 : random.uniform(1, 2.5);
        const Vec3d e = u * std::cos(angle) + v * std::sin(angle);
        const Ellipse before{0.7f, base::cast<float>(e * std::sqrt(aspect * aspect - 1))};
        const Vec3d turned = base::normalized(base::cofactor(map) * n);
        const Ellipse after = deformed(before, base::cast<float>(n), map, base::cast<float>(turned));
        QVERIFY(std::abs(dot(base::cast<double>(after.shape), turned)) < 1e-5);
        if (aspectOf(after.shape) > 0.999f * mostAspect)
            continue;
        ++compared;
        for (int k = 0; k < 12; ++k) {
            const double t = 0.5 * k, s = double(before.radius);
            const Vec3d p = cross(n, e) * (s * std::cos(t)) + e * (s / aspect * std::sin(t));
            const double r =
                std::sqrt(double(shapedSq(base::cast<float>(map * p), after.shape))) / double(after.radius);
            QVERIFY2(std::abs(r - 1) < 1e-4, qPrintable(QString::number(r - 1)));
        }
    }
    QVERIFY(compared > 300);
}

void ShapeTest::aTurnTurnsAndAScaleScales() {
    const Mat3d turn{{{0, -2, 0}, {2, 0, 0}, {0, 0, 2}}}; // a quarter about z, twice as large
    const Ellipse out = deformed({0.5f, {1, 0, 0}}, {0, 0, 1}, turn, {0, 0, 1});
    QVERIFY(std::abs(out.radius - 1) < 1e-6f);
    QVERIFY(std::abs(std::abs(out.shape.y) - 1) < 1e-5f && std::abs(out.shape.x) < 1e-5f);
    QCOMPARE(deformed({0.5f, {}}, {0, 0, 1}, turn, {0, 0, 1}).shape, Vec3f());
}

void ShapeTest::aspectsAreCappedByGrowing() {
    const Mat3d stretch{{{10, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const Ellipse out = deformed({1, {}}, {0, 0, 1}, stretch, {0, 0, 1});
    QVERIFY(std::abs(out.radius - 10) < 1e-5f);
    QVERIFY(std::abs(aspectOf(out.shape) - mostAspect) < 1e-4f);
    QVERIFY(out.radius / aspectOf(out.shape) > 1); // what was covered is
}

static const test::Registered<ShapeTest> registered;
#include "shape_test.moc"
