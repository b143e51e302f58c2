// What hangs between two surfaces along a line of sight goes; floors at a flat angle, rims, wires and noise stay.
#include "core/process/cleaning/find_outliers.h"
#include "core/process/cleaning/mixed_pixels.h"
#include "process/beam_scan.h"
#include "support/registry.h"

#include <QTest>

using namespace process;
using base::Vec3d, scan::Scanned, scan::Scanner, scan::Solid;

class MixedPixelsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void veilsGoAndSurfacesStay_data();
    void veilsGoAndSurfacesStay();
    void thinnedScansLoseTheirVeils();
    void eachScanIsSeenFromItsOwnEye();
    void floorsAtFlatAnglesStay();
    void wiresAndRimsStay();
    void noiseIsNoVeil();
    void stepsBelowTheLimitStay();
    void threadsAndOrderDoNotShow();
    void cancelStops();
};

namespace {

/// Of a random scene from a random place.
Scanned scanOf(base::Random& random, double beam, double noise, Vec3d& eye) {
    const std::vector<Solid> scene = scan::randomScene(random);
    Scanner scanner;
    scanner.eye = eye = {random.uniform(-0.5, 0.5), random.uniform(-1, 1), random.uniform(-0.8, 0.8)};
    scanner.beam = beam, scanner.noise = noise, scanner.pitch = random.uniform(0.006, 0.01);
    return scan::scanned(scene, scanner, random);
}

struct Tally {
    double mixed = 0, found = 0, pure = 0, lost = 0;
    void add(const Scanned& scan, const std::vector<std::uint8_t>& flags) {
        for (std::size_t i = 0; i < flags.size(); ++i)
            if (scan.mixed[i])
                ++mixed, found += flags[i];
            else if (scan.pure[i])
                ++pure, lost += flags[i];
    }
    QByteArray told() const {
        return QString("found %1 of %2, lost %3 of %4, seed %5")
            .arg(found)
            .arg(mixed)
            .arg(lost)
            .arg(pure)
            .arg(test::seed())
            .toUtf8();
    }
};

/// Share of a scan of a scene without edges in depth that goes.
double lostOf(const std::vector<Solid>& scene, const Scanner& scanner, base::Random& random) {
    const Scanned seen = scan::scanned(scene, scanner, random);
    const std::vector<std::uint8_t> flags = findMixedPixels(seen.points, {{scanner.eye}, {}});
    Tally tally;
    tally.add(seen, flags);
    return tally.lost / tally.pure;
}

} // namespace

void MixedPixelsTest::veilsGoAndSurfacesStay_data() {
    QTest::addColumn<double>("beam");
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("share");
    QTest::addColumn<double>("loss"); // at edges: these scans are coarse, and edges a large part of them
    QTest::newRow("narrow") << 0.8 << 0.1 << 0.7 << 0.018;
    QTest::newRow("usual") << 1.3 << 1.0 << 0.65 << 0.012;
    QTest::newRow("wide") << 2.0 << 0.5 << 0.45 << 0.008;
}

/// Ways without a line of sight find a third of the veils of narrow beams and a twentieth of those of usual ones.
void MixedPixelsTest::veilsGoAndSurfacesStay() {
    QFETCH(double, beam);
    QFETCH(double, noise);
    QFETCH(double, share);
    QFETCH(double, loss);
    base::Random random(test::seed());
    Tally tally;
    for (int k = 0; k < test::effort(2); ++k) {
        Vec3d eye;
        const Scanned seen = scanOf(random, beam, noise, eye);
        tally.add(seen, findMixedPixels(seen.points, {{eye}, {}}));
    }
    QVERIFY2(tally.found >= share * tally.mixed, tally.told());
    QVERIFY2(tally.lost <= loss * tally.pure, tally.told());
}

void MixedPixelsTest::thinnedScansLoseTheirVeils() {
    base::Random random(test::seed());
    Tally tally;
    for (int k = 0; k < test::effort(2); ++k) {
        Vec3d eye;
        const Scanned seen = scanOf(random, 1.3, 0.5, eye);
        Scanned half;
        for (std::size_t i = 0; i < seen.points.size(); ++i)
            if (random.uniform() < 0.5) {
                half.points.items.push_back(seen.points.items[i]);
                half.mixed.push_back(seen.mixed[i]), half.pure.push_back(seen.pure[i]);
            }
        tally.add(half, findMixedPixels(half.points, {{eye}, {}}));
    }
    QVERIFY2(tally.found >= 0.6 * tally.mixed && tally.lost <= 0.02 * tally.pure, tally.told());
}

