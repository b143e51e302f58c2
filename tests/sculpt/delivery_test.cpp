// A stroke is its path: in few pieces or many, even or not, seen from near or far along the same rays, begun on the
// model or beside it, it makes the same thing.
#include "sculpt/random_ball.h"
#include "sculpt/random_plate.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;
using base::Vec3f;

class DeliveryTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aPathInOtherPiecesMakesTheSame_data();
    void aPathInOtherPiecesMakesTheSame();
    void aGrooveIsNoDeeperForItsOwnSlope();
    void aPathThatBeginsBesideTheModelMakesTheSame_data();
    void aPathThatBeginsBesideTheModelMakesTheSame();
    void aPathThatEndsBesideTheModelMakesTheSame_data();
    void aPathThatEndsBesideTheModelMakesTheSame();
    void aRopeFollowsTheWayAndNotItsSamples();
    void aContactAtAnOutlineFacesOutwards();
};

using Path = std::vector<StrokeSample>;

/// Looking at +x from one eye, along a bent way.
static Path bent(float from, float to) {
    Path out;
    const Vec3f eye{4, 0.3f, 0.5f};
    for (int k = 0; k <= 32; ++k) {
        const float t = float(k) / 32, y = from + (to - from) * t;
        out.push_back({{eye, normalized(Vec3f{1, y, 0.2f * std::sin(4 * t)} - eye)}, 1, t});
    }
    return out;
}

/// Each piece cut into others: evenly, or at random places.
static Path cut(const Path& path, int pieces, base::Random* random = nullptr) {
    Path out{path[0]};
    for (std::size_t k = 1; k < path.size(); ++k) {
        std::vector<float> parts{1};
        for (int i = 1; i < pieces; ++i)
            parts.push_back(random ? float(random->uniform()) : float(i) / float(pieces));
        std::sort(parts.begin(), parts.end());
        for (const float u : parts)
            out.push_back(between(path[k - 1], path[k], u));
    }
    return out;
}

struct Difference {
    float height = 0; ///< of the stroke: farthest that a surfel is from the surface before
    float apart = 0;  ///< farthest that its foot on one surface is from the other
    double marks = 0; ///< of masks and colours, as a part of what was marked; a byte more or less is dithered
};

static Difference difference(const surface::Surface& before, const surface::Surface& a, const surface::Surface& b) {
    Difference out;
    std::vector<tree::Neighbour> near;
    double marked = 0, other = 0;
    for (const surfel::Surfel& each : a.tree().surfels().items) {
        b.tree().nearest(each.position, 1, near);
        const double mask = double(each.mask), red = double(each.colour & 255);
        const double maskThere = double(near[0].block->mask(near[0].slot));
        const double redThere = double(near[0].block->surfel(near[0].slot).colour & 255);
        before.tree().nearest(each.position, 1, near);
        marked += mask + std::abs(red - double(near[0].block->surfel(near[0].slot).colour & 255)) / 255;
        other += std::max(0.0, std::abs(mask - maskThere) + (std::abs(red - redThere) - 1) / 255);
        if (near[0].distanceSq == 0)
            continue;
        const auto own = surface::project(a, each.position, {}), then = surface::project(before, each.position, {});
        if (!own.ok())
            continue;
        const auto there = surface::project(b, own.foot, {});
        if (there.ok())
            out.apart = std::max(out.apart, distance(there.foot, own.foot));
        if (then.ok())
            out.height = std::max(out.height, distance(then.foot, each.position));
    }
    out.marks = marked > 0 ? other / marked : 0;
    return out;
}

static void verifySame(const surface::Surface& start, const StrokeSettings& settings, const Path& path,
                       unsigned long long seed) {
    base::Random random(seed);
    const surface::Surface plain = test::stroked(start, settings, path);
    QVERIFY(plain.tree().contentHash() != start.tree().contentHash() || settings.tool == "smear");
    for (const Path& other : {cut(path, 16), cut(path, 5, &random)}) {
        const surface::Surface again = test::stroked(start, settings, other);
        const Difference found = difference(start, plain, again);
        const double counts = double(plain.tree().size()) / double(again.tree().size());
        const QString told = QString("apart %1 of %2, marks %3, counts %4, seed %5")
                                 .arg(found.apart)
                                 .arg(found.height)
                                 .arg(found.marks)
                                 .arg(counts)
                                 .arg(seed);
        // What moves nothing may still move by a fiftieth of the spacing, which is about 0.03.
        QVERIFY2(found.apart < std::max(0.01f * found.height, 6e-4f), qPrintable(told));
        QVERIFY2(found.marks < 0.01, qPrintable(told));
        QVERIFY2(std::abs(counts - 1) < 2e-3, qPrintable(told));
    }
}

static StrokeSettings settingsFor(const ToolRow& tool) {
    StrokeSettings out;
    out.tool = tool.id;
    out.radius = 0.25f;
    out.strength = 0.5f;
    if (tool.needs.source)
        out.parameters = {{"x", 0}, {"y", 0}, {"z", 1}};
    return out;
}

void DeliveryTest::aPathInOtherPiecesMakesTheSame_data() {
    QTest::addColumn<QString>("tool");
    for (const ToolRow& each : toolTable())
        if (!each.needs.layer)
            QTest::newRow(each.id) << each.id;
}

