// What an evaluation says where there is no surface, and how frames choose their signs.
#include "core/surface/definition_text.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3f;
using shapes::definitionOf, shapes::sameBits;

class StatusTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void fewOrCancellingSurfelsAreDegenerate();
    void farPositionsAreOutside();
    void hintChoosesTheSignOfUnorientedFrames();
    void flippedNormalsLeaveHyperplanesUnchanged();
    void framesFallBackToWhatTheSurfelsHave();
};

void StatusTest::fewOrCancellingSurfelsAreDegenerate() {
    surfel::SurfelList two;
    two.layout = shapes::layout(true, true);
    two.items = {shapes::surfelAt({0, 0, 0}, {0, 0, 1}, 1), shapes::surfelAt({0.1, 0, 0}, {0, 0, 1}, 1)};
    QCOMPARE(shapes::surfaceOf(two).evaluateReference({0, 0, 0.1}).status, Status::Degenerate);
    QCOMPARE(shapes::surfaceOf(two).evaluate({0, 0, 0.1f}).status, Status::Degenerate);
    surfel::SurfelList line;
    line.layout = shapes::layout(false, false);
    for (int i = -5; i <= 5; ++i)
        line.items.push_back(shapes::surfelAt({0.1 * i, 0, 0}, {}, 1));
    for (const auto frame : {Frame::Covariance, Frame::CovarianceAtCentroid})
        QCOMPARE(shapes::surfaceOf(line, definitionOf(frame)).evaluateReference({0, 0, 0.0}).status,
                 Status::Degenerate);
    const surfel::SurfelList opposite = shapes::plates(5, 0.1, 0.4, 0);
    SurfaceDefinition plain = definitionOf(Frame::Normals);
    plain.oneSheet = false;
    QCOMPARE(shapes::surfaceOf(opposite, plain).evaluateReference({0, 0, 0.01}).status, Status::Degenerate);
    plain.frame = Frame::Hyperplanes;
    QCOMPARE(shapes::surfaceOf(opposite, plain).evaluateReference({0, 0, 0.01}).status, Status::Ok);
}

void StatusTest::farPositionsAreOutside() {
    const Surface surface = shapes::surfaceOf(shapes::sphere(500, 1, 0.3));
    QCOMPARE(surface.evaluate({3, 0, 0}).status, Status::Outside);
    QCOMPARE(surface.evaluateReference({0, 0, 0}).status, Status::Outside);
    QCOMPARE(Surface().evaluate({0, 0, 0}).status, Status::Outside);
    QCOMPARE(Surface().evaluateReference({0, 0, 0}).status, Status::Outside);
}

void StatusTest::hintChoosesTheSignOfUnorientedFrames() {
    surfel::SurfelList list = shapes::plane(8, 0.1, 0.35);
    for (std::size_t i = 0; i < list.size(); i += 2)
        list.items[i].normal = -list.items[i].normal;
    list.layout = shapes::layout(true, false);
    for (const auto& frame : frameNames()) {
        const Surface surface = shapes::surfaceOf(list, definitionOf(frame.value, true));
        for (const float side : {1.0f, -1.0f}) {
            const Evaluationf e = surface.evaluate({0.02f, 0.03f, 0.04f}, Need::Gradient, {{0, 0.3f, side}});
            QVERIFY(e.ok());
            QVERIFY(std::abs(e.value - side * 0.04f) < 1e-6f);
            QVERIFY(std::abs(e.gradient.z - side) < (frame.value == Frame::Covariance ? 0.1f : 1e-4f));
            QVERIFY(e.agreement > 0.999f);
        }
    }
}

void StatusTest::flippedNormalsLeaveHyperplanesUnchanged() {
    surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.5, 0.08, 0.25), 0.02, test::seed());
    list.layout = shapes::layout(true, false);
    const Surface a = shapes::surfaceOf(list, definitionOf(Frame::Hyperplanes));
    base::Random random(test::seed());
    for (surfel::Surfel& s : list.items)
        if (random.uniform() < 0.5)
            s.normal = -s.normal;
    const Surface b = shapes::surfaceOf(list, definitionOf(Frame::Hyperplanes));
    for (std::size_t i = 0; i < list.size(); i += 5) {
        const Vec3f x = list.items[i].position * 1.01f;
        const Evaluationf ea = a.evaluate(x), eb = b.evaluate(x);
        QVERIFY(sameBits(ea.value, eb.value) && sameBits(ea.normal, eb.normal) && sameBits(ea.gradient, eb.gradient));
    }
}

void StatusTest::framesFallBackToWhatTheSurfelsHave() {
    surfel::SurfelList list = shapes::sphere(500, 1, 0.4);
    QCOMPARE(shapes::surfaceOf(list).effectiveFrame(), Frame::Normals);
    list.layout = shapes::layout(true, false);
    QCOMPARE(shapes::surfaceOf(list).effectiveFrame(), Frame::Hyperplanes);
    list.layout = shapes::layout(false, false);
    QCOMPARE(shapes::surfaceOf(list).effectiveFrame(), Frame::CovarianceAtCentroid);
    QCOMPARE(shapes::surfaceOf(list, definitionOf(Frame::Covariance)).effectiveFrame(), Frame::Covariance);
}

static const test::Registered<StatusTest> registered;
#include "status_test.moc"
