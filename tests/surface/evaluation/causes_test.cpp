// The degenerate cases of surface/README 2.5 by name: every frame, both precisions. A failure never holds a number.
#include "core/surface/curvature.h"
#include "core/surface/definition_text.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;
using shapes::definitionOf, shapes::surfelAt;

class CausesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void nothingNearBy();
    void onePointAndTwo();
    void manyAtOnePlace();
    void manyOnOneLine();
    void normalsThatCancel();
    void gapsThatClose();
    void centreOfAFittedSphere();
    void everyFrameAndWeightNamesItsFailures();
};

static surfel::SurfelList listOf(const std::vector<surfel::Surfel>& items, bool normals = true, bool oriented = true) {
    surfel::SurfelList out;
    out.layout = shapes::layout(normals, oriented);
    out.items = items;
    return out;
}

template <class T>
static bool holdsNoNumber(const Evaluation<T>& e) {
    const auto none = [](const base::Vec3<T>& v) { return std::isnan(v.x) && std::isnan(v.y) && std::isnan(v.z); };
    bool out = std::isnan(e.value) && std::isnan(e.offCentre) && none(e.centroid) && none(e.normal) && none(e.gradient);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            out = out && std::isnan(e.hessian[row][column]) && std::isnan(e.normalGradient[row][column]);
    return out;
}

/// Both precisions and curvature say this, at x.
static void verify(const Surface& surface, const Vec3d& x, Status status, Cause cause) {
    const QString where = QString("%1 %2").arg(nameOf(surface.definition().frame), nameOf(surface.definition().weight));
    for (const Need need : {Need::Value, Need::Gradient, Need::Hessian}) {
        const Evaluationd d = surface.evaluateReference(x, need);
        const Evaluationf f = surface.evaluate(base::cast<float>(x), need);
        QVERIFY2(d.status == status && f.status == status,
                 qPrintable(where + QString(": %1, %2").arg(statusName(d.status), statusName(f.status))));
        QVERIFY2(d.cause == cause && f.cause == cause,
                 qPrintable(where + QString(": %1, %2").arg(causeName(d.cause), causeName(f.cause))));
        if (status == Status::Ok)
            QVERIFY(std::isfinite(d.value) && std::isfinite(f.value));
        else
            QVERIFY2(holdsNoNumber(d) && holdsNoNumber(f), qPrintable(where));
    }
}

void CausesTest::nothingNearBy() {
    const surfel::SurfelList list = shapes::sphere(500, 1, 0.3);
    for (const auto& frame : frameNames()) {
        const Surface surface = shapes::surfaceOf(list, definitionOf(frame.value));
        for (const Vec3d& x : {Vec3d{3, 0, 0}, Vec3d{0, 0, 0}}) {
            verify(surface, x, Status::Outside, Cause::NoSupport);
            const Curvature c = curvatureReference(surface, x);
            QVERIFY(c.status == Status::Outside && c.cause == Cause::NoSupport && std::isnan(c.k1));
        }
    }
    verify(Surface(), {0, 0, 0}, Status::Outside, Cause::NoSupport);
}

void CausesTest::onePointAndTwo() {
    const surfel::SurfelList one = listOf({surfelAt({0, 0, 0}, {0, 0, 1}, 1)});
    const surfel::SurfelList two = listOf({one.items[0], surfelAt({0.3, 0, 0}, {0, 0, 1}, 1)});
    for (const auto& frame : frameNames()) {
        verify(shapes::surfaceOf(one, definitionOf(frame.value)), {0.1, 0.2, 0.1}, Status::Degenerate, Cause::OnePoint);
        verify(shapes::surfaceOf(two, definitionOf(frame.value)), {0.1, 0.2, 0.1}, Status::Degenerate, Cause::TooFew);
    }
}

void CausesTest::manyAtOnePlace() {
    surfel::SurfelList exact = listOf({}), nearly = listOf({});
    base::Random random(test::seed());
    for (int i = 0; i < 12; ++i) {
        const Vec3d n = base::normalized(Vec3d{0, 0, 1} + random.unitVector() * 0.3);
        exact.items.push_back(surfelAt({0.7, -0.2, 0.4}, n, 1));
        nearly.items.push_back(surfelAt(Vec3d{0.7, -0.2, 0.4} + random.unitVector() * 1e-4, n, 1));
    }
    for (const auto& frame : frameNames())
        for (const auto& weight : weightNames())
            for (const surfel::SurfelList* list : {&exact, &nearly}) {
                const Surface surface = shapes::surfaceOf(*list, definitionOf(frame.value, true, weight.value));
                for (const Vec3d& x : {Vec3d{0.7, -0.2, 0.41}, Vec3d{0.5, -0.1, 0.55}})
                    verify(surface, x, Status::Degenerate, Cause::Coincident);
            }
}