void DeliveryTest::aPathInOtherPiecesMakesTheSame() {
    QFETCH(QString, tool);
    const ToolRow& row = sculpt::tool(tool.toStdString());
    base::Random random(test::seed());
    const surface::Surface ball = test::randomBall(random, std::size_t(test::effort(12000)), 0.03, 0.003);
    // Pulled farther, what is held hangs over, and feet are ambiguous.
    const float half = row.motion == Motion::Drag ? 0.15f : 0.45f;
    verifySame(ball, settingsFor(row), bent(-half, half), test::seed());
}

/// The front of a groove is steep where it is dug: dabs that are spaced along it would come closer the deeper it is,
/// and it would be deeper for that.
void DeliveryTest::aGrooveIsNoDeeperForItsOwnSlope() {
    base::Random random(test::seed());
    const surface::Surface ball = test::randomBall(random, std::size_t(test::effort(20000)), 0, 0);
    const Path path = bent(-0.45f, 0.45f);
    for (const double strength : {0.5, 1.0}) {
        StrokeSettings settings = settingsFor(sculpt::tool("draw-sharp"));
        settings.strength = float(strength);
        Stroke groove(ball, settings);
        settings.strength = 0.01f;
        Stroke scratch(ball, settings);
        for (const StrokeSample& each : path)
            groove.add(each), scratch.add(each);
        QVERIFY2(groove.dabs() <= 1.25 * scratch.dabs() + 1,
                 qPrintable(QString("%1 and %2, seed %3").arg(groove.dabs()).arg(scratch.dabs()).arg(test::seed())));
    }
}

void DeliveryTest::aPathThatBeginsBesideTheModelMakesTheSame_data() {
    QTest::addColumn<QString>("tool");
    QTest::addColumn<QString>("method");
    for (const char* method : {"space", "airbrush"})
        QTest::addRow("clay, %s", method) << "clay" << method;
    QTest::newRow("grab") << "grab"
                          << "space";
    QTest::newRow("twist") << "twist"
                           << "space";
}

void DeliveryTest::aPathThatBeginsBesideTheModelMakesTheSame() {
    QFETCH(QString, tool);
    QFETCH(QString, method);
    const surface::Surface ball = test::surfaceOf(test::spherePoints(12000));
    StrokeSettings settings = settingsFor(sculpt::tool(tool.toStdString()));
    settings.method = sculpt::method(method.toStdString());
    verifySame(ball, settings, bent(-1.8f, -0.4f), test::seed());
}

void DeliveryTest::aPathThatEndsBesideTheModelMakesTheSame_data() {
    QTest::addColumn<QString>("tool");
    for (const char* tool : {"draw", "inflate", "flatten", "mask"})
        QTest::newRow(tool) << tool;
}

/// Where it leaves the model the last places count: there dabs are due that no sample may see.
void DeliveryTest::aPathThatEndsBesideTheModelMakesTheSame() {
    QFETCH(QString, tool);
    base::Random random(test::seed());
    const surface::Surface ball = test::randomBall(random, std::size_t(test::effort(8000)), 0.03, 0);
    for (const float end : {1.2f, 1.4f, 1.8f}) { // the outline lies otherwise between samples
        const Path way{bent(0.4f, end)};
        verifySame(ball, settingsFor(sculpt::tool(tool.toStdString())), {way[0], way[8], way[16], way[24], way[32]},
                   test::seed());
    }
}

void DeliveryTest::aRopeFollowsTheWayAndNotItsSamples() {
    base::Random random(test::seed());
    const surface::Surface ball = test::randomBall(random, std::size_t(test::effort(8000)), 0.03, 0);
    StrokeSettings settings = settingsFor(sculpt::tool("clay"));
    for (const float rope : {0.1f, 0.5f}) {
        settings.stabiliser = rope;
        const Path way = bent(-0.45f, 0.45f);
        verifySame(ball, settings, {way[0], way[11], way[22], way[32]}, test::seed());
    }
}

/// Where the outline is, the place where a ray comes in and where it goes out are one.
void DeliveryTest::aContactAtAnOutlineFacesOutwards() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(5); ++k) {
        const surface::Surface plate = test::randomPlate(random, {0.6, 0.5, random.uniform(0.02, 0.4)}, 0.02);
        for (int i = 0; i < 20; ++i) {
            const Vec3f view = base::cast<float>(random.unitVector()), aside = base::perpendicular(view);
            const auto touched = [&](float by) { return contact(plate, {aside * by - view * 2.0f, view}); };
            float in = 0, out = 1;
            for (int halving = 0; halving < 24; ++halving) {
                const float middle = 0.5f * (in + out);
                (touched(middle) ? in : out) = middle;
            }
            const auto last = touched(in);
            QVERIFY(last.has_value());
            const auto there = plate.evaluate(last->position, surface::Need::Gradient);
            QVERIFY2(dot(there.gradient, last->normal) > 0, qPrintable(QString("seed %1").arg(test::seed())));
        }
    }
}

static const test::Registered<DeliveryTest> registered;
#include "delivery_test.moc"
