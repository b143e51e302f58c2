// Means over the surface do not know how it is sampled; hollows and curvature are those of the shape.
#include "clouds.h"
#include "core/base/error.h"
#include "core/selection/blur.h"
#include "core/selection/quantities.h"
#include "support/registry.h"

#include <QTest>

using namespace selection;
using test::Place;

class BlurTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void blurKeepsConstantsAndBounds();
    void blurIsTheWeightedMeanOfAllPairs();
    void blurDoesNotKnowTheDensity();
    void sharpeningIsTheOppositeStep();
    void cavityOfABallIsItsCurvature();
    void curvatureOfABallIsOnTheRamp();
    void rangesHoldWhatBruteForceFinds();
};

static surface::Surface inwards(const surface::Surface& surface) {
    return test::changed(surface, [](surfel::Surfel& s) { s.normal = -s.normal; });
}

void BlurTest::blurKeepsConstantsAndBounds() {
    const surface::Surface ball = test::unevenBall(test::seed(), 1500);
    const surface::Surface full = test::withField(ball, [](const surfel::Surfel&) { return 0.7; });
    QVERIFY(blurred(full, Field::Selection, 0.2) == full.tree());
    QVERIFY(blurred(ball, Field::Selection, 0.2) == ball.tree());
    const surface::Surface part = test::withField(ball, [](const surfel::Surfel& s) { return s.position.z > 0; });
    const tree::SurfelTree soft = blurred(part, Field::Selection, 0.2);
    test::forSurfels(soft, [&](const Place& at, const surfel::Surfel& s) {
        const float v = test::selectionAt(soft, at);
        QVERIFY(v >= 0 && v <= 1);
        if (std::abs(s.position.z) > 0.45f) // farther than the widest radius: that bit of the field stays
            QCOMPARE(v, s.position.z > 0 ? 1.0f : 0.0f);
    });
}

void BlurTest::blurIsTheWeightedMeanOfAllPairs() {
    const surface::Surface ball = test::unevenBall(test::seed(), 500, 0.02);
    const surface::Surface start = test::withField(ball, [](const surfel::Surfel& s) { return s.colour % 5 / 4.0; });
    const double radius = 0.9; // above what links reach over: these would count instead
    const tree::SurfelTree soft = blurred(start, Field::Selection, radius);
    std::vector<std::pair<Place, surfel::Surfel>> all;
    test::forSurfels(start.tree(), [&](const Place& at, const surfel::Surfel& s) { all.push_back({at, s}); });
    for (const auto& [at, s] : all) {
        double sum = 0, weights = 0;
        for (const auto& [other, t] : all) {
            const double l = double(length(t.position - s.position)) / radius;
            if (l >= 1 || (at != other && !(dot(s.normal, t.normal) > 0)))
                continue;
            const double w = std::pow(1 - l, 4) * (4 * l + 1) * double(t.support) * double(t.support);
            sum += w * double(test::selectionAt(start.tree(), other)), weights += w;
        }
        QVERIFY2(std::abs(double(test::selectionAt(soft, at)) - sum / weights) < 1e-4,
                 test::seedText(test::seed()).c_str());
    }
}

void BlurTest::blurDoesNotKnowTheDensity() {
    // A half selected: at the line between both the mean is one half, though one side is 16 times as dense.
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    for (int i = -40; i < 40; ++i)
        for (int j = -40; j < 40; ++j) {
            if (i < 0 && i >= -20 && j >= -20 && j < 20)
                points.append(test::surfelAt({(i + 0.5) * 0.1, (j + 0.5) * 0.1, 0}, {0, 0, 1}, 0.1), {});
            if (i >= 0)
                points.append(test::surfelAt({(i + 0.5) * 0.025, (j + 0.5) * 0.05, 0}, {0, 0, 1}, 0.0353553), {});
        }
    const surface::Surface start =
        test::withField(test::surfaceOf(points), [](const surfel::Surfel& s) { return s.position.x > 0; });
    const tree::SurfelTree soft = blurred(start, Field::Selection, 0.6);
    int seen = 0;
    test::forSurfels(soft, [&](const Place& at, const surfel::Surfel& s) {
        if (std::abs(s.position.y) < 1 && s.position.x > 0 && s.position.x < 0.03f) {
            ++seen;
            QVERIFY(std::abs(test::selectionAt(soft, at) - 0.52f) < 0.06f);
        }
    });
    QVERIFY(seen > 10);
}

