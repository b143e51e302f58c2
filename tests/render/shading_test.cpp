#include "core/render/shading/shading.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using namespace render;
using base::Vec3f;

class ShadingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyShadingIsFoundByItsName();
    void theRayFrameIsARotationThatFacesTheEye();
    void clayUsesTheWholeRangeAndClipsNothing();
    void maskAndInsideAreDarker();
    void whatTurnsAwayAtAnOutlineStaysInItsOwnLight();
    void ditheringKeepsTheMeanOfTheBackground();
};

static int brightness(surfel::Colour c) {
    return static_cast<int>((c & 255u) + (c >> 8 & 255u) + (c >> 16 & 255u));
}

void ShadingTest::everyShadingIsFoundByItsName() {
    std::size_t at = 0;
    for (const ShadingRow& row : shadingTable()) {
        QVERIFY(shading(row.id) == row.shading);
        QCOMPARE(static_cast<std::size_t>(row.shading), at++); // the enumeration is in the table's order
    }
    try {
        shading("clay-ish");
        QFAIL("an unknown shading was found");
    } catch (const base::Error& e) {
        for (const ShadingRow& row : shadingTable())
            QVERIFY(e.message().find(row.id) != std::string::npos);
    }
}

void ShadingTest::theRayFrameIsARotationThatFacesTheEye() {
    base::Random random(test::seed());
    for (int k = 0; k < 1000; ++k) {
        const float dx = static_cast<float>(random.uniform(-1, 1)), dy = static_cast<float>(random.uniform(-1, 1));
        const Vec3f a = base::cast<float>(random.unitVector()), b = base::cast<float>(random.unitVector());
        const Vec3f ra = inRayFrame(a, dx, dy), rb = inRayFrame(b, dx, dy);
        QVERIFY(std::abs(dot(ra, rb) - dot(a, b)) < 1e-5f);
        QVERIFY(length(cross(ra, rb) - inRayFrame(cross(a, b), dx, dy)) < 1e-5f); // no reflection
        const Vec3f toEye = inRayFrame(normalized(Vec3f{-dx, -dy, 1}), dx, dy);
        QVERIFY(length(toEye - Vec3f{0, 0, 1}) < 1e-6f);
    }
}

void ShadingTest::clayUsesTheWholeRangeAndClipsNothing() {
    int least = 765, most = 0;
    for (int y = 0; y < lightSize; ++y)
        for (int x = 0; x < lightSize; ++x) {
            const float nx = 2.0f * static_cast<float>(x) / (lightSize - 1) - 1,
                        ny = 2.0f * static_cast<float>(y) / (lightSize - 1) - 1;
            if (nx * nx + ny * ny > 1)
                continue;
            const int b = brightness(shadingStyle(Shading::Matcap).light[static_cast<std::size_t>(y * lightSize + x)]);
            least = std::min(least, b), most = std::max(most, b);
        }
    QVERIFY2(least > 3 * 20 && least < 3 * 90, qPrintable(QString::number(least)));
    QVERIFY2(most > 3 * 200 && most < 3 * 252, qPrintable(QString::number(most)));
}

void ShadingTest::maskAndInsideAreDarker() {
    for (const Shading s : {Shading::Matcap, Shading::Colour, Shading::Mask}) {
        const int free = brightness(shade(s, {0, 0, 1}, surfel::white, 0));
        QVERIFY(brightness(shade(s, {0, 0, 1}, surfel::white, 0.5f)) < free);
        QVERIFY(brightness(shade(s, {0, 0, 1}, surfel::white, 1)) <
                brightness(shade(s, {0, 0, 1}, surfel::white, 0.5f)));
        QVERIFY(brightness(shade(s, {0, 0, -1}, surfel::white, 0)) < free);
    }
    QCOMPARE(shade(Shading::Matcap, {0, 0, 1}, surfel::rgba(9, 9, 9), 0),
             shade(Shading::Matcap, {0, 0, 1}, surfel::white, 0));
    QVERIFY(shade(Shading::Colour, {0, 0, 1}, surfel::rgba(255, 0, 0), 0) !=
            shade(Shading::Colour, {0, 0, 1}, surfel::white, 0));
}

void ShadingTest::whatTurnsAwayAtAnOutlineStaysInItsOwnLight() {
    for (int k = 0; k < 64; ++k) {
        const float angle = 0.1f * static_cast<float>(k);
        const Vec3f rim{std::cos(angle), std::sin(angle), 0};
        const Vec3f past = normalized(rim + Vec3f{0, 0, 0.9f * backFrom});
        const int a = brightness(shade(Shading::Matcap, rim, surfel::white, 0)),
                  b = brightness(shade(Shading::Matcap, past, surfel::white, 0));
        QVERIFY2(std::abs(a - b) <= 6, qPrintable(QString("%1: %2 %3").arg(angle).arg(a).arg(b)));
    }
}

void ShadingTest::ditheringKeepsTheMeanOfTheBackground() {
    constexpr int height = 720;
    for (int top = 0; top < height; top += 8) {
        double sum = 0, expected = 0;
        for (int row = top; row < top + 8; ++row) {
            surfel::Colour line[8];
            backgroundRow(Backdrop::Studio, row, height, false, line);
            for (const surfel::Colour c : line)
                sum += static_cast<double>(c >> 8 & 255u) / 64;
            expected += static_cast<double>(
                            background(Backdrop::Studio, (static_cast<float>(row) + 0.5f) / height) >> 8 & 255u) /
                        8;
        }
        QVERIFY(std::abs(sum - expected) < 0.7);
    }
    surfel::Colour line[8];
    backgroundRow(Backdrop::Studio, 3, height, true, line);
    QCOMPARE(line[0] >> 24, 0u);
}

static const test::Registered<ShadingTest> registered;
#include "shading_test.moc"
