// Laws that every tool obeys, over the whole table, with random strokes on spheres.
#include "core/base/error.h"
#include "core/sculpt/stroke/stroke.h"
#include "sculpt/dabs.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <QTest>

using namespace sculpt;

class ToolLawsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void initTestCase();
    void strokesLeaveTheModelFiniteAndValid();
    void nothingChangesFartherThanTheBrushAndTheResamplingReach();
    void withoutResamplingNothingOutsideTheBrushChanges();
    void strengthZeroIsANoOp();
    void fullMaskProtectsFromAllButTheMaskItself();
    void halfMaskHalvesTheDisplacement();
    void toolsWriteOnlyWhatTheySay();
    void replayIsBitExact();
    void oneAndTwoThreadsGiveTheSameBits();
    void olderVersionsStayAsTheyWere();
    void samplingStaysInRange();
    void symmetricStrokesKeepASymmetricShape();
    void tableIsComplete();
    void unknownToolsAreRefusedWithTheKnownOnes();

  private:
    surface::Surface m_sphere, m_lively;
    double m_spacing = 0;
};

/// Large enough for brushes of 14 spacings.
static constexpr std::size_t count = test::effort(20) == 20 ? 12000 : 4000;

void ToolLawsTest::initTestCase() {
    m_sphere = test::surfaceOf(test::spherePoints(count));
    base::Random random(test::seed());
    surfel::SurfelList lively = test::livelyPoints(count, random);
    for (surfel::Surfel& s : lively.items)
        s.mask = random.uniform() < 0.1 ? 0.3f : 0.0f;
    m_lively = test::surfaceOf(lively);
    m_spacing = test::sphereSpacing(count);
}

