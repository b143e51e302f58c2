// What the tools do that move and make surfels on the surface, which stays: relax and density.
#include "core/process/estimation/prepare.h"
#include "sculpt/dabs.h"
#include "sculpt/random_ball.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;
using test::applied;
using test::dabOf;

class SamplingToolsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void relaxEvensTheSpacingAndKeepsTheSurface();
    void relaxKeepsTheNumberOfSurfelsThatLieByChance();
    void hardlyAnyGoOrComeWhereOneDabRelaxes();
    void strokesOfWideBrushesRelaxAllInTheEnd();
    void densityReachesItsFactorAndKeepsTheSurface();
    void densityOfOneStrokeStopsAtItsFactor();
    void densityKeepsToTheSamplingOfEachPlace();
    void dabsOfWideBrushesOfDensityDoAsMuchAsOthers();
    void strokesOfWideBrushesOfDensityReachTheirFactorInTheEnd();
};

void SamplingToolsTest::relaxEvensTheSpacingAndKeepsTheSurface() {
    constexpr std::size_t count = 12000;
    const double spacing = test::sphereSpacing(count);
    base::Random random(test::seed());
    surfel::SurfelList points = test::spherePoints(count);
    for (surfel::Surfel& each : points.items) {
        const base::Vec3d p = base::cast<double>(each.position) + random.unitVector() * (0.4 * spacing);
        each.position = each.normal = base::cast<float>(normalized(p));
    }
    const surface::Surface before = test::surfaceOf(points);
    surface::Surface now = before;
    for (int k = 0; k < 4; ++k)
        now = applied(tool("relax"), now, dabOf(tool("relax"), {0, 0, 1}, 0.5f, 1));
    const auto under = [&](const surface::Surface& surface) {
        std::vector<float> out;
        std::vector<tree::Neighbour> near;
        for (const surfel::Surfel& each : surface.tree().surfels().items) {
            if (distance(each.position, {0, 0, 1}) > 0.3f)
                continue;
            surface.tree().nearest(each.position, 2, near);
            out.push_back(std::sqrt(near[1].distanceSq) / float(spacing));
        }
        return process::summarise(out);
    };
    QVERIFY2(under(before).min < 0.5f && under(now).min > 0.65f, qPrintable(QString::number(double(under(now).min))));
    for (const surfel::Surfel& each : now.tree().surfels().items)
        QVERIFY(std::abs(length(each.position) - 1) < 0.02f * float(spacing));
}

void SamplingToolsTest::relaxKeepsTheNumberOfSurfelsThatLieByChance() {
    base::Random random(test::seed());
    const auto count = std::size_t(test::effort(6000)), under = count / 5;
    const surface::Surface before = test::randomBall(random, count, 0.02, 0);
    for (int place = 0; place < 2; ++place) {
        const base::Vec3f at = before.tree().surfels().items[random.below(count)].position;
        std::vector<tree::Neighbour> near;
        before.tree().nearest(at, under, near);
        Dab dab = dabOf(tool("relax"), at, std::sqrt(near.back().distanceSq), 1);
        dab.first = &before;
        surface::Surface now = before;
        for (int k = 0; k < 4; ++k)
            now = applied(tool("relax"), now, dab);
        const double more = (double(now.tree().size()) - double(count)) / double(under);
        const QString told = QString("%1 of %2, seed %3").arg(more).arg(under).arg(test::seed());
        qInfo("%s", qPrintable(told));
        QVERIFY2(std::abs(more) < 0.03 + 4.0 / double(under), qPrintable(told)); // a few count where there are few
    }
}

