// Laws that every tool obeys, over the whole table, with random strokes on a sphere.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/sculpt/stroke.h"
#include "sculpt/shapes.h"
#include "support/registry.h"

#include <QtTest>

using namespace sculpt;

class ToolLawsTest : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void strokesLeaveTheModelFiniteAndValid();
    void nothingChangesFartherThanTheBrushAndTheResamplingReach();
    void withoutResamplingNothingOutsideTheBrushChanges();
    void strengthZeroIsANoOp();
    void fullMaskProtects();
    void halfMaskHalvesTheDisplacement();
    void replayIsBitExact();
    void oneAndTwoThreadsGiveTheSameBits();
    void olderVersionsStayAsTheyWere();
    void samplingStaysInRange();
    void symmetricStrokesKeepASymmetricShape();
    void tableIsComplete();
    void unknownToolsAreRefusedWithTheKnownOnes();

  private:
    surface::Surface m_sphere;
    double m_spacing = 0;
};

static constexpr std::size_t count = 12000;

void ToolLawsTest::initTestCase() {
    m_sphere = test::surfaceOf(test::spherePoints(count));
    m_spacing = test::sphereSpacing(count);
}

/// A wandering stroke over the front of the sphere, seen from far along a random direction.
static std::vector<StrokeSample> wander(base::Random& random, float step) {
    const base::Vec3d view = random.unitVector(), u = perpendicular(view), v = cross(view, u);
    double a = random.uniform(-0.4, 0.4), b = random.uniform(-0.4, 0.4), heading = random.uniform(0, 6.28);
    std::vector<StrokeSample> out;
    for (int k = 0; k < 12; ++k) {
        const base::Vec3d eye = view * -4.0 + u * a + v * b;
        out.push_back(
            {{base::cast<float>(eye), base::cast<float>(view)}, float(random.uniform(0.3, 1)), float(k) / 60});
        heading += random.uniform(-0.7, 0.7);
        a += double(step) * std::cos(heading), b += double(step) * std::sin(heading);
    }
    return out;
}

static StrokeSettings settingsOf(const ToolRow& row, base::Random& random, double spacing) {
    StrokeSettings s;
    s.tool = row.id;
    s.radius = float(spacing * random.uniform(6, 14));
    s.strength = float(random.uniform(0.3, 1));
    s.invert = random.uniform() < 0.5;
    s.falloff = falloffTable()[random.below(3)].falloff;
    return s;
}

/// Calls law(row, settings, samples) for a few random strokes of every tool.
template <class Law>
static void forStrokes(double spacing, int each, const Law& law) {
    for (const ToolRow& row : toolTable()) {
        base::Random random(test::seed());
        for (int k = 0; k < each; ++k) {
            const StrokeSettings settings = settingsOf(row, random, spacing);
            law(row, settings, wander(random, 0.3f * settings.radius));
        }
    }
}

static QByteArray about(const ToolRow& row) {
    return QString("tool %1, seed %2").arg(row.id).arg(test::seed()).toUtf8();
}

void ToolLawsTest::strokesLeaveTheModelFiniteAndValid() {
    forStrokes(m_spacing, 4, [&](const ToolRow& row, const StrokeSettings& settings, const auto& samples) {
        const surface::Surface after = test::stroked(m_sphere, settings, samples);
        after.tree().validate();
        QVERIFY2(test::hashOf(after) != test::hashOf(m_sphere), about(row));
        for (const surfel::Surfel& s : after.tree().surfels().items) {
            QVERIFY2(isFinite(s.position) && isFinite(s.normal), about(row));
            QVERIFY2(std::abs(length(s.normal) - 1) < 1e-5f, about(row));
            QVERIFY2(length(s.position) < 4, about(row));
        }
    });
}

/// Farthest that any changed surfel lies from the places that the brush can have been.
static float strayed(const surface::Surface& before, const surface::Surface& after, const StrokeSettings& settings,
                     const ToolRow& row, const std::vector<StrokeSample>& samples) {
    float worst = 0;
    const auto look = [&](const surfel::Surfel& s) {
        float nearest = 1e9f;
        for (std::size_t k = 1; k < samples.size(); ++k) {
            // What a drag holds follows the pointer by its strength, from where it began.
            const float part = row.motion == Motion::Drag ? settings.strength : 1.0f;
            const base::Vec3f view = samples[k].ray.direction, start = samples[0].ray.origin,
                              from = start + (samples[k - 1].ray.origin - start) * part,
                              way = (samples[k].ray.origin - samples[k - 1].ray.origin) * part;
            for (int j = 0; j <= 20; ++j) {
                base::Vec3f q = s.position - (from + way * (float(j) / 20));
                q -= view * dot(view, q);
                nearest = std::min(nearest, length(q)); // a brush lies somewhere on its ray
            }
        }
        worst = std::max(worst, nearest - settings.radius);
    };
    for (const surfel::Surfel& s : test::without(after, before))
        look(s);
    if (row.motion == Motion::Along)
        for (const surfel::Surfel& s : test::without(before, after))
            look(s);
    return worst;
}

