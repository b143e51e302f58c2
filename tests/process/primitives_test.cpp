// Planes, spheres, cylinders, cones and tori are found again: exactly without noise, and among strays.
#include "core/base/random.h"
#include "core/process/measuring/primitives.h"
#include "support/registry.h"
#include "support/threads.h"

#include <numbers>
#include <QTest>

using namespace process;
using base::Vec3d;

class PrimitivesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void distancesAreThoseOfTheNearestPoint();
    void cleanSamplesAreExact_data();
    void cleanSamplesAreExact();
    void straysDoNotCount_data();
    void straysDoNotCount();
    void noiseAveragesOut_data();
    void noiseAveragesOut();
    void partsOfShapesAreEnough();
    void threadsDoNotShow();
    void tooFewPointsAreRefused();
};

namespace {

constexpr double pi = std::numbers::pi;

struct Sampled {
    Vec3d position, normal;
};

/// A place on the shape, by two random numbers; cones to a height of 1.
Sampled sampleOf(const Primitive& p, base::Random& random) {
    const Vec3d u = base::perpendicular(p.axis), v = cross(p.axis, u);
    const double turn = random.uniform(0, 2 * pi);
    const Vec3d e = u * std::cos(turn) + v * std::sin(turn);
    switch (p.shape) {
    case Shape::Plane:
        return {p.place + u * random.uniform(-1, 1) + v * random.uniform(-1, 1), p.axis};
    case Shape::Sphere: {
        const Vec3d d = random.unitVector();
        return {p.place + d * p.radius, d};
    }
    case Shape::Cylinder:
        return {p.place + e * p.radius + p.axis * random.uniform(-1, 1), e};
    case Shape::Cone: {
        const double along = std::sqrt(random.uniform(0.05, 1));
        return {p.place + p.axis * along + e * (along * std::tan(p.angle)),
                e * std::cos(p.angle) - p.axis * std::sin(p.angle)};
    }
    default: {
        const double t = random.uniform(0, 2 * pi);
        const Vec3d n = e * std::cos(t) + p.axis * std::sin(t);
        return {p.place + e * p.radius + n * p.tube, n};
    }
    }
}

surfel::SurfelList samples(const Primitive& p, std::size_t count, double noise, base::Random& random) {
    surfel::SurfelList out;
    for (std::size_t i = 0; i < count; ++i) {
        const Sampled at = sampleOf(p, random);
        surfel::Surfel s;
        s.position = base::cast<float>(at.position + at.normal * (noise * random.normal()));
        // signs are anybody's guess
        s.normal = base::cast<float>(base::normalized(at.normal + random.unitVector() * (5 * noise))) *
                   (random.uniform() < 0.5 ? -1.0f : 1.0f);
        out.items.push_back(s);
    }
    return out;
}

/// Among them, in a box about them.
void addStrays(surfel::SurfelList& list, std::size_t count, base::Random& random) {
    Vec3d low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    for (const surfel::Surfel& s : list.items)
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], double(s.position[k]) - 0.3);
            high[k] = std::max(high[k], double(s.position[k]) + 0.3);
        }
    for (std::size_t i = 0; i < count; ++i) {
        surfel::Surfel s;
        for (std::size_t k = 0; k < 3; ++k)
            s.position[k] = float(random.uniform(low[k], high[k]));
        s.normal = base::cast<float>(random.unitVector());
        list.items.push_back(s);
    }
}

Primitive some(Shape shape, base::Random& random) {
    Primitive out;
    out.shape = shape;
    out.place = random.unitVector() * random.uniform(0, 2);
    out.axis = random.unitVector();
    if (shape == Shape::Sphere || shape == Shape::Cylinder)
        out.radius = random.uniform(0.3, 1.5);
    if (shape == Shape::Cone)
        out.angle = random.uniform(0.2, 1);
    if (shape == Shape::Torus)
        out.radius = random.uniform(0.8, 1.2), out.tube = random.uniform(0.15, 0.5);
    return out;
}

/// Largest difference of what the shape is, whatever represents it.
double difference(const Primitive& a, const Primitive& b) {
    double out = std::max({std::abs(a.radius - b.radius), std::abs(a.tube - b.tube), std::abs(a.angle - b.angle)});
    if (a.shape != Shape::Sphere)
        out = std::max(out, length(cross(a.axis, b.axis)));
    const Vec3d between = a.place - b.place;
    const double along = std::abs(dot(between, b.axis)), across = length(between - b.axis * dot(between, b.axis));
    if (a.shape == Shape::Plane)
        return std::max(out, along);
    return std::max(out, a.shape == Shape::Cylinder ? across : length(between));
}

void shapes() {
    QTest::addColumn<int>("shape");
    for (const ShapeRow& row : shapeTable())
        QTest::newRow(row.id) << int(row.shape);
}

QByteArray told(double value) {
    return QByteArray::number(value) + ", seed " + QByteArray::number(test::seed());
}

} // namespace