void SamplingToolsTest::hardlyAnyGoOrComeWhereOneDabRelaxes() {
    base::Random random(test::seed());
    const auto count = std::size_t(test::effort(6000)), under = count / 3;
    const surface::Surface ball = test::randomBall(random, count, 0.02, 0);
    const base::Vec3f at = ball.tree().surfels().items[random.below(count)].position;
    std::vector<tree::Neighbour> near;
    ball.tree().nearest(at, under, near);
    const Dab dab = dabOf(tool("relax"), at, std::sqrt(near.back().distanceSq), 0.5f);
    const tree::Edit edit = tool("relax").apply(ball, dab);
    std::size_t gone = 0;
    for (const tree::BlockEdit& each : edit.blocks)
        gone += each.removed.count();
    const double part = double(gone + edit.inserted.size()) / double(under);
    QVERIFY2(part < 0.12, qPrintable(QString("%1, seed %2").arg(part).arg(test::seed())));
}

/// Points at random places of the unit sphere, and how far each of those near the pole is from its nearest, ascending.
static std::vector<float> nearestDistances(const surface::Surface& surface, float within) {
    std::vector<float> out;
    std::vector<tree::Neighbour> near;
    for (const surfel::Surfel& each : surface.tree().surfels().items)
        if (distance(each.position, {0, 0, 1}) < within) {
            surface.tree().nearest(each.position, 2, near);
            out.push_back(std::sqrt(near[1].distanceSq));
        }
    std::sort(out.begin(), out.end());
    return out;
}

void SamplingToolsTest::strokesOfWideBrushesRelaxAllInTheEnd() {
    // Far more than have their turn in a dab: those of a tap, and of a stroke, are even when it ends.
    const auto count = std::size_t(test::effort(30000));
    base::Random random(test::seed());
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    for (std::size_t k = 0; k < count; ++k) {
        surfel::Surfel each;
        each.position = each.normal = base::cast<float>(random.unitVector());
        points.append(each, {});
    }
    const surface::Surface start = process::prepare(points, {});
    const auto spacing = float(test::sphereSpacing(count));
    StrokeSettings settings;
    settings.tool = "relax";
    settings.radius = 1.2f;
    settings.strength = 1;
    for (const int samples : {1, 4}) {
        std::vector<StrokeSample> way;
        for (int k = 0; k < samples; ++k)
            way.push_back({{{0.1f * float(k), 0, 4}, {0, 0, -1}}, 1, float(k)});
        const surface::Surface after = test::stroked(start, settings, way);
        after.tree().validate();
        const std::vector<float> before = nearestDistances(start, 1), now = nearestDistances(after, 1);
        const float hundredth = now[now.size() / 100] / spacing;
        QVERIFY2(
            hundredth > 0.5f && before[before.size() / 100] < 0.2f * spacing,
            qPrintable(QString("%1 after %2 samples, seed %3").arg(double(hundredth)).arg(samples).arg(test::seed())));
        const double more = double(now.size()) / double(before.size()) - 1;
        QVERIFY2(std::abs(more) < 0.03, qPrintable(QString("%1, seed %2").arg(more).arg(test::seed())));
    }
}

/// Median spacing near the pole, in those of the start.
static double spacingAt(const surface::Surface& surface, std::size_t count, float within) {
    std::vector<float> near;
    const std::vector<surfel::Surfel> items = surface.tree().surfels().items;
    const std::vector<float> all = process::spacings(items);
    for (std::size_t i = 0; i < items.size(); ++i)
        if (distance(items[i].position, {0, 0, 1}) < within)
            near.push_back(all[i]);
    return double(process::summarise(near).median) / test::sphereSpacing(count);
}

static surface::Surface densified(const surface::Surface& start, float strength, double factor, int dabs) {
    surface::Surface now = start;
    Dab dab = dabOf(tool("density"), {0, 0, 1}, 0.7f, strength);
    dab.parameters["factor"] = factor;
    dab.first = &start;
    for (int k = 0; k < dabs; ++k)
        now = applied(tool("density"), now, dab);
    return now;
}

