// Scans in lines: dense along them, with gaps between them that no nearest neighbours bridge.
#include "core/process/estimation/scan_lines.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "core/surface/surface.h"
#include "process/even_shapes.h"
#include "process/uneven_sphere.h"
#include "support/registry.h"

#include <numbers>
#include <QTest>

using namespace process;
using base::Vec3d, base::Vec3f;

class ScanLinesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void linesAreOneSurface();
    void evenScansKeepEveryBit();
    void curvesStayAlone();
    void threadsDoNotShow();
};

namespace {

/// The unit sphere in rings about z, so many times as far from each other as points stand on them.
surfel::SurfelList rings(int count, double times, base::Random& random) {
    surfel::SurfelList out;
    const double gap = std::numbers::pi / count, noise = 0.01 * gap;
    for (int k = 0; k < count; ++k) {
        const double polar = gap * (k + 0.5), radius = std::sin(polar);
        const double points = std::max(3.0, std::floor(2 * std::numbers::pi * radius / gap * times));
        const double start = random.uniform(0, 2 * std::numbers::pi);
        for (int j = 0; j < points; ++j) {
            const double around = start + 2 * std::numbers::pi * (j + random.uniform(-0.2, 0.2)) / points;
            out.items.push_back(
                shapes::at(Vec3d{radius * std::cos(around), radius * std::sin(around), std::cos(polar)} *
                           (1 + random.uniform(-noise, noise))));
        }
    }
    return out;
}

CloudNeighbours looked(const surfel::SurfelList& list, std::size_t& found) {
    const Cloud cloud(list.items);
    CloudNeighbours out = neighboursOf(cloud, 18, {});
    found = lookBesideLines(cloud, out);
    return out;
}

} // namespace

/// Bare points: the surface is there between the lines, too, is nearly round, and looks outwards.
void ScanLinesTest::linesAreOneSurface() {
    base::Random random(test::seed());
    for (const double times : {7.0, 10.0, 14.0}) {
        const int count = 24 + int(random.below(16));
        const surface::Surface surface = prepare(rings(count, times, random), {});
        const double gap = std::numbers::pi / count;
        int missing = 0, inwards = 0;
        for (int k = 0; k < 500; ++k) {
            const Vec3d d = random.unitVector();
            if (std::abs(d.z) > 0.9)
                continue; // about the poles rings are so small that nothing is dense along them
            const auto at = surface.evaluateReference(d);
            const bool here = at.status == surface::Status::Ok && std::abs(at.value) < 0.15 * gap;
            missing += !here;
            inwards += here && dot(at.gradient, d) < 0;
        }
        QVERIFY2(missing == 0 && inwards == 0, qPrintable(QString("1:%1, %2 rings: %3 missing, %4 inwards, seed %5")
                                                              .arg(times)
                                                              .arg(count)
                                                              .arg(missing)
                                                              .arg(inwards)
                                                              .arg(test::seed())));
    }
}

void ScanLinesTest::evenScansKeepEveryBit() {
    base::Random random(test::seed());
    std::size_t found = 0;
    looked(test::spherePoints(5000), found);
    QCOMPARE(found, std::size_t(0));
    looked(rings(60, 2, random), found);
    QCOMPARE(found, std::size_t(0));
    const surfel::SurfelList uneven = shapes::unevenSphere(20000, random);
    looked(uneven, found); // by chance 8 of random points are on a line, and hardly ever with nothing beside it
    QVERIFY2(found <= uneven.size() / 500, qPrintable(QString("%1 seed %2").arg(found).arg(test::seed())));
}

/// A wire that is far from itself.
void ScanLinesTest::curvesStayAlone() {
    surfel::SurfelList wire;
    for (int k = 0; k < 2000; ++k) {
        const double t = 0.01 * k;
        wire.items.push_back(shapes::at({std::cos(t), std::sin(t), t}));
    }
    std::size_t found = 0;
    looked(wire, found);
    QCOMPARE(found, std::size_t(0));
}

void ScanLinesTest::threadsDoNotShow() {
    base::Random random(test::seed());
    const surfel::SurfelList list = rings(20, 10, random);
    std::size_t found[2] = {};
    base::setThreadCount(1);
    const CloudNeighbours one = looked(list, found[0]);
    base::setThreadCount(2);
    const CloudNeighbours two = looked(list, found[1]);
    base::setThreadCount(0);
    QVERIFY(found[0] > list.size() / 2);
    QCOMPARE(found[0], found[1]);
    for (std::size_t i = 0; i < one.spacing.size(); ++i)
        QVERIFY(one.spacing[i] == two.spacing[i] && one.normals[i] == two.normals[i] &&
                one.table.row(i) == two.table.row(i));
}

static const test::Registered<ScanLinesTest> registered;
#include "scan_lines_test.moc"
