// What the tools that pull and turn do, against their formulas.
#include "core/sculpt/stroke/stroke.h"
#include "sculpt/dabs.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;
using test::applied;
using test::dabOf;

class PullToolsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void elasticGrabIsTheKelvinlet();
    void elasticGrabKeepsVolumeWhereAskedTo();
    void snakeHookWithoutTaperIsGrab();
    void taperThinsAcrossThePull();
    void aHookOfTenRadiiStaysWellSampled();
    void twistKeepsDistancesToAxisAndCentre();
    void twistTurnsTheCentreByItsAngleAndBack();
    void nudgePushesAlongTheSurface();
};

/// (before, after) of all surfels that one dab changes.
template <class Fn>
static void forMoved(const char* id, const surface::Surface& before, const Dab& dab, const Fn& fn) {
    int moved = 0;
    for (const tree::BlockEdit& change : tool(id).apply(before, dab).blocks) {
        const surfel::BlockPtr old = before.tree().block(change.block);
        for (int slot = 0; slot < old->size(); ++slot, ++moved)
            fn(old->surfel(slot), change.changed->surfel(slot));
    }
    QVERIFY2(moved > 100, id);
}

/// The tri-scale Kelvinlet in double, from the paper's formulas alone.
static base::Vec3d kelvinlet(const base::Vec3d& d, const base::Vec3d& m, double e, double poisson) {
    const auto one = [&](double radius, const base::Vec3d& x) {
        const double a = 1, b = a / (4 * (1 - poisson)), l = std::sqrt(dot(x, x) + radius * radius);
        return m * ((a - b) / l + a * radius * radius / (2 * l * l * l)) + x * (dot(x, m) * b / (l * l * l));
    };
    const double e1 = e * e, e2 = 1.21 * e1, e3 = 1.4641 * e1;
    const auto sum = [&](const base::Vec3d& x) {
        return one(e, x) - one(1.1 * e, x) * ((e3 - e1) / (e3 - e2)) + one(1.21 * e, x) * ((e2 - e1) / (e3 - e2));
    };
    return sum(d) * (length(m) / length(sum({})));
}

void PullToolsTest::elasticGrabIsTheKelvinlet() {
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(4000));
    Dab dab = dabOf(tool("elastic-grab"), {0, 0, 0.8f}, 1, 0.5f);
    dab.move = {0.06f, -0.02f, 0.1f};
    dab.falloff = Falloff::Constant; // nothing is cut off
    for (const double volume : {0.0, 0.3, 0.5}) {
        dab.parameters["volume"] = volume;
        dab.parameters["softness"] = 0.4;
        forMoved("elastic-grab", sphere, dab, [&](const surfel::Surfel& a, const surfel::Surfel& b) {
            if (distance(a.position, dab.centre) >= dab.radius)
                return;
            const base::Vec3d d = base::cast<double>(a.position - dab.centre);
            const base::Vec3d expected = kelvinlet(d, base::cast<double>(dab.move) * 0.5, 0.4, volume);
            QVERIFY(length(base::cast<double>(b.position - a.position) - expected) < 2e-6);
        });
    }
}

void PullToolsTest::elasticGrabKeepsVolumeWhereAskedTo() {
    // At Poisson ratio 1/2 the flow has no divergence: to first order a sphere keeps its volume.
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(6000));
    const auto change = [&](double volume) {
        Dab dab = dabOf(tool("elastic-grab"), {0, 0, 1}, 2.2f, 1); // all of it under the brush
        dab.move = {0, 0, 0.01f};
        dab.falloff = Falloff::Constant;
        dab.parameters["volume"] = volume;
        dab.parameters["softness"] = 0.3;
        double sum = 0;
        forMoved("elastic-grab", sphere, dab, [&](const surfel::Surfel& a, const surfel::Surfel& b) {
            sum += double(dot(b.position - a.position, a.normal));
        });
        return std::abs(sum / 6000);
    };
    QVERIFY2(change(0.5) < 2e-6 && change(0.5) < 0.05 * change(0.0),
             qPrintable(QString("%1 %2").arg(change(0.5)).arg(change(0.0))));
}

void PullToolsTest::snakeHookWithoutTaperIsGrab() {
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(8000));
    Dab dab = dabOf(tool("grab"), {0, 0, 1}, 0.4f, 1);
    dab.move = {0.01f, 0.005f, 0.03f};
    dab.parameters["plateau"] = 0.5;
    Dab hook = dab;
    hook.parameters["taper"] = 0;
    const auto a = applied(tool("grab"), sphere, dab).tree().surfels().items,
               b = applied(tool("snake-hook"), sphere, hook).tree().surfels().items;
    for (std::size_t i = 0; i < a.size(); ++i) {
        QVERIFY(distance(a[i].position, b[i].position) < 1e-6f);
        QVERIFY(distance(a[i].normal, b[i].normal) < 1e-5f);
    }
}