/// Two scans of one scene in one list: what one sees through a gap of the other is no edge.
void MixedPixelsTest::eachScanIsSeenFromItsOwnEye() {
    base::Random random(test::seed());
    const std::vector<Solid> scene = scan::randomScene(random);
    Eyes eyes;
    surfel::SurfelList both;
    std::vector<std::uint8_t> apart;
    for (std::uint32_t k = 0; k < 2; ++k) {
        Scanner scanner;
        scanner.eye = {random.uniform(-0.5, 0.5), k ? 1.5 : -1.5, random.uniform(-0.5, 0.5)};
        const Scanned seen = scan::scanned(scene, scanner, random);
        const std::vector<std::uint8_t> own = findMixedPixels(seen.points, {{scanner.eye}, {}});
        both.items.insert(both.items.end(), seen.points.items.begin(), seen.points.items.end());
        apart.insert(apart.end(), own.begin(), own.end());
        eyes.places.push_back(scanner.eye);
        eyes.of.resize(both.items.size(), k);
    }
    QVERIFY(findMixedPixels(both, eyes) == apart);
}

/// A floor alone, seen at 2 to 30 degrees.
void MixedPixelsTest::floorsAtFlatAnglesStay() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(2); ++k) {
        Scanner scanner;
        scanner.noise = random.uniform(0.1, 2);
        const std::vector<Solid> floor{
            {Solid::Kind::Box, {0, 0, -1.5}, {100, 100, 1 + random.uniform(0, 0.3)}, random.uniform(0, 3), 0}};
        scanner.eye = {0, 0, random.uniform(0, 0.5)};
        const double lost = lostOf(floor, scanner, random);
        QVERIFY2(lost < 0.001, QByteArray::number(lost) + ", seed " + QByteArray::number(test::seed()));
    }
}

/// Beams that are next to lines, so that nothing is mixed: all that is before the wall stays.
void MixedPixelsTest::wiresAndRimsStay() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(2); ++k) {
        std::vector<Solid> scene{{Solid::Kind::Box, {8, 0, 0}, {0.5, 20, 20}, random.uniform(-0.5, 0.5), 0}};
        for (int wire = 0; wire < 3; ++wire)
            scene.push_back({Solid::Kind::Cylinder,
                             {random.uniform(3, 5), random.uniform(-1, 1), 0},
                             {random.uniform(0.01, 0.03), 1, 2},
                             random.uniform(0, 3),
                             random.uniform(-1, 1)});
        scene.push_back({Solid::Kind::Ball, {4, 0.3, 0.2}, {random.uniform(0.2, 0.6), 1, 1}, 0, 0});
        Scanner scanner;
        scanner.beam = 0.01;
        const double lost = lostOf(scene, scanner, random);
        QVERIFY2(lost < 0.03, QByteArray::number(lost) + ", seed " + QByteArray::number(test::seed()));
    }
}

void MixedPixelsTest::noiseIsNoVeil() {
    base::Random random(test::seed());
    Scanner scanner;
    scanner.noise = 20; // two to four times the distance of the points
    const double lost =
        lostOf({{Solid::Kind::Box, {8, 0, 0}, {0.5, 20, 20}, random.uniform(-0.5, 0.5), 0}}, scanner, random);
    QVERIFY2(lost < 0.002, QByteArray::number(lost) + ", seed " + QByteArray::number(test::seed()));
}

void MixedPixelsTest::stepsBelowTheLimitStay() {
    base::Random random(test::seed());
    Vec3d eye;
    const Scanned seen = scanOf(random, 1.3, 0.1, eye);
    const auto count = [&](double limit) {
        const std::vector<std::uint8_t> flags = findMixedPixels(seen.points, {{eye}, {}}, {limit});
        return std::count(flags.begin(), flags.end(), 1);
    };
    QVERIFY(count(2) > 0);
    QVERIFY(count(10) <= count(2));
    QCOMPARE(count(1e6), 0);
}

void MixedPixelsTest::threadsAndOrderDoNotShow() {
    base::Random random(test::seed());
    Vec3d eye;
    const Scanned seen = scanOf(random, 1.3, 0.5, eye);
    base::setThreadCount(1);
    const std::vector<std::uint8_t> one = findMixedPixels(seen.points, {{eye}, {}});
    base::setThreadCount(2);
    QVERIFY(findMixedPixels(seen.points, {{eye}, {}}) == one);
    base::setThreadCount(0);
    surfel::SurfelList turned;
    turned.items.assign(seen.points.items.rbegin(), seen.points.items.rend());
    std::vector<std::uint8_t> back = findMixedPixels(turned, {{eye}, {}});
    std::reverse(back.begin(), back.end());
    QVERIFY(back == one);
}

void MixedPixelsTest::cancelStops() {
    base::Random random(test::seed());
    Vec3d eye;
    const Scanned seen = scanOf(random, 1.3, 0.5, eye);
    const std::atomic<bool> cancel = true;
    QVERIFY_EXCEPTION_THROWN(findMixedPixels(seen.points, {{eye}, {}}, {}, {{}, &cancel}), base::Cancelled);
}

static const test::Registered<MixedPixelsTest> registered;
#include "mixed_pixels_test.moc"
