// Scans in different light, blended.
#include "core/base/random.h"
#include "core/process/registering/colour_blend.h"
#include "core/surfel/colour_light.h"
#include "support/registry.h"
#include "support/threads.h"

#include <cmath>
#include <QTest>

using base::Vec3d;
using process::BlendedColours;

class ColourBlendTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void factorsOfLightAreFound();
    void whatAgreesStaysAsItIs();
    void whatIsLeftFadesOut();
    void scansApartKeepTheirColours();
    void theSameAtAnyThreadCount();
};

namespace {

struct Scans {
    surfel::SurfelList points;
    std::vector<std::uint32_t> scanOf;
    std::vector<Vec3d> truth; ///< linear light of the thing
};

surfel::Colour colourOf(const Vec3d& light) {
    const auto level = [](double v) {
        return static_cast<std::uint8_t>(std::lround(255 * base::srgbOf(std::clamp(v, 0.0, 1.0))));
    };
    return surfel::rgba(level(light.x), level(light.y), level(light.z));
}

/// Three strips of a picture, each with a third of the next, the middle one in the light `gain`; `tilt`: it is brighter
/// at one end by that.
Scans strips(const Vec3d& gain, double tilt, base::Random& random) {
    Scans out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->colours = true;
    out.points.layout = layout;
    for (std::uint32_t scan = 0; scan < 3; ++scan)
        for (int k = 0; k < 4000; ++k) {
            const double x = random.uniform(0, 1.5) + scan, y = random.uniform(0, 1);
            const Vec3d truth{0.3 + 0.15 * std::sin(5 * x), 0.3 + 0.15 * std::cos(7 * y),
                              0.25 + 0.1 * std::sin(4 * x * y)};
            const double more = scan == 1 ? 1 + tilt * (x - 1.75) : 1;
            surfel::Surfel s;
            s.position = base::cast<float>(Vec3d{x, y, 0});
            s.colour = colourOf(scan == 1 ? Vec3d{truth.x * gain.x, truth.y * gain.y, truth.z * gain.z} * more : truth);
            out.points.items.push_back(s);
            out.scanOf.push_back(scan);
            out.truth.push_back(truth);
        }
    return out;
}

} // namespace

void ColourBlendTest::factorsOfLightAreFound() {
    base::Random random(test::seed());
    const Vec3d gain{random.uniform(0.6, 1.6), random.uniform(0.6, 1.6), random.uniform(0.6, 1.6)};
    const Scans scans = strips(gain, 0, random);
    const BlendedColours found = process::blendColours(scans.points, scans.scanOf, 3, 0);
    for (std::size_t c = 0; c < 3; ++c) {
        QVERIFY2(std::abs(found.gains[0][c] / found.gains[1][c] / gain[c] - 1) < 0.02,
                 qPrintable(QString("%1 for %2, seed %3")
                                .arg(found.gains[0][c] / found.gains[1][c])
                                .arg(gain[c])
                                .arg(test::seed())));
        QVERIFY(std::abs(found.gains[0][c] / found.gains[2][c] - 1) < 0.02);
        // Brightness as a whole stays: the logarithms' sum is zero.
        QVERIFY(std::abs(found.gains[0][c] * found.gains[1][c] * found.gains[2][c] - 1) < 1e-3);
    }
    QVERIFY(found.after < 0.4 * found.before);
}

/// To the digit, where nothing has to change.
void ColourBlendTest::whatAgreesStaysAsItIs() {
    base::Random random(test::seed());
    Scans scans = strips({1, 1, 1}, 0, random);
    for (surfel::Surfel& each : scans.points.items)
        each.colour = surfel::rgba(90, 140, 200);
    const BlendedColours found = process::blendColours(scans.points, scans.scanOf, 3, 10);
    for (const surfel::Colour each : found.colours)
        QCOMPARE(each, surfel::rgba(90, 140, 200));
}

void ColourBlendTest::whatIsLeftFadesOut() {
    base::Random random(test::seed());
    const Scans scans = strips({1, 1, 1}, 0.4, random);
    const BlendedColours plain = process::blendColours(scans.points, scans.scanOf, 3, 0),
                         soft = process::blendColours(scans.points, scans.scanOf, 3, 8);
    QVERIFY2(soft.after < 0.5 * plain.after, qPrintable(QString("%1 of %2").arg(soft.after).arg(plain.after)));
    // Far from where they overlap a scan is as it was.
    for (std::size_t i = 0; i < scans.scanOf.size(); ++i)
        if (scans.points.items[i].position.x < 0.4f)
            QVERIFY(length(surfel::lightOf(soft.colours[i]) - surfel::lightOf(plain.colours[i])) < 0.01);
}

void ColourBlendTest::scansApartKeepTheirColours() {
    base::Random random(test::seed());
    Scans scans = strips({1.5, 1, 0.7}, 0, random);
    for (std::size_t i = 0; i < scans.scanOf.size(); ++i)
        scans.points.items[i].position.z = 50.0f * static_cast<float>(scans.scanOf[i]);
    const BlendedColours found = process::blendColours(scans.points, scans.scanOf, 3, 10);
    QCOMPARE(found.pairs, std::size_t(0));
    for (std::size_t i = 0; i < scans.scanOf.size(); ++i)
        QCOMPARE(found.colours[i], scans.points.items[i].colour);
}

void ColourBlendTest::theSameAtAnyThreadCount() {
    base::Random random(test::seed());
    const Scans scans = strips({1.3, 1, 0.8}, 0.2, random);
    const auto blended = [&] { return process::blendColours(scans.points, scans.scanOf, 3, 6).colours; };
    QVERIFY(test::onThreads(1, blended) == test::onThreads(3, blended));
}

static const test::Registered<ColourBlendTest> registered;
#include "colour_blend_test.moc"