void SamplingToolsTest::densityReachesItsFactorAndKeepsTheSurface() {
    constexpr std::size_t count = 8000;
    const surface::Surface start = test::surfaceOf(test::spherePoints(count));
    for (const float strength : {1.0f, -1.0f}) {
        const surface::Surface now = densified(start, strength, 0.6, 5);
        now.tree().validate();
        const double expected = strength > 0 ? 0.6 : 1 / 0.6, found = spacingAt(now, count, 0.25f);
        QVERIFY2(std::abs(found / expected - 1) < 0.18, qPrintable(QString::number(found)));
        for (const surfel::Surfel& each : now.tree().surfels().items) {
            QVERIFY2(std::abs(length(each.position) - 1) < 0.03f * float(test::sphereSpacing(count)),
                     qPrintable(QString::number(double(length(each.position) - 1))));
            QVERIFY(now.evaluate(each.position, surface::Need::Value).samples >= 10);
        }
        base::Random random(test::seed());
        for (int k = 0; k < 2000; ++k) { // the surface between them, where supports change
            const base::Vec3f p = base::cast<float>(random.unitVector());
            const auto e = now.evaluate(p, surface::Need::Gradient);
            QVERIFY(e.ok());
            QVERIFY2(std::abs(e.value) < 0.06f * float(test::sphereSpacing(count)),
                     qPrintable(QString::number(double(e.value))));
        }
    }
}

void SamplingToolsTest::densityOfOneStrokeStopsAtItsFactor() {
    constexpr std::size_t count = 4000;
    const surface::Surface start = test::surfaceOf(test::spherePoints(count));
    const double five = spacingAt(densified(start, 1, 0.7, 5), count, 0.25f),
                 ten = spacingAt(densified(start, 1, 0.7, 10), count, 0.25f);
    QVERIFY2(std::abs(ten / five - 1) < 0.02, qPrintable(QString("%1 %2").arg(five).arg(ten)));
}

/// Random points of the unit sphere, 20 times as far apart at one end of x as at the other.
static surface::Surface onePerTwenty(base::Random& random, int count) {
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    while (int(out.size()) < count) {
        const base::Vec3d u = random.unitVector();
        if (random.uniform() > std::pow(20.0, u.x - 1))
            continue;
        surfel::Surfel each;
        each.position = each.normal = base::cast<float>(u);
        out.append(each, {});
    }
    return process::prepare(out, {});
}

void SamplingToolsTest::densityKeepsToTheSamplingOfEachPlace() {
    // A brush over all densities: nothing is eaten where it is finer than in the middle, nothing drowned where coarser.
    base::Random random(test::seed());
    const surface::Surface start = onePerTwenty(random, 5000);
    for (const float strength : {1.0f, -1.0f})
        for (const double at : {-0.6, 0.0, 0.6}) {
            surface::Surface now = start;
            const base::Vec3f centre = base::cast<float>(base::Vec3d{at, std::sqrt(1 - at * at), 0});
            Dab dab = dabOf(tool("density"), centre, 1.4f, strength);
            dab.first = &start;
            for (int k = 0; k < 3; ++k)
                now = applied(tool("density"), now, dab);
            now.tree().validate();
            for (const surfel::Surfel& each : now.tree().surfels().items)
                QVERIFY(std::abs(length(each.position) - 1) <
                        0.1f * process::spacingOf(now.definition(), each.support));
            int before[4] = {}, after[4] = {}; // by quarters of x under the brush
            const auto count = [&](const surface::Surface& of, int(&into)[4]) {
                for (const surfel::Surfel& each : of.tree().surfels().items)
                    if (distance(each.position, centre) < 1)
                        ++into[std::clamp(int(2 + 2 * each.position.x), 0, 3)];
            };
            count(start, before), count(now, after);
            for (int k = 0; k < 4; ++k) {
                const double ratio = double(after[k]) / std::max(1, before[k]);
                const QByteArray what = QString("strength %1, middle %2, quarter %3: %4 -> %5")
                                            .arg(double(strength))
                                            .arg(at)
                                            .arg(k)
                                            .arg(before[k])
                                            .arg(after[k])
                                            .toUtf8();
                if (before[k] >= 30)
                    QVERIFY2(strength > 0 ? ratio > 0.7 && ratio < 4 : ratio > 0.2 && ratio < 1.4, what.constData());
            }
        }
}

