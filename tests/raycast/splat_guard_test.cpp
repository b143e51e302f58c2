// What discs promise before any ray is cast, held against the full cast.
#include "core/base/random.h"
#include "core/raycast/patch.h"
#include "core/raycast/splat_guard.h"
#include "raycast_models.h"
#include "support/registry.h"

#include <QTest>

using namespace raycast;
using namespace views;

class SplatGuardTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void noHitIsOutOfReach();
    void nothingNearIsBackground();
    void discsLieOnTheSurface();
    void squaresHoldTheirPixels();
    void spacingIsTheModels();
    void planesCutDiscsAway();
    void planesArePredicted();
    void biquadraticsAreReproduced();
};

static SplatGuard guardOf(const Surface& model, const ImageRays& view) {
    SplatGuard out;
    out.look(model, view, view.width, view.height, {});
    return out;
}

template <class Fn>
static void forPixels(const ImageRays& view, const Fn& fn) {
    for (int row = 0; row < view.height; ++row)
        for (int column = 0; column < view.width; ++column)
            fn(Pixel{column, row}, static_cast<std::size_t>(row * view.width + column));
}

void SplatGuardTest::noHitIsOutOfReach() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(10); ++round) {
        const Surface& model = round % 2 ? torus() : sphere();
        const ImageRays view =
            filling(random.unitVector() * 0.5, random.uniform(0.1, 1.2), random.unitVector(), 90, random.below(2) == 0);
        const SplatGuard guard = guardOf(model, view);
        const auto samples = full(model, view);
        std::size_t lost = 0;
        forPixels(view, [&](Pixel p, std::size_t i) { lost += samples[i].hit.hit && !guard.reached(p) ? 1 : 0; });
        QVERIFY2(lost == 0, qPrintable(QString("%1 lost, seed %2").arg(lost).arg(test::seed())));
    }
}

void SplatGuardTest::nothingNearIsBackground() {
    const ImageRays view = filling({}, 1.5, {0.3, 0.5, -1}, 200);
    const SplatGuard guard = guardOf(sphere(), view);
    const double support = 3.5 * shapes::sphereSpacing(8000, 1), tile = 4 * 1.5 / 100;
    std::size_t beyond = 0, reached = 0;
    forPixels(view, [&](Pixel p, std::size_t) {
        const base::Rayd ray = view.ray(p.column, p.row);
        const double passes = length(cross(ray.direction, -ray.origin));
        if (passes < 1 + support + 2 * tile)
            return;
        ++beyond;
        reached += guard.reached(p) || guard.anyDisc(p, 1) ? 1 : 0;
    });
    QVERIFY(beyond > 1000 && reached == 0);
    for (int i = 0; i < 16 * 16; ++i)
        QVERIFY(!guard.reached({i % 16, i / 16}));
    QVERIFY(guard.allReached({96, 96}, 16));
}

void SplatGuardTest::discsLieOnTheSurface() {
    for (const bool parallel : {false, true}) {
        const ImageRays view = filling({}, 1.02, {0.3, 0.5, -1}, 160, parallel);
        const SplatGuard guard = guardOf(torus(), view);
        const ViewLens lens(view);
        const auto samples = full(torus(), view);
        const double s = 0.025;
        std::size_t hits = 0, covered = 0, before = 0, tight = 0;
        forPixels(view, [&](Pixel p, std::size_t i) {
            const surface::RayHit<float>& hit = samples[i].hit;
            if (!hit.hit)
                return;
            ++hits;
            covered += guard.anyDisc(p, 1) ? 1 : 0;
            const double depth = lens.project(base::cast<double>(hit.position)).z;
            before += depth < static_cast<double>(guard.hiddenFrom(p, 1)) ? 0 : 1;
            const double behind = depth + 2.5 * s / lens.stretch(p.column, p.row);
            tight += behind > static_cast<double>(guard.hiddenFrom(p, 1)) ? 1 : 0;
        });
        // Nothing stands before a first hit; what lies more than two spacings behind it is hidden nearly everywhere.
        QVERIFY(hits > 8000 && before == 0);
        QVERIFY2(tight > hits * 8 / 10, qPrintable(QString("%1 of %2").arg(tight).arg(hits)));
        QVERIFY(covered > hits * 9 / 10);
    }
}