void PullToolsTest::taperThinsAcrossThePull() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(60, 0.02));
    for (const double taper : {0.8, -0.8}) {
        Dab dab = dabOf(tool("snake-hook"), {}, 0.4f, 1);
        dab.move = {0, 0, 0.04f};
        dab.parameters["taper"] = taper;
        forMoved("snake-hook", plane, dab, [&](const surfel::Surfel& a, const surfel::Surfel& b) {
            const double r = double(length(a.position)) / 0.4;
            if (r > 0.35)
                return;
            const double expected = 1 - taper * 0.1; // within the plateau, |m|/R = 0.1
            QVERIFY(std::abs(double(b.position.x) - expected * double(a.position.x)) < 1e-6);
            QVERIFY(std::abs(double(b.position.y) - expected * double(a.position.y)) < 1e-6);
        });
    }
}

void PullToolsTest::aHookOfTenRadiiStaysWellSampled() {
    constexpr std::size_t count = 8000;
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(count));
    const float radius = 0.25f;
    StrokeSettings settings;
    settings.tool = "snake-hook";
    settings.radius = radius;
    settings.strength = 1;
    std::vector<StrokeSample> samples;
    for (int k = 0; k <= 20; ++k)
        samples.push_back({{{0.3f, 0.98f + 0.5f * radius * float(k), 5}, {0, 0, -1}}, 1, 0});
    samples[0].ray.origin.y = 0.9f;
    const surface::Surface after = test::stroked(sphere, settings, samples);
    QVERIFY(after.tree().bounds().hi.y > 1 + 9 * radius);
    const process::Summary spacing = test::spacingOfSheets(after, test::sphereSpacing(count));
    // At the tip, a few surfels around, single ones stand farther apart.
    QVERIFY2(spacing.min >= 0.6f && spacing.max <= 3,
             qPrintable(QString("%1 to %2").arg(double(spacing.min)).arg(double(spacing.max))));
    for (const surfel::Surfel& each : after.tree().surfels().items)
        QVERIFY(after.evaluate(each.position, surface::Need::Value).samples >= 4);
}

void PullToolsTest::twistKeepsDistancesToAxisAndCentre() {
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(8000));
    base::Random random(test::seed());
    for (int k = 0; k < 10; ++k) {
        const base::Vec3f n = base::cast<float>(random.unitVector());
        Dab dab = dabOf(tool("twist"), n * 0.97f, 0.6f, float(random.uniform(-1, 1)));
        dab.areaNormal = normalized(n + base::cast<float>(random.unitVector() * 0.5));
        dab.angle = float(random.uniform(-1, 1));
        dab.falloff = falloffTable()[std::size_t(k) % (falloffTable().size() - 1)].value; // but the last, custom
        forMoved("twist", sphere, dab, [&](const surfel::Surfel& a, const surfel::Surfel& b) {
            const base::Vec3f p = a.position - dab.centre, q = b.position - dab.centre;
            QVERIFY(std::abs(dot(p - q, dab.areaNormal)) < 1e-6f);
            QVERIFY(std::abs(length(p) - length(q)) < 1e-6f);
        });
    }
}

void PullToolsTest::twistTurnsTheCentreByItsAngleAndBack() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(60, 0.02));
    Dab dab = dabOf(tool("twist"), {}, 0.4f, 0.8f);
    dab.falloff = Falloff::Constant;
    dab.angle = 0.5f;
    forMoved("twist", plane, dab, [&](const surfel::Surfel& a, const surfel::Surfel& b) {
        if (length(a.position) >= 0.4f)
            return;
        const double c = std::cos(0.4), sn = std::sin(0.4), x = double(a.position.x), y = double(a.position.y);
        QVERIFY(std::abs(double(b.position.x) - (c * x - sn * y)) < 1e-6);
        QVERIFY(std::abs(double(b.position.y) - (sn * x + c * y)) < 1e-6);
    });
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(8000));
    Dab there = dabOf(tool("twist"), {0, 0, 1}, 0.5f, 1), back = there;
    there.angle = 0.7f, back.angle = -0.35f;
    const auto before = sphere.tree().surfels().items;
    const auto after = applied(tool("twist"), applied(tool("twist"), applied(tool("twist"), sphere, there), back), back)
                           .tree()
                           .surfels()
                           .items;
    for (std::size_t i = 0; i < before.size(); ++i) {
        QVERIFY(distance(before[i].position, after[i].position) < 1e-6f);
        QVERIFY(distance(before[i].normal, after[i].normal) < 1e-5f);
    }
}

void PullToolsTest::nudgePushesAlongTheSurface() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(60, 0.02));
    for (const float strength : {0.7f, -0.7f}) {
        Dab dab = dabOf(tool("nudge"), {}, 0.4f, strength);
        dab.travel = {0.03f, -0.01f, 0.02f};
        forMoved("nudge", plane, dab, [&](const surfel::Surfel& a, const surfel::Surfel& b) {
            const float w = weight(Falloff::Smooth, length(a.position) / 0.4f) * strength;
            QVERIFY(distance(b.position, a.position + base::Vec3f{0.03f, -0.01f, 0} * w) < 1e-6f);
            QVERIFY(length(b.normal - a.normal) < 1e-6f);
        });
    }
    QVERIFY(tool("nudge").apply(plane, dabOf(tool("nudge"), {}, 0.4f, 1)).empty()); // a stroke's first dab
}

static const test::Registered<PullToolsTest> registered;
#include "pull_tools_test.moc"