/// A wandering stroke over the front of the sphere, seen from far along a random direction.
static std::vector<StrokeSample> wander(base::Random& random, float step) {
    const base::Vec3d view = random.unitVector(), u = perpendicular(view), v = cross(view, u);
    double a = random.uniform(-0.4, 0.4), b = random.uniform(-0.4, 0.4), heading = random.uniform(0, 6.28);
    std::vector<StrokeSample> out;
    for (int k = 0; k < (test::effort(20) == 20 ? 12 : 6); ++k) {
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
    s.falloff = falloffTable()[random.below(falloffTable().size() - 1)].value; // but the last, custom
    if (s.tool == "clone")
        s.parameters = {{"x", random.uniform(-0.3, 0.3)}, {"y", random.uniform(-0.3, 0.3)}};
    return s;
}

/// Calls law(row, settings, samples) for `each` random strokes of every tool, fewer under sanitizers, where only the
/// laws that are tried most meet all tools.
template <class Law>
static void forStrokes(double spacing, int each, const Law& law) {
    for (const ToolRow& row : toolTable()) {
        if (row.needs.layer) // which has tests of its own
            continue;
        if (test::sanitized && each < 3 && (&row - toolTable().data()) % 3 != each)
            continue;
        base::Random random(test::seed());
        for (int k = 0; k < test::effort(each); ++k) {
            const StrokeSettings settings = settingsOf(row, random, spacing);
            law(row, settings, wander(random, 0.3f * settings.radius));
        }
    }
}

static QByteArray about(const ToolRow& row) {
    return QString("tool %1, seed %2").arg(row.id).arg(test::seed()).toUtf8();
}

void ToolLawsTest::strokesLeaveTheModelFiniteAndValid() {
    forStrokes(m_spacing, 3, [&](const ToolRow& row, const StrokeSettings& settings, const auto& samples) {
        const surface::Surface after = test::stroked(m_lively, settings, samples);
        after.tree().validate();
        QVERIFY2(test::hashOf(after) != test::hashOf(m_lively), about(row));
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
            // What a drag holds follows the pointer by its strength, from where it began; what turns stays there.
            const float part = row.motion == Motion::Drag   ? settings.strength
                               : row.motion == Motion::Turn ? 0.0f
                                                            : 1.0f;
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
    if (row.motion != Motion::Drag)
        for (const surfel::Surfel& s : test::without(before, after))
            look(s);
    return worst;
}

void ToolLawsTest::nothingChangesFartherThanTheBrushAndTheResamplingReach() {
    forStrokes(m_spacing, 2, [&](const ToolRow& row, const StrokeSettings& settings, const auto& samples) {
        const surface::Surface after = test::stroked(m_lively, settings, samples);
        // A step of the drag, the spacing of the samples tested, and what resampling moves beside what was touched.
        const float slack = 0.1f * settings.radius + 3 * float(m_spacing);
        const float by = strayed(m_lively, after, settings, row, samples);
        QVERIFY2(by < slack, about(row) + QByteArray::number(double(by) / m_spacing));
    });
}

/// A dab on the north pole that has everything a tool may ask for.
static Dab completeDab(const ToolRow& row) {
    Dab dab = test::dabOf(row, {0, 0, 1}, 0.3f, 1);
    dab.areaCentre = {0, 0, 0.98f};
    dab.move = {0.01f, 0, 0.02f};
    dab.travel = {0.02f, 0.01f, 0};
    dab.angle = 0.3f;
    if (dab.parameters.contains("x"))
        dab.parameters["x"] = 0.4;
    return dab;
}

void ToolLawsTest::withoutResamplingNothingOutsideTheBrushChanges() {
    for (const ToolRow& row : toolTable())
        for (const FalloffRow& falloff : falloffTable())
            for (const float strength : {1.0f, -0.6f}) {
                if (row.needs.layer)
                    continue;
                Dab dab = completeDab(row);
                dab.strength = strength;
                dab.falloff = falloff.value;
                const tree::Edit edit = row.apply(m_lively, dab);
                const surface::Surface after(m_lively.tree().apply(edit), m_lively.definition());
                QVERIFY2(!edit.empty(), about(row) + falloff.id);
                after.tree().validate();
                const float reach = dab.radius + length(dab.move) * 0.5f + 1e-6f;
                for (const surfel::Surfel& s : test::without(m_lively, after))
                    QVERIFY2(distance(s.position, dab.centre) <= reach, about(row) + falloff.id);
                if (row.writes == Writes::Count)
                    for (const surfel::Surfel& s : test::without(after, m_lively))
                        QVERIFY2(distance(s.position, dab.centre) <= reach, about(row) + falloff.id);
                else
                    QCOMPARE(after.tree().size(), m_lively.tree().size());
            }
}

void ToolLawsTest::toolsWriteOnlyWhatTheySay() {
    for (const ToolRow& row : toolTable()) {
        const tree::Edit edit = row.apply(m_lively, completeDab(row));
        QVERIFY2(row.writes == Writes::Count || edit.inserted.items.empty(), about(row));
        for (const tree::BlockEdit& change : edit.blocks) {
            QVERIFY2(row.writes == Writes::Count || (change.changed && change.removed.none()), about(row));
            const surfel::BlockPtr old = m_lively.tree().block(change.block);
            for (int slot = 0; change.changed && slot < old->size(); ++slot) {
                const surfel::Surfel a = old->surfel(slot), b = change.changed->surfel(slot);
                const bool shape = row.writes == Writes::Shape || row.writes == Writes::Surface;
                const bool counts = row.writes == Writes::Count;
                QVERIFY2(shape || counts || (a.position == b.position && a.normal == b.normal), about(row));
                QVERIFY2(counts || a.support == b.support, about(row)); // resampling ties supports, not the dab
                QVERIFY2(row.writes == Writes::Colour || counts || a.colour == b.colour, about(row));
                QVERIFY2(row.writes == Writes::Mask || a.mask == b.mask, about(row));
            }
        }
    }
}

void ToolLawsTest::strengthZeroIsANoOp() {
    forStrokes(m_spacing, 1, [&](const ToolRow& row, StrokeSettings settings, const auto& samples) {
        settings.strength = 0;
        QVERIFY2(test::hashOf(test::stroked(m_lively, settings, samples)) == test::hashOf(m_lively), about(row));
    });
}

void ToolLawsTest::fullMaskProtectsFromAllButTheMaskItself() {
    base::Random random(test::seed());
    surfel::SurfelList points = test::livelyPoints(count, random);
    for (surfel::Surfel& s : points.items)
        s.mask = s.position.x > 0 ? 1.0f : 0.0f;
    const surface::Surface masked = test::surfaceOf(points);
    forStrokes(m_spacing, 3, [&](const ToolRow& row, StrokeSettings settings, const auto& samples) {
        if (row.writes == Writes::Mask)
            settings.invert = true;
        const surface::Surface after = test::stroked(masked, settings, samples);
        for (const surfel::Surfel& s : test::without(masked, after)) {
            QVERIFY2(s.mask == 0 || row.writes == Writes::Mask, about(row));
        }
    });
}

void ToolLawsTest::halfMaskHalvesTheDisplacement() {
    base::Random random(test::seed());
    surfel::SurfelList points = test::livelyPoints(count, random), half = points;
    for (surfel::Surfel& s : half.items)
        s.mask = 0.5f;
    const surface::Surface free = test::surfaceOf(points), held = test::surfaceOf(half);
    for (const ToolRow& row : toolTable()) {
        if (row.writes != Writes::Shape)
            continue;
        const Dab dab = completeDab(row);
        const tree::Edit whole = row.apply(free, dab), part = row.apply(held, dab);
        QCOMPARE(part.blocks.size(), whole.blocks.size());
        for (std::size_t b = 0; b < whole.blocks.size(); ++b) {
            const surfel::BlockPtr old = free.tree().block(whole.blocks[b].block);
            for (int slot = 0; slot < old->size(); ++slot) {
                const base::Vec3f d = whole.blocks[b].changed->position(slot) - old->position(slot),
                                  e = part.blocks[b].changed->position(slot) - old->position(slot);
                QVERIFY2(length(d * 0.5f - e) < 1e-6f, about(row));
            }
        }
    }
}

void ToolLawsTest::replayIsBitExact() {
    forStrokes(m_spacing, 2, [&](const ToolRow& row, const StrokeSettings& settings, const auto& samples) {
        QVERIFY2(test::hashOf(test::stroked(m_lively, settings, samples)) ==
                     test::hashOf(test::stroked(m_lively, settings, samples)),
                 about(row));
    });
}

void ToolLawsTest::oneAndTwoThreadsGiveTheSameBits() {
    forStrokes(m_spacing, 2, [&](const ToolRow& row, const StrokeSettings& settings, const auto& samples) {
        const auto work = [&] { return test::hashOf(test::stroked(m_lively, settings, samples)); };
        const std::string one = test::onThreads(1, work), two = test::onThreads(2, work);
        QVERIFY2(one == two, about(row));
    });
}

void ToolLawsTest::olderVersionsStayAsTheyWere() {
    const std::string before = test::hashOf(m_lively);
    forStrokes(m_spacing, 1, [&](const ToolRow& row, const StrokeSettings& settings, const auto& samples) {
        test::stroked(m_lively, settings, samples);
        QVERIFY2(test::hashOf(m_lively) == before, about(row));
    });
}

void ToolLawsTest::samplingStaysInRange() {
    for (const ToolRow& row : toolTable()) {
        if (row.writes == Writes::Count && std::string(row.id) != "relax")
            continue; // other spacings and rims are what they are for
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

/// How far the mirror image of a surfel is from being there.
static float asymmetry(const surface::Surface& surface, const surfel::Surfel& s, bool sampled) {
    const base::Vec3f image{-s.position.x, s.position.y, s.position.z};
    if (!sampled) { // the surface is there, if not the surfel
        const auto e = surface.evaluate(image, surface::Need::Gradient);
        return e.ok() ? std::abs(e.value) / length(e.gradient) * 0.002f : 1.0f;
    }
    std::vector<tree::Neighbour> twin;
    surface.tree().nearest(image, 1, twin);
    const surfel::Surfel t = twin[0].block->surfel(twin[0].slot);
    float colour = 0;
    for (unsigned c = 0; c < 32; c += 8)
        colour = std::max(colour, std::abs(float(s.colour >> c & 255u) - float(t.colour >> c & 255u)));
    // Colours between two bytes are rounded by place, a little at every dab.
    return std::sqrt(twin[0].distanceSq) + std::abs(s.mask - t.mask) * 0.01f + (colour > 24 ? 1.0f : 0.0f);
}

void ToolLawsTest::symmetricStrokesKeepASymmetricShape() {
    // Mirrored points, far enough from the plane that the brushes do not meet.
    base::Random random(test::seed());
    surfel::SurfelList points = test::livelyPoints(count, random);
    std::erase_if(points.items, [](const surfel::Surfel& s) { return s.position.x <= 0.004f; });
    for (std::size_t i = 0, n = points.size(); i < n; ++i) {
        surfel::Surfel s = points.items[i];
        s.position.x = -s.position.x, s.normal.x = -s.normal.x;
        points.items.push_back(s);
    }
    const surface::Surface start = test::surfaceOf(points);
    for (const ToolRow& row : toolTable()) {
        if (row.needs.layer)
            continue;
        StrokeSettings settings;
        settings.tool = row.id;
        settings.radius = 0.25f;
        settings.strength = 0.7f;
        settings.symmetry.planes.x = true;
        settings.resample = false;
        if (settings.tool == "clone")
            settings.parameters = {{"x", 0.1}, {"y", 0.2}};
        std::vector<StrokeSample> samples;
        for (int k = 0; k < 8; ++k)
            samples.push_back({{{0.45f + 0.03f * float(k), 0.1f * float(k) - 0.3f, 4}, {0, 0, -1}}, 1, 0});
        const bool erases = std::string(row.id) == "erase";
        const surface::Surface after = test::stroked(start, settings, samples);
        QVERIFY2(test::hashOf(after) != test::hashOf(start), about(row));
        const bool sampled = row.writes != Writes::Count || erases;
        int lonely = 0; // on the very rim of the eraser rounding decides who stays
        for (const surfel::Surfel& s : after.tree().surfels().items) {
            const float off = asymmetry(after, s, sampled);
            lonely += off < 2e-5f ? 0 : 1;
            QVERIFY2(lonely <= (erases ? 4 : 0), about(row) + QByteArray::number(double(off)));
        }
    }
}

void ToolLawsTest::tableIsComplete() {
    QCOMPARE(toolTable().size(), std::size_t(26));
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
