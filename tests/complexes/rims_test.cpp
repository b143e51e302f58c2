// Where complexes end: closed loops along the curves that bound one patch.
#include "core/complexes/rims.h"

#include "complexes/sample_complexes.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using complexes::Complex, complexes::findRims;
using surface::BoundaryCurve, surface::BoundaryPoint;

class RimsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aSquareHasOneRim();
    void rimsOfTheGasketAreClosedAndBoundItsHoles();
    void closedOnesHaveNone();
};

void RimsTest::aSquareHasOneRim() {
    const std::vector<BoundaryCurve> rims = findRims(complex_models::complexOf("square", 1500));
    QCOMPARE(rims.size(), std::size_t(1));
    QVERIFY(rims[0].closed);
    QVERIFY2(std::abs(rims[0].length() - 8) < 1e-3, qPrintable(QString::number(rims[0].length())));
    for (const BoundaryPoint& p : rims[0].points) {
        const double x = std::abs(p.position.x), y = std::abs(p.position.y);
        QVERIFY(std::abs(std::max(x, y) - 1) < 1e-6 && std::abs(p.position.z) < 1e-6);
        QVERIFY(std::abs(std::abs(p.normal.z) - 1) < 1e-6);
        if (std::min(x, y) < 0.9) {
            const Vec3d out = x > y ? Vec3d{p.position.x, 0, 0} : Vec3d{0, p.position.y, 0};
            QVERIFY2(dot(p.outward, out) > 0.999, qPrintable(QString("%1 %2").arg(p.position.x).arg(p.position.y)));
        }
    }
}

/// Each point of a rim has the patch on one side and nothing on the other.
void RimsTest::rimsOfTheGasketAreClosedAndBoundItsHoles() {
    const Complex gasket = complex_models::complexOf("gasket", 3000);
    const std::vector<BoundaryCurve> rims = findRims(gasket);
    QVERIFY(!rims.empty());
    for (const BoundaryCurve& rim : rims) {
        QVERIFY(rim.closed);
        QVERIFY(rim.length() > 0);
        for (const BoundaryPoint& p : rim.points) {
            QVERIFY(std::abs(length(p.normal) - 1) < 1e-9 && std::abs(length(p.outward) - 1) < 1e-9);
            QVERIFY(std::abs(dot(p.normal, p.outward)) < 1e-6);
        }
    }
}

void RimsTest::closedOnesHaveNone() {
    for (const char* id : {"icosahedron", "rounded", "bulged"})
        QVERIFY2(findRims(complex_models::complexOf(id, 1500)).empty(), id);
}

static const test::Registered<RimsTest> registered;
#include "rims_test.moc"
