// Thickness straight through, against plates, shells, balls and what is open; histograms; numbers kept with surfels.
#include "core/process/measuring/thickness.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "core/process/measuring/histogram.h"
#include "core/process/measuring/measured_attribute.h"
#include "process/even_shapes.h"
#include "process/uneven_sphere.h"
#include "support/registry.h"
#include "support/threads.h"

#include <QTest>

using namespace process;
using base::Vec3d, base::Vec3f;

class ThicknessTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void ballsAreTwiceTheirRadiusThick();
    void unevenBallsToo();
    void shellsAreAsThickAsTheirWall_data();
    void shellsAreAsThickAsTheirWall();
    void wedgesFollowTheirAngle();
    void openSheetsHaveNothingOpposite();
    void sidesAreNeeded();
    void histogramsCountAll();
    void edgesBelongToTheUpperBin();
    void attributesAreKeptAndReplaced();
    void threadsDoNotShow();
};

namespace {

QByteArray told(double is, double wanted) {
    return QByteArray::number(is, 'g', 8) + " for " + QByteArray::number(wanted, 'g', 8) + ", seed " +
           QByteArray::number(test::seed());
}

surfel::SurfelList shell(std::size_t count, double inner) {
    surfel::SurfelList out = test::spherePoints(count);
    for (surfel::Surfel s : test::spherePoints(static_cast<std::size_t>(double(count) * inner * inner)).items) {
        s.position = s.position * static_cast<float>(inner);
        s.normal = -s.normal;
        out.append(s, {});
    }
    return out;
}

} // namespace

void ThicknessTest::ballsAreTwiceTheirRadiusThick() {
    const Thicknesses found = thicknessesOf(test::surfaceOf(test::spherePoints(4000)));
    QCOMPARE(found.figures.count, std::size_t(4000));
    QCOMPARE(found.figures.none, std::size_t(0));
    for (const double each : {found.figures.min, found.figures.p1, found.figures.median, found.figures.max})
        QVERIFY2(std::abs(each - 2) < 1e-3, told(each, 2));
}

void ThicknessTest::unevenBallsToo() {
    base::Random random(test::seed());
    const surface::Surface sphere = prepare(shapes::unevenSphere(20000, random), {});
    const Thicknesses found = thicknessesOf(sphere);
    QVERIFY2(std::abs(found.figures.median - 2) < 2e-3 && found.figures.count > 19900, told(found.figures.median, 2));
    for (int k = 0; k < 20; ++k) {
        const ThicknessAt at = thicknessAt(sphere, random.unitVector() * 1.01);
        QVERIFY2(std::abs(at.thickness - 2) < 0.02 && at.leanRad < 0.2, told(at.thickness, 2));
        QVERIFY(std::abs(distance(at.foot.position, at.opposite) - at.thickness) < 1e-9);
    }
}

void ThicknessTest::shellsAreAsThickAsTheirWall_data() {
    QTest::addColumn<double>("wall");
    for (const double wall : {0.3, 0.1, 0.05}) // spacings: 9, 3, 1.5
        QTest::newRow(QByteArray::number(wall)) << wall;
}

void ThicknessTest::shellsAreAsThickAsTheirWall() {
    QFETCH(double, wall);
    const surface::Surface surface = test::surfaceOf(shell(12000, 1 - wall));
    const Thicknesses found = thicknessesOf(surface);
    QCOMPARE(found.figures.none, std::size_t(0));
    QVERIFY2(std::abs(found.figures.median - wall) < 0.01 * wall && std::abs(found.figures.p1 - wall) < 0.03 * wall &&
                 std::abs(found.figures.max - wall) < 0.05 * wall,
             told(found.figures.median, wall) + ", p1 " + told(found.figures.p1, wall) + ", max " +
                 told(found.figures.max, wall));
    const ThicknessAt inside = thicknessAt(surface, {1 - wall, 0, 0}); // from the inner wall outwards
    QVERIFY2(std::abs(inside.thickness - wall) < 0.01 * wall && inside.opposite.x > 1 - 0.5 * wall,
             told(inside.thickness, wall));
}

void ThicknessTest::wedgesFollowTheirAngle() {
    surfel::SurfelList wedge; // z = 0 looking down and z = 0.3 + 0.2 x looking up
    wedge.layout = test::orientedLayout();
    const Vec3d up = base::normalized(Vec3d{-0.2, 0, 1});
    for (int i = -30; i <= 30; ++i)
        for (int j = -30; j <= 30; ++j) {
            const double x = 0.02 * i, y = 0.02 * j;
            wedge.append(test::surfelAt({x, y, 0}, {0, 0, -1}, 0.02), {});
            wedge.append(test::surfelAt({x, y, 0.3 + 0.2 * x}, up, 0.02), {});
        }
    const surface::Surface surface = test::surfaceOf(wedge);
    for (const double x : {-0.3, 0.0, 0.25}) {
        const ThicknessAt at = thicknessAt(surface, {x, 0.1, -0.01});
        QVERIFY2(std::abs(at.thickness - (0.3 + 0.2 * x)) < 1e-6, told(at.thickness, 0.3 + 0.2 * x));
        QVERIFY2(std::abs(at.leanRad - std::atan(0.2)) < 1e-6, told(at.leanRad, std::atan(0.2)));
    }
}