void BlurTest::sharpeningIsTheOppositeStep() {
    const surface::Surface ball = test::unevenBall(test::seed(), 800);
    const surface::Surface start =
        test::withField(ball, [](const surfel::Surfel& s) { return 0.5 + 0.2 * double(s.position.z); });
    const tree::SurfelTree soft = blurred(start, Field::Selection, 0.4),
                           hard = sharpened(start, Field::Selection, 0.4, 1);
    test::forSurfels(soft, [&](const Place& at, const surfel::Surfel&) {
        const float v = test::selectionAt(start.tree(), at);
        QVERIFY(std::abs(test::selectionAt(soft, at) + test::selectionAt(hard, at) - 2 * v) < 1e-5f);
    });
    QVERIFY(sharpened(start, Field::Selection, 0.4, 0) == start.tree());
}

void BlurTest::cavityOfABallIsItsCurvature() {
    const surface::Surface ball = test::surfaceOf(test::spherePoints(8000));
    const double radius = 0.3;
    const tree::SurfelTree hollow = fromCavity(inwards(ball), Field::Mask, radius, 1);
    test::forSurfels(hollow, [&](const Place&, const surfel::Surfel& s) {
        QVERIFY2(std::abs(double(s.mask) - radius) < 0.03 * radius, qPrintable(QString::number(double(s.mask))));
    });
    QVERIFY(fromCavity(ball, Field::Mask, radius, 1) == ball.tree()); // a ridge everywhere: free as before
    auto layout = std::make_shared<surfel::AttributeLayout>(*ball.tree().layout());
    layout->oriented = false;
    QVERIFY_EXCEPTION_THROWN(fromCavity({ball.tree().withLayout(layout), {}}, Field::Mask, 0.3, 1), base::Error);
}

void BlurTest::curvatureOfABallIsOnTheRamp() {
    for (const surface::Surface& ball :
         {test::surfaceOf(test::spherePoints(3000)), inwards(test::surfaceOf(test::spherePoints(3000)))}) {
        const tree::SurfelTree masked = fromCurvature(ball, Field::Mask, 0.5, 1.5);
        test::forSurfels(masked,
                         [](const Place&, const surfel::Surfel& s) { QVERIFY(std::abs(s.mask - 0.5f) < 0.05f); });
    }
}

void BlurTest::rangesHoldWhatBruteForceFinds() {
    const base::Vec3d origin{1e7, -1e7, 3};
    const surface::Surface ball = test::unevenBall(test::seed(), 1000);
    const auto same = [&](const tree::Selection& found, const auto& holds) {
        QVERIFY(test::placesOf(found) == test::placesOf(test::those(ball.tree(), holds)));
    };
    same(inRange(ball, "y", -1e7 - 0.5, -1e7 + 0.25, origin),
         [](const surfel::Surfel& s) { return s.position.y >= -0.5f && s.position.y <= 0.25f; });
    same(inRange(ball, "green", 30, 90),
         [](const surfel::Surfel& s) { return (s.colour >> 8 & 255u) >= 30 && (s.colour >> 8 & 255u) <= 90; });
    same(inRange(ball, "normal-x", 0.5, 2), [](const surfel::Surfel& s) { return s.normal.x >= 0.5f; });
    same(nearColour(ball.tree(), surfel::rgba(128, 128, 128), 100), [](const surfel::Surfel& s) {
        double sum = 0;
        for (unsigned c = 0; c < 3; ++c)
            sum += std::pow(double(s.colour >> 8 * c & 255u) - 128, 2);
        return sum <= 10000;
    });
    same(facing(ball.tree(), {0, 0, 3}, 0.7),
         [](const surfel::Surfel& s) { return double(s.normal.z) >= std::cos(0.7); });
    QCOMPARE(tree::sizeOf(inRange(ball, "hue", 0, 360)), ball.tree().size());
    QVERIFY_EXCEPTION_THROWN(inRange(ball, "weight", 0, 1), base::Error);
}

static const test::Registered<BlurTest> registered;
#include "blur_test.moc"
