// Near sheets as two solids (surface/README 2.7): f stays on walls however near, has no false zeros past edges, no
// jumps, and exact derivatives.
#include "core/base/parallel.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/definition_text.h"
#include "core/surface/rays/intersect.h"
#include "support/registry.h"
#include "surface/evaluation/brute_force.h"
#include "surface/near_sheets.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;
using near_sheets::Scene;

class TwoSolidsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void wallsStayWhereTheyAre_data();
    void wallsStayWhereTheyAre();
    void nothingIsBeyondTheEdgesOfBladesAndGrooves();
    void noisyBladesAndGroovesEndAtTheirEdges();
    void fHasNoJumps();
    void derivativesAreThoseOfTheValue();
    void agreesWithBruteForce();
    void lanesAgreeWithDouble();
    void whereOneSheetIsAloneNothingChanges();
    void thinOpenShellsKeepTheirRims();
};

namespace {

QString seedText() {
    return QString("seed %1").arg(test::seed());
}

/// All kinds of near sheets.
std::vector<Scene> scenes(double noise) {
    base::Random random(test::seed());
    const near_sheets::Roughness rough{.noise = noise};
    std::vector<Scene> out;
    for (const double t : {0.5, 1.0, 1.7, 2.6})
        out.push_back(near_sheets::stack({0, t}, random, rough));
    out.push_back(near_sheets::stack({0, 1.2, 2.4}, random, rough));
    out.push_back(near_sheets::stack({0, 0.8, 2.5, 3.6}, random, rough));
    for (const double degrees : {10, 20, 30, 45, 60, 90})
        out.push_back(near_sheets::wedge(degrees * shapes::pi / 180, 0, random.uniform() < 0.5, random, rough));
    return out;
}

/// What no rule foresees: surfels anywhere, facing anywhere.
Scene heap(base::Random& random) {
    Scene out = near_sheets::emptyScene(random);
    for (int i = 0; i < 1500; ++i) {
        const Vec3d p{random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-4, 4)};
        out.list.items.push_back(shapes::surfelAt(p, random.unitVector(), random.uniform(2, 5)));
    }
    out.draw = [](base::Random& r) {
        return std::pair(Vec3d{r.uniform(-6, 6), r.uniform(-6, 6), r.uniform(-3, 3)}, Vec3d{0, 0, 1});
    };
    return out;
}

/// What is left of the difference of f between a and b after the larger half was taken again and again: a step.
double stepBetween(const Surface& surface, Vec3d a, Vec3d b) {
    Evaluationd atA = surface.evaluateReference(a, Need::Value), atB = surface.evaluateReference(b, Need::Value);
    for (int i = 0; i < 24; ++i) {
        if (!atA.ok() || !atB.ok())
            return 0; // f ends there
        const Vec3d middle = (a + b) * 0.5;
        const Evaluationd at = surface.evaluateReference(middle, Need::Value);
        if (std::abs(at.value - atA.value) > std::abs(at.value - atB.value))
            b = middle, atB = at;
        else
            a = middle, atA = at;
    }
    return std::abs(atA.value - atB.value);
}

/// The largest step of f along a random segment through what the scene draws.
double largestStep(const Surface& surface, const Scene& scene, base::Random& random) {
    constexpr double length = 4, apart = 0.02, steepest = 1.5;
    const Vec3d direction = random.unitVector();
    const Vec3d from = scene.draw(random).first + random.unitVector() - direction * (length / 2);
    double largest = 0;
    Evaluationd last;
    for (double t = 0; t <= length; t += apart) {
        const Vec3d x = from + direction * t;
        const Evaluationd at = surface.evaluateReference(x, Need::Value);
        if (t > 0 && at.ok() && last.ok() && std::abs(at.value - last.value) > steepest * apart)
            largest = std::max(largest, stepBetween(surface, x - direction * apart, x));
        last = at;
    }
    return largest;
}

bool agrees(const Surface& surface, const Vec3d& x, double& agreement) {
    SurfaceDefinition definition = surface.definition();
    definition.oneSheet = false;
    const Evaluationd e = Surface(surface.tree(), definition).evaluateReference(x, Need::Value);
    agreement = e.agreement;
    return e.weight > 0;
}

/// Calls fn(surface, x) at places where near sheets meet.
template <class Fn>
void nearSheets(const std::vector<Scene>& all, const SurfaceDefinition& definition, int places, const Fn& fn) {
    base::Random random(test::seed() + 5);
    for (const Scene& scene : all) {
        const Surface surface = scene.surface(definition);
        for (int found = 0, tries = 0; found < places && tries < 50 * places; ++tries) {
            const Vec3f x = base::cast<float>(scene.draw(random).first + random.unitVector() * random.uniform(0, 1.5));
            double agreement = 1;
            if (!agrees(surface, base::cast<double>(x), agreement) || agreement > 0.915)
                continue;
            ++found;
            fn(surface, scene, x);
        }
    }
}

} // namespace

