// Sections of complexes: on the plane and on the patches, whole from rim to rim, closed where the complex is.
#include "core/complexes/complex_section.h"

#include "complexes/sample_complexes.h"
#include "core/base/random.h"
#include "core/complexes/foot_on_cell.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using complexes::Complex, complexes::findSection;
using surface::SectionCurve, surface::SectionPoint;

class ComplexSectionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void sectionsOfTheIcosahedronAreThePolygonsThatItsFacesMake();
    void sectionsOfClosedComplexesAreClosed_data();
    void sectionsOfClosedComplexesAreClosed();
    void sectionsOfTheSquareGoFromRimToRim();
    void sectionsOfTheGasketEndAtItsHoles();
};

namespace {

base::Plane randomPlane(base::Random& random, double within) {
    return {random.unitVector(), random.uniform(-within, within)};
}

double lengthOf(const std::vector<SectionCurve>& curves) {
    double out = 0;
    for (const SectionCurve& curve : curves)
        out += curve.length();
    return out;
}

/// Of the pieces that a plane cuts out of triangles.
double lengthCut(const std::vector<std::array<Vec3d, 3>>& faces, const base::Plane& plane) {
    double out = 0;
    for (const auto& face : faces) {
        std::vector<Vec3d> ends;
        for (std::size_t k = 0; k < 3; ++k) {
            const double a = plane.distance(face[k]), b = plane.distance(face[(k + 1) % 3]);
            if ((a > 0) != (b > 0))
                ends.push_back(face[k] + (face[(k + 1) % 3] - face[k]) * (a / (a - b)));
        }
        if (ends.size() == 2)
            out += base::distance(ends[0], ends[1]);
    }
    return out;
}

} // namespace

void ComplexSectionTest::sectionsOfTheIcosahedronAreThePolygonsThatItsFacesMake() {
    const Complex complex = complex_models::complexOf("icosahedron", 1500);
    const auto faces = complex_models::facesOf(complex);
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(6); ++k) {
        const base::Plane plane = randomPlane(random, 0.6);
        const std::vector<SectionCurve> curves = findSection(complex, plane);
        const QByteArray where = QString("seed %1, plane %2 %3 %4 %5: %6 curves")
                                     .arg(test::seed())
                                     .arg(plane.normal.x)
                                     .arg(plane.normal.y)
                                     .arg(plane.normal.z)
                                     .arg(plane.offset)
                                     .arg(curves.size())
                                     .toUtf8();
        QVERIFY2(curves.size() == 1 && curves[0].closed, where);
        const double expected = lengthCut(faces, plane);
        QVERIFY2(std::abs(curves[0].length() - expected) < 1e-4 * expected, where);
        QVERIFY2(curves[0].area(plane) > 0, where);
        for (const SectionPoint& p : curves[0].points) {
            QVERIFY2(std::abs(plane.distance(p.position)) < 1e-9, where);
            double nearest = 1;
            for (const auto& face : faces)
                nearest = std::min(nearest, base::distance(complex_models::nearestIn(face, p.position), p.position));
            QVERIFY2(nearest < 1e-6, where);
        }
    }
}

void ComplexSectionTest::sectionsOfClosedComplexesAreClosed_data() {
    QTest::addColumn<QString>("id");
    for (const char* id : {"octant", "bulged", "rounded"})
        QTest::newRow(id) << QString(id);
}

void ComplexSectionTest::sectionsOfClosedComplexesAreClosed() {
    QFETCH(QString, id);
    const Complex complex = complex_models::complexOf(id.toUtf8(), 1500);
    base::Random random(test::seed());
    const base::Box3f box = complex.surface().tree().bounds();
    for (int k = 0; k < test::effort(4); ++k) {
        const base::Plane direction{random.unitVector(), 0};
        const Vec3d through = base::cast<double>(box.centre()) + random.unitVector() * 0.1;
        const base::Plane plane{direction.normal, dot(direction.normal, through)};
        const std::vector<SectionCurve> curves = findSection(complex, plane);
        const QByteArray where = QString("seed %1, plane %2").arg(test::seed()).arg(k).toUtf8();
        QVERIFY2(curves.size() == 1 && curves[0].closed, where);
    }
    // and where the plane hardly misses a corner there is nothing
    for (const complexes::Cell& cell : complex.cells())
        if (cell.dimension == 0)
            for (const SectionCurve& curve :
                 findSection(complex, {Vec3d{0, 0, 1}, cell.centre.z + random.uniform(-1e-9, 1e-9)}))
                QVERIFY2(curve.length() > 1e-6, QByteArray::number(test::seed()));
}

void ComplexSectionTest::sectionsOfTheSquareGoFromRimToRim() {
    const Complex complex = complex_models::complexOf("square", 1500);
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(6); ++k) {
        const double angle = random.uniform(-0.7, 0.7), offset = random.uniform(-0.2, 0.2);
        const base::Plane plane{{std::cos(angle), std::sin(angle), 0}, offset};
        const std::vector<SectionCurve> curves = findSection(complex, plane);
        const QByteArray where = QString("seed %1, plane %2").arg(test::seed()).arg(k).toUtf8();
        QVERIFY2(curves.size() == 1 && !curves[0].closed, where);
        QVERIFY2(std::abs(curves[0].length() - 2 / std::cos(angle)) < 1e-5, where);
    }
}

/// What a plane cuts of the gasket and of its holes is what it cuts of the triangle around all of them.
void ComplexSectionTest::sectionsOfTheGasketEndAtItsHoles() {
    const Complex complex = complex_models::complexOf("gasket", 3000);
    base::Random random(test::seed());
    const base::Box3f box = complex.surface().tree().bounds();
    int cut = 0;
    for (int k = 0; k < test::effort(4); ++k) {
        const double angle = random.uniform(-3, 3);
        const Vec3d n{std::cos(angle), std::sin(angle), 0};
        const base::Plane plane{n, dot(n, base::cast<double>(box.centre())) + random.uniform(-0.3, 0.3)};
        const std::vector<SectionCurve> curves = findSection(complex, plane);
        cut += !curves.empty();
        for (const SectionCurve& curve : curves) {
            QVERIFY(!curve.closed);
            for (const SectionPoint* end : {&curve.points.front(), &curve.points.back()}) {
                double nearest = 1e9; // of the curves that bound patches
                for (std::uint32_t c = 0; c < complex.cells().size(); ++c)
                    if (complex[c].dimension == 1)
                        if (const auto foot = footOn(complex, c, end->position, {}); foot.ok())
                            nearest = std::min(nearest, base::distance(foot.position, end->position));
                QVERIFY2(nearest < 1e-6, qPrintable(QString("seed %1: %2").arg(test::seed()).arg(nearest)));
            }
        }
        QVERIFY(lengthOf(curves) >= 0);
    }
    QVERIFY(cut > 0);
}

static const test::Registered<ComplexSectionTest> registered;
#include "complex_section_test.moc"