/// Surfels that go or come.
static std::size_t changesOf(const tree::Edit& edit) {
    std::size_t out = edit.inserted.size();
    for (const tree::BlockEdit& each : edit.blocks)
        out += each.removed.count();
    return out;
}

void SamplingToolsTest::dabsOfWideBrushesOfDensityDoAsMuchAsOthers() {
    constexpr std::size_t count = 30000;
    const surface::Surface start = test::surfaceOf(test::spherePoints(count));
    for (const float strength : {1.0f, -1.0f}) {
        std::unique_ptr<ToolMemory> memory;
        surface::Surface now = start;
        Dab dab = dabOf(tool("density"), {0, 0, 1}, 1.0f, strength);
        dab.first = &start;
        dab.memory = &memory;
        for (int k = 0; k < 3; ++k) {
            const tree::Edit edit = tool("density").apply(now, dab);
            QVERIFY2(changesOf(edit) > 100 && changesOf(edit) < 6000, qPrintable(QString::number(changesOf(edit))));
            now = {now.tree().apply(edit), now.definition()};
        }
        int slices = 0;
        for (tree::Edit edit = tool("density").rest(now, *memory); !edit.empty();
             edit = tool("density").rest(now, *memory)) {
            QVERIFY2(changesOf(edit) < 6000, qPrintable(QString::number(changesOf(edit))));
            now = {now.tree().apply(edit), now.definition()};
            QVERIFY(++slices < 1000);
        }
        now.tree().validate();
        const double expected = strength > 0 ? 0.6 : 1 / 0.6, found = spacingAt(now, count, 0.6f);
        QVERIFY2(std::abs(found / expected - 1) < 0.18, qPrintable(QString::number(found)));
    }
}

void SamplingToolsTest::strokesOfWideBrushesOfDensityReachTheirFactorInTheEnd() {
    // Places that a random stroke goes over have their part of what they had, and lie where they lay.
    constexpr std::size_t count = 32000; // more under the brush than have turns at once
    base::Random random(test::seed());
    const surface::Surface start = test::surfaceOf(test::spherePoints(count));
    const auto near = [](const surface::Surface& surface, double& worst) {
        double out = 0;
        for (const surfel::Surfel& each : surface.tree().surfels().items)
            if (distance(each.position, {0, 0, 1}) < 0.5f)
                ++out, worst = std::max(worst, std::abs(double(length(each.position)) - 1));
        return out;
    };
    for (const bool invert : {false, true}) {
        StrokeSettings settings = test::settingsOf("density", 0.9f);
        settings.strength = float(random.uniform(0.3, 1));
        settings.invert = invert;
        const auto at = [&] { return float(random.uniform(-0.2, 0.2)); };
        const surface::Surface after =
            test::stroked(start, settings, {test::down(-0.4f, at()), test::down(0, at()), test::down(0.4f, at())});
        after.tree().validate();
        double worst = 0;
        const double ratio = near(after, worst) / near(start, worst), expected = invert ? 0.36 : 1 / 0.36;
        const QString told = QString("%1 of %2, off by %3 spacings, strength %4, seed %5")
                                 .arg(ratio)
                                 .arg(expected)
                                 .arg(worst / test::sphereSpacing(count))
                                 .arg(double(settings.strength))
                                 .arg(test::seed());
        qInfo("%s", qPrintable(told));
        QVERIFY2(ratio > 0.75 * expected && ratio < 1.3 * expected, qPrintable(told));
        QVERIFY2(worst < 0.03 * test::sphereSpacing(count), qPrintable(told));
    }
}

static const test::Registered<SamplingToolsTest> registered;
#include "sampling_tools_test.moc"
