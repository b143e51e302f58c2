// Changes of shape against shapes that are known: balls stay balls, graphs have the normals of graphs.
#include "clouds.h"
#include "core/base/error.h"
#include "core/selection/shape.h"
#include "core/selection/shell.h"
#include "support/registry.h"

#include <QTest>

using namespace selection;
using base::Vec3d;
using test::Place;

class ShapeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void smoothingTakesNoiseAndLeavesTheBall();
    void sharpeningUndoesNoSmoothBall();
    void inflatedBallsAreBalls();
    void noiseHasItsSlope();
    void raisedPlanesAreGraphs();
    void softSelectionsRaiseGraphs();
    void whatIsMaskedOrNotSelectedKeepsEveryBit();
    void shellsOfCapsHaveWalls();
    void shellsOfClosedModelsAreHollow();
};

static double roughness(const surface::Surface& surface) {
    double sum = 0;
    for (const surfel::Surfel& s : surface.tree().surfels().items)
        sum += std::pow(double(length(s.position)) - test::meanRadius(surface), 2);
    return std::sqrt(sum / double(surface.tree().size()));
}

static surface::Surface noisyBall(double noise) {
    base::Random random(test::seed());
    return test::changed(test::surfaceOf(test::spherePoints(3000)), [&](surfel::Surfel& s) {
        s.position = s.position * static_cast<float>(1 + noise * random.normal());
    });
}

void ShapeTest::smoothingTakesNoiseAndLeavesTheBall() {
    const surface::Surface ball = noisyBall(0.005), smooth = smoothed(ball, 2, 1, Limit::Everything);
    QVERIFY2(roughness(smooth) < 0.35 * roughness(ball), qPrintable(QString::number(roughness(smooth))));
    QVERIFY(std::abs(test::meanRadius(smooth) - 1) < 0.003);
    smooth.tree().validate();
}

void ShapeTest::sharpeningUndoesNoSmoothBall() {
    const surface::Surface ball = noisyBall(0.005), hard = smoothed(ball, 2, -0.5, Limit::Everything);
    QVERIFY(roughness(hard) > 1.3 * roughness(ball));
    const surface::Surface exact = test::surfaceOf(test::spherePoints(3000));
    QVERIFY(roughness(smoothed(exact, 2, -0.5, Limit::Everything)) < 0.002);
}

void ShapeTest::inflatedBallsAreBalls() {
    const surface::Surface ball = test::surfaceOf(test::spherePoints(3000));
    for (const double by : {0.5, -0.4}) {
        const surface::Surface next = raised(
            ball,
            [&](const Vec3d&) {
                return Height{by, {}};
            },
            Limit::Everything);
        test::forSurfels(next.tree(), [&](const Place&, const surfel::Surfel& s) {
            QVERIFY(std::abs(double(length(s.position)) - 1 - by) < 1e-5);
            QVERIFY(dot(s.position, s.normal) > (1 + float(by)) * 0.9999f);
            const double support = test::sphereSpacing(3000) * std::sqrt(38 / std::numbers::pi) * (1 + by);
            QVERIFY(std::abs(double(s.support) - support) < 0.02 * support);
        });
    }
}

void ShapeTest::noiseHasItsSlope() {
    base::Random random(test::seed());
    double most = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3d x = random.unitVector() * (20 * random.uniform());
        const Height at = noiseAt(x, 0.7, 5);
        most = std::max(most, std::abs(at.value));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Vec3d step;
            step[axis] = 1e-5;
            const double slope = (noiseAt(x + step, 0.7, 5).value - noiseAt(x - step, 0.7, 5).value) / 2e-5;
            QVERIFY2(std::abs(slope - at.slope[axis]) < 1e-5, test::seedText(test::seed()).c_str());
        }
    }
    QVERIFY(most > 0.4 && most <= 1);
    QVERIFY(noiseAt({0.3, 0.1, 0.2}, 1, 5).value != noiseAt({0.3, 0.1, 0.2}, 1, 6).value);
}

void ShapeTest::raisedPlanesAreGraphs() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(60, 0.05));
    const auto wave = [](const Vec3d& x) { return Height{0.1 * std::sin(3 * x.x), {0.3 * std::cos(3 * x.x), 0, 0}}; };
    const surface::Surface next = raised(plane, wave, Limit::Everything);
    test::forSurfels(next.tree(), [&](const Place&, const surfel::Surfel& s) {
        const double x = double(s.position.x);
        const Vec3d n = normalized(Vec3d{-0.3 * std::cos(3 * x), 0, 1});
        QVERIFY(std::abs(double(s.position.z) - 0.1 * std::sin(3 * x)) < 1e-6);
        QVERIFY(distance(base::cast<double>(s.normal), n) < 1e-4);
    });
}