void TwoSolidsTest::wallsStayWhereTheyAre_data() {
    QTest::addColumn<double>("thickness");
    QTest::addColumn<double>("tilt");
    for (const double thickness : {0.5, 0.6, 0.8, 1.0, 1.5, 2.0, 3.0})
        for (const double tilt : {0.0, 0.5})
            QTest::addRow("%g spacings, tilted by %g", thickness, tilt) << thickness << tilt;
}

void TwoSolidsTest::wallsStayWhereTheyAre() {
    QFETCH(double, thickness);
    QFETCH(double, tilt);
    base::Random random(test::seed());
    for (const bool groove : {false, true}) {
        const Scene scene =
            tilt > 0 ? near_sheets::wedge(tilt, thickness, groove, random) : near_sheets::stack({0, thickness}, random);
        const Surface surface = scene.surface();
        double square = 0, worst = 0;
        const int places = 20 * test::effort(10);
        for (int i = 0; i < places; ++i) {
            const auto [x, n] = scene.draw(random);
            const Evaluationd e = surface.evaluateReference(x);
            QVERIFY2(isSurface(e) && dot(e.gradient, n) > 0.5, qPrintable(seedText()));
            const double off = e.value / length(e.gradient);
            square += off * off / places;
            worst = std::max(worst, std::abs(off));
        }
        const QString told = QString("%1: rms %2, most %3").arg(seedText()).arg(std::sqrt(square)).arg(worst);
        QVERIFY2(std::sqrt(square) <= 0.01 && worst <= 0.05, qPrintable(told));
    }
}

namespace {

/// Places about the edge of a wedge, a quarter of a spacing and more away from it, where f says on which side they are.
struct Sides {
    int wrong = 0, judged = 0;

    void judge(const Scene& scene, int places, base::Random& random) {
        const Surface surface = scene.surface();
        for (int i = 0; i < places; ++i) {
            const Vec3d along{0, random.uniform(-7, 7), 0}, off = random.unitVector() * random.uniform(0, 4);
            const Vec3d x = scene.turn * (along + off);
            const Evaluationd e = surface.evaluateReference(x, Need::Value);
            const double distance = scene.distance(x);
            if (!e.ok() || std::abs(distance) < 0.25 || e.offCentre > 0.5 * e.unit)
                continue;
            ++judged;
            wrong += (e.value < 0) != (distance < 0);
        }
    }
    QString text() const { return QString("%1 of %2 wrong, seed %3").arg(wrong).arg(judged).arg(test::seed()); }
};

} // namespace

/// The sign of f is right where a zero could be surface, from a quarter of a spacing away on, however jagged the edge.
void TwoSolidsTest::nothingIsBeyondTheEdgesOfBladesAndGrooves() {
    base::Random random(test::seed());
    for (const double degrees : {10, 15, 20, 30, 45})
        for (const bool groove : {false, true}) {
            Sides sides;
            for (const double jitter : {0.3, 0.5})
                sides.judge(
                    near_sheets::wedge(degrees * shapes::pi / 180, 0, groove, random, {.jitter = jitter, .noise = 0}),
                    50 * test::effort(10), random);
            QVERIFY2(sides.judged > 50 && sides.wrong == 0,
                     qPrintable(QString("%1 degrees, %2").arg(degrees).arg(sides.text())));
        }
}

/// Noise as large as the distance of the flanks: whether there is a solid between them shows farther from their edge.
void TwoSolidsTest::noisyBladesAndGroovesEndAtTheirEdges() {
    base::Random random(test::seed());
    for (const double degrees : {10, 20}) {
        Sides sides;
        for (int scene = 0; scene < 12; ++scene)
            sides.judge(
                near_sheets::wedge(degrees * shapes::pi / 180, 0, scene % 2, random, {.jitter = 0.3, .noise = 0.1}),
                15 * test::effort(10), random);
        QVERIFY2(sides.judged > 100 && sides.wrong <= 0.025 * sides.judged,
                 qPrintable(QString("%1 degrees, %2").arg(degrees).arg(sides.text())));
    }
}

void TwoSolidsTest::fHasNoJumps() {
    for (const double noise : {0.0, 0.15}) {
        std::vector<Scene> all = scenes(noise);
        base::Random random(test::seed() + 1);
        all.push_back(heap(random));
        for (std::size_t k = 0; k < all.size(); ++k) {
            const Surface surface = all[k].surface();
            std::vector<double> steps(static_cast<std::size_t>(3 * test::effort(10)));
            base::parallelFor(steps.size(), 1, [&](std::size_t i) {
                base::Random own(test::seed() + 1000 * k + i);
                steps[i] = largestStep(surface, all[k], own);
            });
            const double most = *std::max_element(steps.begin(), steps.end());
            const QString told = QString("scene %1, noise %2, %3: %4").arg(k).arg(noise).arg(seedText()).arg(most);
            QVERIFY2(most <= 1e-4, qPrintable(told));
        }
    }
}