void PrimitivesTest::distancesAreThoseOfTheNearestPoint() {
    base::Random random(test::seed());
    for (const ShapeRow& row : shapeTable()) {
        Primitive p = some(row.shape, random);
        for (int k = 0; k < 20; ++k) {
            const Sampled at = sampleOf(p, random);
            const double off = random.uniform(-0.1, 0.1);
            const double d = p.distance(at.position + at.normal * off);
            QVERIFY2(std::abs(d - off) < 1e-12, told(d - off));
        }
    }
    Primitive cone = some(Shape::Cone, random);
    QVERIFY(std::abs(cone.distance(cone.place - cone.axis * 0.5) - 0.5) < 1e-12); // behind the apex
}

void PrimitivesTest::cleanSamplesAreExact_data() {
    shapes();
}

void PrimitivesTest::cleanSamplesAreExact() {
    QFETCH(int, shape);
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(4); ++k) {
        const Primitive wanted = some(Shape(shape), random);
        const surfel::SurfelList list = samples(wanted, 3000, 0, random);
        const PrimitiveFit fit = fitPrimitive(list, Shape(shape));
        QVERIFY2(difference(fit.primitive, wanted) < 1e-6, told(difference(fit.primitive, wanted)));
        QVERIFY2(fit.inliers > list.size() * 97 / 100 && fit.max < 1e-6, told(fit.max));
    }
}

void PrimitivesTest::straysDoNotCount_data() {
    shapes();
}

void PrimitivesTest::straysDoNotCount() {
    QFETCH(int, shape);
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(4); ++k) {
        const Primitive wanted = some(Shape(shape), random);
        surfel::SurfelList list = samples(wanted, 2100, 0.002, random);
        addStrays(list, 900, random); // 30 %
        const PrimitiveFit fit = fitPrimitive(list, Shape(shape));
        QVERIFY2(difference(fit.primitive, wanted) < 0.002, told(difference(fit.primitive, wanted)));
        const auto good = std::count(fit.inlier.begin(), fit.inlier.begin() + 2100, 1);
        const auto bad = std::count(fit.inlier.begin() + 2100, fit.inlier.end(), 1);
        QVERIFY2(good > 2000 && bad < 60, told(double(good) + 1e-4 * double(bad)));
        QVERIFY2(std::abs(fit.rms / 0.002 - 1) < 0.15, told(fit.rms));
    }
}

void PrimitivesTest::noiseAveragesOut_data() {
    shapes();
}

void PrimitivesTest::noiseAveragesOut() {
    QFETCH(int, shape);
    base::Random random(test::seed());
    const Primitive wanted = some(Shape(shape), random);
    const PrimitiveFit fit = fitPrimitive(samples(wanted, 4000, 0.02, random), Shape(shape));
    QVERIFY2(difference(fit.primitive, wanted) < 0.01, told(difference(fit.primitive, wanted)));
}

/// A quarter of a cylinder, a cap of a sphere.
void PrimitivesTest::partsOfShapesAreEnough() {
    base::Random random(test::seed());
    for (const Shape shape : {Shape::Sphere, Shape::Cylinder}) {
        const Primitive wanted = some(shape, random);
        const Vec3d to = base::perpendicular(wanted.axis);
        surfel::SurfelList list = samples(wanted, 20000, 0.0005, random);
        std::erase_if(list.items, [&](const surfel::Surfel& s) {
            const Vec3d q = base::cast<double>(s.position) - wanted.place;
            const Vec3d flat = shape == Shape::Sphere ? q : q - wanted.axis * dot(q, wanted.axis);
            return dot(base::normalized(flat), to) < 0.7;
        });
        const PrimitiveFit fit = fitPrimitive(list, shape);
        QVERIFY2(difference(fit.primitive, wanted) < 0.003, told(difference(fit.primitive, wanted)));
    }
}

void PrimitivesTest::threadsDoNotShow() {
    base::Random random(test::seed());
    surfel::SurfelList list = samples(some(Shape::Torus, random), 20000, 0.01, random);
    addStrays(list, 5000, random);
    const auto work = [&] { return fitPrimitive(list, Shape::Torus); };
    const PrimitiveFit one = test::onThreads(1, work), two = test::onThreads(2, work);
    QVERIFY(one.primitive.place == two.primitive.place && one.primitive.tube == two.primitive.tube &&
            one.inlier == two.inlier);
}

void PrimitivesTest::tooFewPointsAreRefused() {
    surfel::SurfelList list;
    for (const ShapeRow& row : shapeTable()) {
        list.items.assign(row.fewest - 1, {});
        QVERIFY_EXCEPTION_THROWN(fitPrimitive(list, row.shape), base::Error);
        list.items.assign(50, {}); // all in one place
        QVERIFY_EXCEPTION_THROWN(fitPrimitive(list, row.shape), base::Error);
    }
}

static const test::Registered<PrimitivesTest> registered;
#include "primitives_test.moc"