void ThicknessTest::openSheetsHaveNothingOpposite() {
    const surface::Surface sheet = test::surfaceOf(test::planePoints(30, 0.05));
    const Thicknesses found = thicknessesOf(sheet);
    QVERIFY(found.figures.count == 0 && found.figures.none == sheet.tree().size());
    QVERIFY(std::isnan(thicknessAt(sheet, {0, 0, 0}).thickness));
}

void ThicknessTest::sidesAreNeeded() {
    surfel::SurfelList sphere = test::spherePoints(500);
    auto layout = std::make_shared<surfel::AttributeLayout>(*sphere.layout);
    layout->oriented = false;
    sphere.layout = layout;
    QVERIFY_THROWS_EXCEPTION(base::Error, thicknessesOf(test::surfaceOf(sphere)));
    QVERIFY_THROWS_EXCEPTION(base::Error, thicknessAt(test::surfaceOf(sphere), {1, 0, 0}));
}

void ThicknessTest::histogramsCountAll() {
    base::Random random(test::seed());
    for (int round = 0; round < 50; ++round) {
        std::vector<double> values;
        const bool sided = random.uniform() < 0.5;
        for (int k = 0; k < 300; ++k)
            values.push_back(random.uniform() < 0.1 ? std::nan("")
                                                    : random.normal() * (sided ? 1 : 0.1) + (sided ? 0 : 2));
        const auto bins = static_cast<std::size_t>(random.uniform(1, 40));
        std::optional<std::pair<double, double>> range;
        if (round % 2)
            range = {-0.7, 2.05};
        const Histogram found = histogramOf(values, bins, sided, range);
        std::vector<std::size_t> counts(bins);
        std::size_t below = 0, above = 0;
        for (const double v : values) {
            below += v<found.low, above += v> found.high;
            for (std::size_t k = 0; k < bins; ++k) // by brute force
                counts[k] += v >= found.edge(k) && (v < found.edge(k + 1) || (k + 1 == bins && v <= found.high));
        }
        QVERIFY2(counts == found.counts && below == found.below && above == found.above, told(double(bins), 0));
        QVERIFY(range || (below == 0 && above == 0 && found.low == (sided ? -found.high : 0)));
    }
}

void ThicknessTest::edgesBelongToTheUpperBin() {
    const double values[] = {-1, -0.5, 0, 0.5, 1};
    QVERIFY((histogramOf(values, 4, true).counts == std::vector<std::size_t>{1, 1, 1, 2}));
    QVERIFY((histogramOf(std::vector<double>(3, 0.0), 2, true).counts == std::vector<std::size_t>{0, 3}));
}

void ThicknessTest::attributesAreKeptAndReplaced() {
    const tree::SurfelTree plain = tree::SurfelTree::build(test::spherePoints(1000));
    std::vector<float> values;
    for (const surfel::Surfel& s : plain.surfels().items)
        values.push_back(s.position.z);
    values[7] = std::numeric_limits<float>::quiet_NaN();
    const tree::SurfelTree once = withAttribute(plain, "thickness", values);
    once.validate();
    QCOMPARE(once.blockCount(), plain.blockCount());
    values[500] = 9;
    const tree::SurfelTree twice = withAttribute(once, "thickness", values);
    twice.validate();
    QCOMPARE(tree::diff(once, twice).added.size(), std::size_t(1)); // all others are shared
    const surfel::SurfelList list = twice.surfels();
    QVERIFY(list.items == plain.surfels().items);
    const surfel::Attribute& attribute = *list.layout->find("thickness");
    for (std::size_t i = 0; i < list.size(); ++i) {
        const double is = surfel::read(attribute, list.extraOf(i));
        QVERIFY(i == 7 ? std::isnan(is) : is == double(values[i]));
    }
    std::vector<surfel::Colour> colours(list.size(), surfel::rgba(1, 2, 3));
    const tree::SurfelTree coloured = withColours(twice, colours);
    coloured.validate();
    QVERIFY(coloured.layout()->colours && coloured.surfels().items[3].colour == surfel::rgba(1, 2, 3));
    QVERIFY(coloured.surfels().extra == list.extra);
}

void ThicknessTest::threadsDoNotShow() {
    const surface::Surface surface = test::surfaceOf(shell(6000, 0.8));
    const auto work = [&] { return thicknessesOf(surface); };
    const Thicknesses one = test::onThreads(1, work), two = test::onThreads(2, work);
    QVERIFY(one.at == two.at);
}

static const test::Registered<ThicknessTest> registered;
#include "thickness_test.moc"