void CausesTest::manyOnOneLine() {
    surfel::SurfelList line = listOf({}, false, false);
    const Vec3d along = base::normalized(Vec3d{1, 0.5, -0.25});
    for (int i = -8; i <= 8; ++i)
        line.items.push_back(surfelAt(along * (0.1 * i + (i % 3) * 0.01), {0, 0.447214, 0.894427}, 1));
    const Vec3d on = along * 0.03, off = on + Vec3d{0.05, -0.2, 0.15};
    for (const auto frame : {Frame::Covariance, Frame::CovarianceAtCentroid, Frame::CentroidGradient})
        for (const auto& weight : weightNames())
            for (const Vec3d& x : {on, off}) // beside it, x and the line span a plane that means nothing
                verify(shapes::surfaceOf(line, definitionOf(frame, false, weight.value)), x, Status::Degenerate,
                       Cause::Collinear);
    // with normals a line of points is a strip of a plane
    line.layout = shapes::layout(true, true);
    for (const auto frame : {Frame::Normals, Frame::Hyperplanes, Frame::Apss, Frame::Rimls}) {
        const Surface surface = shapes::surfaceOf(line, definitionOf(frame));
        verify(surface, off, Status::Ok, Cause::None);
        const Vec3d n = base::normalized(base::cast<double>(line.items[0].normal));
        QVERIFY(std::abs(surface.evaluateReference(off).value - dot(n, off)) < 1e-6);
    }
}

void CausesTest::normalsThatCancel() {
    const surfel::SurfelList opposite = shapes::plates(5, 0.1, 0.4, 0);
    for (const auto& frame : frameNames()) {
        SurfaceDefinition plain = definitionOf(frame.value);
        plain.oneSheet = false;
        const bool sums = frame.value == Frame::Normals || frame.value == Frame::Apss || frame.value == Frame::Rimls;
        verify(shapes::surfaceOf(opposite, plain), {0.02, 0.01, 0.01}, sums ? Status::Degenerate : Status::Ok,
               sums ? Cause::CancellingNormals : Cause::None);
    }
}

void CausesTest::gapsThatClose() {
    // the corners of a cube look the same in all directions from its centre; so do three families of normals
    surfel::SurfelList cube = listOf({}, false, false), corner = listOf({}, true, false);
    base::Random random(test::seed());
    for (int i = 0; i < 8; ++i)
        cube.items.push_back(surfelAt({i & 1 ? 0.3 : -0.3, i & 2 ? 0.3 : -0.3, i & 4 ? 0.3 : -0.3}, {}, 1));
    for (int i = 0; i < 30; ++i)
        corner.items.push_back(
            surfelAt(random.unitVector() * 0.1, {i % 3 == 0 ? 1.0 : 0, i % 3 == 1 ? 1.0 : 0, i % 3 == 2 ? 1.0 : 0}, 1));
    for (const auto frame : {Frame::Covariance, Frame::CovarianceAtCentroid, Frame::CentroidGradient})
        verify(shapes::surfaceOf(cube, definitionOf(frame)), {0, 0, 0}, Status::Degenerate, Cause::ClosedGap);
    verify(shapes::surfaceOf(corner, definitionOf(Frame::Hyperplanes)), {0, 0, 0}, Status::Degenerate,
           Cause::ClosedGap);
}

void CausesTest::centreOfAFittedSphere() {
    surfel::SurfelList cap = shapes::sphere(2000, 1, 1.5);
    std::erase_if(cap.items, [](const surfel::Surfel& s) { return s.position.z < 0.3f; });
    verify(shapes::surfaceOf(cap, definitionOf(Frame::Apss)), {0, 0, 0}, Status::Degenerate, Cause::NoGradient);
    verify(shapes::surfaceOf(cap, definitionOf(Frame::Apss)), {0, 0, 0.1}, Status::Ok, Cause::None);
}

/// Clouds of a few random points with repetitions: whatever comes out is a number or a named failure.
void CausesTest::everyFrameAndWeightNamesItsFailures() {
    base::Random random(test::seed());
    int failures = 0, answers = 0;
    for (int round = 0; round < 60; ++round) {
        surfel::SurfelList list = listOf({}, random.uniform() < 0.8, random.uniform() < 0.6);
        const std::size_t count = 1 + random.below(9);
        for (std::size_t i = 0; i < count; ++i) {
            surfel::Surfel s = surfelAt(random.unitVector() * random.uniform(0, 0.6), random.unitVector(), 1);
            if (i > 0 && random.uniform() < 0.3)
                s.position = list.items[random.below(i)].position;
            list.items.push_back(s);
        }
        for (const auto& frame : frameNames())
            for (const auto& weight : weightNames()) {
                SurfaceDefinition definition = definitionOf(frame.value, true, weight.value);
                definition.interpolating = round % 3 == 0;
                definition.oneSheet = round % 2 == 0;
                const Surface surface = shapes::surfaceOf(list, definition);
                const Vec3f at = round % 5 == 0 ? list.items[0].position
                                                : base::cast<float>(random.unitVector() * random.uniform(0, 0.9));
                const Evaluationf f = surface.evaluate(at);
                const Evaluationd d = surface.evaluateReference(base::cast<double>(at), Need::Hessian);
                const QString where = QString("%1 %2, round %3, seed %4: %5")
                                          .arg(frame.name, weight.name)
                                          .arg(round)
                                          .arg(test::seed())
                                          .arg(causeName(d.cause));
                QVERIFY2(d.ok() == (d.cause == Cause::None) && f.ok() == (f.cause == Cause::None), qPrintable(where));
                QVERIFY2(d.ok() ? std::isfinite(d.value) && isFinite(d.gradient) && std::isfinite(trace(d.hessian))
                                : holdsNoNumber(d),
                         qPrintable(where));
                QVERIFY2(f.ok() ? std::isfinite(f.value) && isFinite(f.gradient) : holdsNoNumber(f), qPrintable(where));
                (d.ok() ? answers : failures) += 1;
            }
    }
    QVERIFY2(failures > 200 && answers > 200, qPrintable(QString("%1 %2").arg(failures).arg(answers)));
}

static const test::Registered<CausesTest> registered;
#include "causes_test.moc"