void SplatGuardTest::squaresHoldTheirPixels() {
    const ImageRays view = filling({}, 1.02, {0.3, 0.5, -1}, 97);
    const SplatGuard guard = guardOf(torus(), view);
    for (int size = 2; size <= SplatGuard::largestSquare; size *= 2)
        for (int row = 0; row < 97; row += size)
            for (int column = 0; column < 97; column += size) {
                float least = std::numeric_limits<float>::infinity();
                for (int y = row; y < std::min(97, row + size); ++y)
                    for (int x = column; x < std::min(97, column + size); ++x)
                        least = std::min(least, guard.hiddenFrom({x, y}, 1));
                QCOMPARE(guard.hiddenFrom({column, row}, size), least);
                QCOMPARE(guard.anyDisc({column, row}, size), std::isfinite(least));
            }
}

void SplatGuardTest::spacingIsTheModels() {
    const ImageRays view = filling({}, 1.02, {0, 0, -1}, 256);
    const double expected = shapes::sphereSpacing(8000, 1) * 128 / 1.02;
    QVERIFY(std::abs(guardOf(sphere(), view).spacingPx() / expected - 1) < 0.15);
}

void SplatGuardTest::planesCutDiscsAway() {
    const base::Plane plane{normalized(Vec3d{0, 1, 0}), 0.2};
    ImageRays view = filling({}, 1.02, {0.1, 0.2, -1}, 128);
    view.clips = {&plane, 1};
    const SplatGuard guard = guardOf(sphere(), view);
    std::size_t seen = 0, cut = 0;
    forPixels(view, [&](Pixel p, std::size_t) {
        if (!guard.anyDisc(p, 1))
            return;
        ++seen;
        cut += keptPart(view.ray(p.column, p.row), view.clips).empty() ? 1 : 0;
    });
    QVERIFY(cut == 0);
    QVERIFY(seen > 1000);
}

/// Nine samples of a surface around a pixel.
static Patch patchOf(const ImageRays& view, const ViewLens& lens, Pixel at, int half, const Surface& model,
                     std::array<double, 9>& stretch) {
    Patch out;
    std::vector<Pixel> pixels;
    for (int i = 0; i < 9; ++i)
        pixels.push_back({at.column + i % 3 * half, at.row + i / 3 * half});
    std::vector<Sample> samples(9);
    castPixels(model, view, pixels, samples);
    for (std::size_t i = 0; i < 9; ++i) {
        stretch[i] = lens.stretch(pixels[i].column, pixels[i].row);
        out.knots[i] = Knot::of(samples[i], lens, stretch[i]);
    }
    return out;
}

void SplatGuardTest::planesArePredicted() {
    const Surface model = shapes::surfaceOf(shapes::plane(60, 0.05, 0.175));
    for (const bool parallel : {false, true}) {
        const ImageRays view = filling({}, 1, {0.6, -0.3, -1}, 128, parallel);
        const ViewLens lens(view);
        std::array<double, 9> stretch;
        const Patch patch = patchOf(view, lens, {20, 30}, 24, model, stretch);
        const float error = predictionError(patch, stretch, lens, {true, false});
        QVERIFY2(error < 0.01f, qPrintable(QString::number(static_cast<double>(error))));
        Patch missing = patch;
        missing.knots[5].hit = false;
        QVERIFY(std::isinf(predictionError(missing, stretch, lens, {true, false})));
        Patch turnedOver = patch;
        turnedOver.knots[4].behind = !patch.knots[4].behind;
        QVERIFY(std::isinf(predictionError(turnedOver, stretch, lens, {true, false})));
        QVERIFY(predictionError(turnedOver, stretch, lens, {false, false}) < 0.01f);
    }
}

void SplatGuardTest::biquadraticsAreReproduced() {
    base::Random random(test::seed());
    std::array<double, 9> c;
    for (double& value : c)
        value = random.uniform(-1, 1);
    const auto f = [&](double u, double v) {
        double out = 0;
        for (std::size_t i = 0; i < 9; ++i)
            out += c[i] * std::pow(u, static_cast<double>(i % 3)) * std::pow(v, static_cast<double>(i / 3));
        return out;
    };
    Patch patch;
    for (std::size_t i = 0; i < 9; ++i)
        patch.knots[i].v[Knot::Depth] =
            static_cast<float>(f(0.5 * static_cast<double>(i % 3), 0.5 * static_cast<double>(i / 3)));
    for (int i = 0; i < 50; ++i) {
        const double u = random.uniform(), v = random.uniform();
        const float got = patch.row(static_cast<float>(v)).at(static_cast<float>(u))[Knot::Depth];
        QVERIFY2(std::abs(static_cast<double>(got) - f(u, v)) < 1e-5, qPrintable(QString("seed %1").arg(test::seed())));
    }
}

static const test::Registered<SplatGuardTest> registered;
#include "splat_guard_test.moc"