/// Through the mix of both solids, through that with all surfels, and where hints choose.
void TwoSolidsTest::derivativesAreThoseOfTheValue() {
    std::vector<Scene> all = scenes(0.15);
    base::Random random(test::seed() + 1);
    all.push_back(heap(random));
    for (const Weight weight : {Weight::WendlandC4, Weight::Wendland}) {
        SurfaceDefinition definition;
        definition.weight = weight;
        double worst = 0, worstBend = 0, worstTurn = 0;
        nearSheets(all, definition, test::effort(10), [&](const Surface& surface, const Scene&, const Vec3f& at) {
            const Vec3d x = base::cast<double>(at);
            const bool hinted = random.uniform() < 0.3;
            const OrientationHint hint{hinted ? base::cast<float>(random.unitVector()) : Vec3f{}};
            const Evaluationd e = surface.evaluateReference(x, Need::Hessian, hint);
            if (!e.ok())
                return;
            double bend = 1;
            for (const auto& row : e.hessian.m)
                for (const double entry : row)
                    bend = std::max(bend, std::abs(entry));
            const double step = 2e-4 / std::sqrt(bend);
            for (int k = 0; k < 3; ++k) {
                const auto slope = [&](const auto& what) { return brute::difference(what, x, k, step); };
                const auto asked = [&](const Vec3d& y) { return surface.evaluateReference(y, Need::Gradient, hint); };
                const std::size_t axis = static_cast<std::size_t>(k);
                worst =
                    std::max(worst, std::abs(slope([&](const Vec3d& y) { return asked(y).value; }) - e.gradient[axis]));
                const Vec3d column = slope([&](const Vec3d& y) { return asked(y).gradient; });
                const Vec3d turn = slope([&](const Vec3d& y) { return asked(y).normal; });
                for (std::size_t a = 0; a < 3; ++a) {
                    worstBend = std::max(worstBend, std::abs(column[a] - e.hessian.m[a][k]) / bend);
                    worstTurn = std::max(worstTurn, std::abs(turn[a] - e.normalGradient.m[a][k]) / bend);
                }
            }
        });
        const QString told = QString("%1: gradient %2, Hessian %3, normal %4").arg(seedText()).arg(worst);
        QVERIFY2(worst <= 1e-7 && worstBend <= 1e-4 && worstTurn <= 1e-4,
                 qPrintable(told.arg(worstBend).arg(worstTurn)));
    }
}

void TwoSolidsTest::agreesWithBruteForce() {
    for (const Weight weight : {Weight::Wendland, Weight::WendlandC4})
        for (const bool shrinkFree : {true, false}) {
            SurfaceDefinition definition;
            definition.weight = weight;
            definition.shrinkFree = shrinkFree;
            std::vector<Scene> all = scenes(0.15);
            base::Random random(test::seed() + 1);
            all.push_back(heap(random));
            nearSheets(
                all, definition, test::effort(10), [&](const Surface& surface, const Scene& scene, const Vec3f& at) {
                    const Vec3d x = base::cast<double>(at);
                    const Vec3f hint = random.uniform() < 0.3 ? base::cast<float>(random.unitVector()) : Vec3f{};
                    const Evaluationd e = surface.evaluateReference(x, Need::Gradient, {hint});
                    if (!e.ok())
                        return;
                    const brute::Model model = brute::near(brute::modelOf(scene.list, definition), x, 6);
                    const brute::Answer b = brute::evaluate(model, x, base::cast<double>(hint));
                    const QString told = QString("%1: f %2, g %3, n %4, c %5").arg(seedText()).arg(e.value - b.f);
                    QVERIFY2(b.solids && std::abs(e.value - b.f) <= 1e-10 && distance(e.gradient, b.g) <= 1e-5 &&
                                 distance(e.normal, b.n) <= 1e-8 && distance(e.centroid, b.c) <= 1e-10 &&
                                 std::abs(e.agreement - b.agreement) <= 1e-10,
                             qPrintable(told.arg(distance(e.gradient, b.g))
                                            .arg(distance(e.normal, b.n))
                                            .arg(distance(e.centroid, b.c))));
                });
        }
}