void ToolLawsTest::nothingChangesFartherThanTheBrushAndTheResamplingReach() {
    forStrokes(m_spacing, 3, [&](const ToolRow& row, const StrokeSettings& settings, const auto& samples) {
        const surface::Surface after = test::stroked(m_sphere, settings, samples);
        // A step of the drag, the spacing of the samples tested, and what resampling moves beside what was touched.
        const float slack = 0.1f * settings.radius + 3 * float(m_spacing);
        const float by = strayed(m_sphere, after, settings, row, samples);
        QVERIFY2(by < slack, about(row) + QByteArray::number(double(by) / m_spacing));
    });
}

void ToolLawsTest::withoutResamplingNothingOutsideTheBrushChanges() {
    for (const ToolRow& row : toolTable()) {
        Dab dab;
        dab.centre = {0, 0, 1};
        dab.normal = dab.areaNormal = {0, 0, 1};
        dab.areaCentre = {0, 0, 0.98f};
        dab.view = {0, 0, -1};
        dab.radius = 0.3f;
        dab.strength = 1;
        dab.move = {0.01f, 0, 0.02f};
        for (const ToolParameter& parameter : row.parameters)
            dab.parameters[parameter.id] = parameter.fallback;
        for (const FalloffRow& falloff : falloffTable()) {
            dab.falloff = falloff.falloff;
            const tree::Edit edit = row.apply(m_sphere, dab);
            const surface::Surface after(m_sphere.tree().apply(edit), m_sphere.definition());
            const float reach = dab.radius + length(dab.move) * 0.5f + 1e-6f;
            for (const surfel::Surfel& s : test::without(m_sphere, after))
                QVERIFY2(distance(s.position, dab.centre) <= reach, about(row) + falloff.id);
            QCOMPARE(after.tree().size(), m_sphere.tree().size());
        }
    }
}

void ToolLawsTest::strengthZeroIsANoOp() {
    forStrokes(m_spacing, 1, [&](const ToolRow& row, StrokeSettings settings, const auto& samples) {
        settings.strength = 0;
        QVERIFY2(test::hashOf(test::stroked(m_sphere, settings, samples)) == test::hashOf(m_sphere), about(row));
    });
}

void ToolLawsTest::fullMaskProtects() {
    surfel::SurfelList points = test::spherePoints(count);
    for (surfel::Surfel& s : points.items)
        s.mask = s.position.x > 0 ? 1.0f : 0.0f;
    const surface::Surface masked = test::surfaceOf(points);
    forStrokes(m_spacing, 4, [&](const ToolRow& row, const StrokeSettings& settings, const auto& samples) {
        const surface::Surface after = test::stroked(masked, settings, samples);
        for (const surfel::Surfel& s : test::without(masked, after))
            QVERIFY2(s.mask == 0, about(row));
    });
}

void ToolLawsTest::halfMaskHalvesTheDisplacement() {
    surfel::SurfelList points = test::planePoints(60, 0.02), half = points;
    for (surfel::Surfel& s : half.items)
        s.mask = 0.5f;
    Dab dab;
    dab.normal = dab.areaNormal = {0, 0, 1};
    dab.view = {0, 0, -1};
    dab.radius = 0.3f;
    dab.strength = 1;
    dab.move = {0, 0, 0.02f};
    for (const ToolRow& row : toolTable()) {
        dab.parameters.clear();
        for (const ToolParameter& parameter : row.parameters)
            dab.parameters[parameter.id] = parameter.fallback;
        const auto top = [&](const surfel::SurfelList& list) {
            const tree::SurfelTree tree = tree::SurfelTree::build(list);
            return tree.apply(row.apply({tree, {}}, dab)).bounds().hi.z;
        };
        QVERIFY2(std::abs(top(half) - 0.5f * top(points)) < 1e-6f, about(row));
    }
}