void ShapeTest::softSelectionsRaiseGraphs() {
    const auto weight = [](double x, double y) { return std::exp(-2 * (x * x + y * y)); };
    const surface::Surface plane =
        test::withField(test::surfaceOf(test::planePoints(70, 0.05)),
                        [&](const surfel::Surfel& s) { return weight(double(s.position.x), double(s.position.y)); });
    const surface::Surface next = raised(
        plane,
        [](const Vec3d&) {
            return Height{0.3, {}};
        },
        Limit::Selection);
    test::forSurfels(next.tree(), [&](const Place&, const surfel::Surfel& s) {
        const double x = double(s.position.x), y = double(s.position.y), w = weight(x, y);
        QVERIFY(std::abs(double(s.position.z) - 0.3 * w) < 1e-5);
        if (std::max(std::abs(x), std::abs(y)) < 1.3)
            QVERIFY(dot(base::cast<double>(s.normal), normalized(Vec3d{1.2 * x * w, 1.2 * y * w, 1})) > 0.999);
    });
}

void ShapeTest::whatIsMaskedOrNotSelectedKeepsEveryBit() {
    const surface::Surface ball =
        test::withField(noisyBall(0.003), [](const surfel::Surfel& s) { return s.position.x > 0; });
    const surface::Surface masked(rewritten(ball.tree(), Field::Mask,
                                            [](std::uint32_t, const surfel::SurfelBlock& block, BlockValues& values) {
                                                for (int slot = 0; slot < block.size(); ++slot)
                                                    values[static_cast<std::size_t>(slot)] =
                                                        block.position(slot).y > 0 ? 1.0f : 0.0f;
                                            }),
                                  ball.definition());
    const auto lift = [](const Vec3d& x) { return Height{0.1 * x.z, {0, 0, 0.1}}; };
    for (const surface::Surface& next :
         {smoothed(masked, 2, 1, Limit::Selection), raised(masked, lift, Limit::Selection)}) {
        const surfel::SurfelList before = masked.tree().surfels(), after = next.tree().surfels();
        std::size_t moved = 0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const base::Vec3f p = before.items[i].position;
            if (p.x > 0 && !(p.y > 0))
                moved += before.items[i].position != after.items[i].position;
            else
                QVERIFY(before.items[i] == after.items[i]);
        }
        QVERIFY(moved > 600);
    }
}

void ShapeTest::shellsOfCapsHaveWalls() {
    const surface::Surface cap = test::withField(test::surfaceOf(test::spherePoints(4000)),
                                                 [](const surfel::Surfel& s) { return s.position.z > 0; });
    for (const ShellSide side : {ShellSide::In, ShellSide::Out}) {
        const surface::Surface shell = shellOf(cap, 0.25, side, Limit::Selection);
        shell.tree().validate();
        const double far = side == ShellSide::In ? 0.75 : 1.25;
        std::size_t kept = 0, other = 0, wall = 0;
        test::forSurfels(shell.tree(), [&](const Place&, const surfel::Surfel& s) {
            const double r = double(length(s.position)), facing = double(dot(s.position, s.normal)) / r;
            const bool outer = facing > 0.99, inner = facing < -0.99;
            if (outer || inner) {
                const bool first = outer == (side == ShellSide::In);
                QVERIFY(std::abs(r - (first ? 1 : far)) < 1e-5);
                ++(first ? kept : other);
            } else {
                ++wall;
                QVERIFY(r > std::min(1.0, far) - 0.01 && r < std::max(1.0, far) + 0.01);
                QVERIFY(std::abs(double(s.position.z)) < 0.08 && s.normal.z < -0.98f);
            }
        });
        QVERIFY(kept == other && kept == tree::sizeOf(selectedIn(cap.tree())));
        const double area = std::numbers::pi * std::abs(far * far - 1), s = test::sphereSpacing(4000);
        QVERIFY2(double(wall) * s * s > 0.7 * area && double(wall) * s * s < 1.4 * area,
                 qPrintable(QString::number(double(wall) * s * s / area)));
    }
}

void ShapeTest::shellsOfClosedModelsAreHollow() {
    const surface::Surface ball = test::surfaceOf(test::spherePoints(3000));
    const surface::Surface shell = shellOf(ball, 0.3, ShellSide::In, Limit::Everything);
    QCOMPARE(shell.tree().size(), 2 * ball.tree().size());
    QVERIFY_EXCEPTION_THROWN(shellOf(ball, 0.3, ShellSide::In, Limit::Selection), base::Error);
}

static const test::Registered<ShapeTest> registered;
#include "shape_test.moc"