void TwoSolidsTest::lanesAgreeWithDouble() {
    double worst = 0, worstSlope = 0, worstBend = 0;
    nearSheets(scenes(0.15), {}, test::effort(20), [&](const Surface& surface, const Scene&, const Vec3f& at) {
        const Evaluationd d = surface.evaluateReference(base::cast<double>(at), Need::Hessian);
        const Evaluationf v = surface.evaluate(at, Need::Value), g = surface.evaluate(at),
                          f = surface.evaluate(at, Need::Hessian);
        QCOMPARE(v.status, d.status);
        QCOMPARE(g.status, d.status);
        if (!d.ok())
            return;
        double bend = 1;
        for (const auto& row : d.hessian.m)
            for (const double entry : row)
                bend = std::max(bend, std::abs(entry));
        for (const Evaluationf* e : {&v, &g, &f})
            worst = std::max(worst, std::abs(double(e->value) - d.value) / bend);
        for (const Evaluationf* e : {&g, &f})
            worstSlope = std::max(worstSlope, distance(base::cast<double>(e->gradient), d.gradient) / bend);
        for (int a = 0; a < 3; ++a)
            for (int k = 0; k < 3; ++k)
                worstBend = std::max(worstBend, std::abs(double(f.hessian[a][k]) - d.hessian[a][k]) / bend);
    });
    const QString told = QString("%1: f %2, gradient %3, Hessian %4").arg(seedText()).arg(worst).arg(worstSlope);
    QVERIFY2(worst <= 1e-5 && worstSlope <= 1e-4 && worstBend <= 1e-3, qPrintable(told.arg(worstBend)));
}

/// Nothing of the rule reaches where all normals agree: there the answers have the bits of the plain definition.
void TwoSolidsTest::whereOneSheetIsAloneNothingChanges() {
    base::Random random(test::seed());
    int compared = 0;
    for (const Scene& scene : scenes(0.05)) {
        const Surface surface = scene.surface();
        SurfaceDefinition definition = surface.definition();
        definition.oneSheet = false;
        const Surface plain(surface.tree(), definition);
        for (int i = 0; i < test::effort(50); ++i) {
            const Vec3f x = base::cast<float>(scene.draw(random).first + random.unitVector() * random.uniform(0, 2.5));
            for (const Need need : {Need::Value, Need::Gradient, Need::Hessian}) {
                const Evaluationf a = surface.evaluate(x, need), b = plain.evaluate(x, need);
                if (!(b.agreement >= 0.92f))
                    continue;
                ++compared;
                QVERIFY2(shapes::sameBits(a.value, b.value) && shapes::sameBits(a.gradient, b.gradient) &&
                             shapes::sameBits(a.hessian, b.hessian) && shapes::sameBits(a.normal, b.normal) &&
                             shapes::sameBits(a.centroid, b.centroid) && shapes::sameBits(a.agreement, b.agreement),
                         qPrintable(seedText()));
            }
        }
    }
    QVERIFY(compared > 100);
}

/// Two pipes, one in the other: four rims, each where one pipe alone has it.
void TwoSolidsTest::thinOpenShellsKeepTheirRims() {
    constexpr double s = 0.05, height = 1.2;
    SurfaceDefinition definition;
    definition.boundaryLimit = 0.18f;
    const auto pipes = [&](std::initializer_list<std::pair<double, double>> walls) {
        surfel::SurfelList list;
        list.layout = shapes::layout(true, true);
        for (const auto& [radius, facing] : walls) {
            const int around = int(std::lround(2 * shapes::pi * radius / s)), rows = int(std::lround(height / s));
            for (int i = 0; i < around; ++i)
                for (int k = 0; k < rows; ++k) {
                    const double a = 2 * shapes::pi * (i + 0.5 * (k % 2)) / around;
                    const Vec3d out{std::cos(a), std::sin(a), 0};
                    const Vec3d p = out * radius + Vec3d{0, 0, (k + 0.5) * s};
                    surfel::Surfel surfel;
                    surfel.position = base::cast<float>(p), surfel.normal = base::cast<float>(out * facing);
                    surfel.support = float(3.5 * s);
                    list.append(surfel, {});
                }
        }
        return Surface(tree::SurfelTree::build(list), definition);
    };
    const auto rims = [](const Surface& surface) {
        std::vector<double> out;
        for (const BoundaryCurve& curve : findBoundaryCurves(surface))
            if (curve.closed)
                out.push_back(curve.points.front().position.z);
        std::sort(out.begin(), out.end());
        return out;
    };
    const std::vector<double> alone = rims(pipes({{1, 1}}));
    QCOMPARE(alone.size(), std::size_t(2));
    for (const double apart : {1.0, 1.5, 2.0}) {
        const std::vector<double> both = rims(pipes({{1, 1}, {1 - apart * s, -1}}));
        QCOMPARE(both.size(), std::size_t(4));
        for (std::size_t i = 0; i < both.size(); ++i)
            QVERIFY2(std::abs(both[i] - alone[i / 2]) < 0.3 * s,
                     qPrintable(QString::number((both[i] - alone[i / 2]) / s)));
    }
}

static const test::Registered<TwoSolidsTest> registered;
#include "two_solids_test.moc"