void ToolLawsTest::replayIsBitExact() {
    forStrokes(m_spacing, 2, [&](const ToolRow& row, const StrokeSettings& settings, const auto& samples) {
        QVERIFY2(test::hashOf(test::stroked(m_sphere, settings, samples)) ==
                     test::hashOf(test::stroked(m_sphere, settings, samples)),
                 about(row));
    });
}

void ToolLawsTest::oneAndTwoThreadsGiveTheSameBits() {
    forStrokes(m_spacing, 2, [&](const ToolRow& row, const StrokeSettings& settings, const auto& samples) {
        base::setThreadCount(1);
        const std::string one = test::hashOf(test::stroked(m_sphere, settings, samples));
        base::setThreadCount(2);
        const std::string two = test::hashOf(test::stroked(m_sphere, settings, samples));
        base::setThreadCount(0);
        QVERIFY2(one == two, about(row));
    });
}

void ToolLawsTest::olderVersionsStayAsTheyWere() {
    const std::string before = test::hashOf(m_sphere);
    forStrokes(m_spacing, 1, [&](const ToolRow& row, const StrokeSettings& settings, const auto& samples) {
        test::stroked(m_sphere, settings, samples);
        QVERIFY2(test::hashOf(m_sphere) == before, about(row));
    });
}

void ToolLawsTest::samplingStaysInRange() {
    for (const ToolRow& row : toolTable()) {
        base::Random random(test::seed());
        surface::Surface s = m_sphere;
        for (int k = 0; k < 12; ++k) {
            StrokeSettings settings = settingsOf(row, random, m_spacing);
            settings.falloff = Falloff::Smooth;
            // Dragged farther sideways, matter folds over its surroundings, and there is no one sheet to measure.
            const float step = row.motion == Motion::Drag ? 0.1f : 0.3f;
            s = test::stroked(s, settings, wander(random, step * settings.radius));
        }
        const process::Summary spacing = test::spacingOfSheets(s, m_spacing);
        QVERIFY2(spacing.min >= 0.6f && spacing.max <= 1.6f,
                 about(row) + QString(": %1 to %2").arg(spacing.min).arg(spacing.max).toUtf8());
    }
}

void ToolLawsTest::symmetricStrokesKeepASymmetricShape() {
    // Mirrored points, far enough from the plane that the brushes do not meet.
    surfel::SurfelList points = test::spherePoints(count);
    std::erase_if(points.items, [](const surfel::Surfel& s) { return s.position.x <= 0.004f; });
    for (std::size_t i = 0, n = points.size(); i < n; ++i) {
        surfel::Surfel s = points.items[i];
        s.position.x = -s.position.x, s.normal.x = -s.normal.x;
        points.items.push_back(s);
    }
    const surface::Surface start = test::surfaceOf(points);
    for (const ToolRow& row : toolTable()) {
        StrokeSettings settings;
        settings.tool = row.id;
        settings.radius = 0.25f;
        settings.strength = 0.7f;
        settings.symmetry.x = true;
        settings.resample = false;
        std::vector<StrokeSample> samples;
        for (int k = 0; k < 8; ++k)
            samples.push_back({{{0.45f + 0.03f * float(k), 0.1f * float(k) - 0.3f, 4}, {0, 0, -1}}, 1, 0});
        const surface::Surface after = test::stroked(start, settings, samples);
        QVERIFY2(test::hashOf(after) != test::hashOf(start), about(row));
        std::vector<tree::Neighbour> twin;
        for (const surfel::Surfel& s : after.tree().surfels().items) {
            after.tree().nearest({-s.position.x, s.position.y, s.position.z}, 1, twin);
            QVERIFY2(std::sqrt(twin[0].distanceSq) < 2e-5f, about(row));
        }
    }
}

void ToolLawsTest::tableIsComplete() {
    QVERIFY(toolTable().size() >= 4);
    for (const ToolRow& row : toolTable()) {
        QCOMPARE(&tool(row.id), &row);
        QVERIFY(row.apply && row.label[0] && row.tip[0] && row.icon[0]);
        QVERIFY(row.strength > 0 && row.strength <= 1);
        for (const ToolParameter& parameter : row.parameters)
            QVERIFY(parameter.min <= parameter.fallback && parameter.fallback <= parameter.max && parameter.tip[0]);
    }
}

void ToolLawsTest::unknownToolsAreRefusedWithTheKnownOnes() {
    try {
        tool("shovel");
        QFAIL("accepted");
    } catch (const base::Error& e) {
        for (const ToolRow& row : toolTable())
            QVERIFY(e.message().find(row.id) != std::string::npos);
    }
}

static const test::Registered<ToolLawsTest> registered;
#include "tool_laws_test.moc"
