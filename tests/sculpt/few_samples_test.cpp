// Strokes on models whose shape few samples carry: those that are large against the brush give way to finer ones on the
// same surface before it works, so that a dab is what it is on a dense model.
#include "core/process/resampling/refine_under.h"
#include "core/surface/projection/project.h"
#include "sculpt/stroke_samples.h"
#include "support/registry.h"
#include "support/threads.h"
#include "surface/shapes.h"

#include <QTest>

class FewSamplesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void largeSupportsGiveWay_data();
    void largeSupportsGiveWay();
    void theRestKeepsEveryBit();
    void theSurfaceStaysWhereItWas_data();
    void theSurfaceStaysWhereItWas();
    void denseModelsAndWideBrushesKeepAll();
    void maskedSamplesStay();
    void cellsAreRefinedAwayFromCreases();
    void onceIsEnough();
    void dabsAreThoseOfDenseModels_data();
    void dabsAreThoseOfDenseModels();
    void atRimsToo();
    void theStrokeKeepsTheFineSpacing();
    void theSameBitsAtAnyThreadCount();
};

namespace {

using base::Vec3d;
using base::Vec3f;

constexpr std::size_t few = 400, many = 24000;
const double spacing = shapes::sphereSpacing(few, 1);

surface::SurfaceDefinition fewNeighbours() {
    surface::SurfaceDefinition out;
    out.neighbours = 8;
    return out;
}

surface::Surface ball(std::size_t count, int neighbours = 8) {
    surface::SurfaceDefinition definition;
    definition.neighbours = neighbours;
    const double support = shapes::sphereSpacing(count, 1) * std::sqrt(neighbours / shapes::pi);
    return shapes::surfaceOf(shapes::sphere(count, 1, support), definition);
}

/// A torus in rows, with a tube of six spacings around.
surface::Surface ring() {
    return shapes::surfaceOf(shapes::torus(1, 0.4, 0.2, 0.2 * std::sqrt(8 / shapes::pi)), fewNeighbours());
}

/// Root of the mean square of how far `places` are from the surface, and how many found none.
std::pair<double, int> away(const surface::Surface& surface, const std::vector<Vec3d>& places) {
    double sum = 0;
    int lost = 0;
    for (const Vec3d& x : places) {
        const auto found = surface::projectReference(surface, x);
        if (found.ok())
            sum += distanceSq(found.foot, x);
        else
            ++lost;
    }
    return {std::sqrt(sum / static_cast<double>(places.size())), lost};
}

/// An ellipsoid by chance, of few samples that lie by chance, so that its surface is wavy between them.
surface::Surface wavyBody(base::Random& random) {
    const Vec3d axes{random.uniform(0.7, 1.4), random.uniform(0.7, 1.4), random.uniform(0.7, 1.4)};
    surfel::SurfelList list = shapes::sphere(few, 1, spacing * std::sqrt(8 / shapes::pi));
    for (surfel::Surfel& each : list.items) {
        const Vec3d d = base::normalized(base::cast<double>(each.position) + random.unitVector() * (0.2 * spacing));
        each.position = base::cast<float>(Vec3d{d.x * axes.x, d.y * axes.y, d.z * axes.z});
        each.normal = base::cast<float>(base::normalized(Vec3d{d.x / axes.x, d.y / axes.y, d.z / axes.z}));
        each.support *= static_cast<float>(std::max({axes.x, axes.y, axes.z}));
    }
    return {tree::SurfelTree::build(list), fewNeighbours()};
}

std::vector<surfel::Surfel> surfelsOf(const surface::Surface& surface) {
    return surface.tree().surfels().items;
}

/// Seven dabs of full strength in one place.
surface::Surface raised(const surface::Surface& start, const Vec3f& from, const Vec3f& direction, float radius) {
    sculpt::StrokeSettings settings = test::settingsOf("draw", radius, sculpt::StrokeMethod::Dots);
    settings.strength = 1;
    sculpt::Stroke stroke(start, settings);
    for (int k = 0; k < 7; ++k)
        stroke.add({{from, direction}, 1, 0.01f * static_cast<float>(k)});
    stroke.finish();
    return stroke.surface();
}

/// Somewhere on the upper half, off the axis that spheres are made about.
const Vec3f place = base::normalized(Vec3f{0.31f, 0.22f, 1});

} // namespace

void FewSamplesTest::largeSupportsGiveWay_data() {
    QTest::addColumn<double>("radius"); // in spacings
    for (const double radius : {0.7, 1.0, 1.7, 2.5})
        QTest::addRow("%g spacings", radius) << radius;
}

void FewSamplesTest::largeSupportsGiveWay() {
    QFETCH(double, radius);
    const surface::Surface before = ball(few);
    const auto r = static_cast<float>(radius * spacing);
    const auto after = process::refinedUnder(before, place, r);
    QVERIFY(after);
    int under = 0;
    for (const surfel::Surfel& each : surfelsOf(*after)) {
        if (distance(each.position, place) > r)
            continue;
        ++under;
        QVERIFY(each.support <= 0.5f * r);
    }
    // as many as there is room for: a disc of pi R^2 at a spacing of R / 4.5
    QVERIFY2(under > 48 && under < 85, std::to_string(under).c_str());
    std::vector<Vec3d> places;
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(200); ++k)
        places.push_back(base::normalized(base::cast<double>(place) + random.unitVector() * (2 * radius * spacing)));
    const auto [off, lost] = away(*after, places);
    const double was = away(before, places).first;
    QCOMPARE(lost, 0);
    QVERIFY2(off <= was + 0.005 * spacing,
             (std::to_string(off / spacing) + " was " + std::to_string(was / spacing)).c_str());
}

void FewSamplesTest::theRestKeepsEveryBit() {
    const surface::Surface before = ball(few);
    const auto radius = static_cast<float>(spacing);
    const auto after = process::refinedUnder(before, place, radius);
    QVERIFY(after);
    const std::vector<surfel::Surfel> now = surfelsOf(*after);
    int far = 0;
    for (const surfel::Surfel& each : surfelsOf(before))
        if (distance(each.position, place) > 5 * radius) {
            ++far;
            QVERIFY(std::find(now.begin(), now.end(), each) != now.end());
        }
    QVERIFY(far > 100);
}

void FewSamplesTest::theSurfaceStaysWhereItWas_data() {
    QTest::addColumn<double>("radius"); // in spacings
    for (const double radius : {0.6, 1.0})
        QTest::addRow("%g spacings", radius) << radius;
}

/// Beside the brush, too, where fine samples border on those that stay: it would be lifted there before a dab began.
void FewSamplesTest::theSurfaceStaysWhereItWas() {
    QFETCH(double, radius);
    base::Random random(test::seed());
    double most = 0, sum = 0;
    int count = 0;
    for (int k = 0; k < test::effort(6); ++k) {
        const surface::Surface before = wavyBody(random);
        const Vec3f at = before.tree().block(0)->position(static_cast<int>(random.below(64)));
        const auto r = static_cast<float>(radius * spacing);
        const auto after = process::refinedUnder(before, at, r);
        QVERIFY(after);
        for (int j = 0; j < test::effort(200); ++j) {
            const Vec3d x = base::cast<double>(at) + random.unitVector() * (random.uniform(0, 6) * double(r));
            const auto was = surface::projectReference(before, x);
            if (!was.ok() || distance(was.foot, x) > 3 * spacing)
                continue;
            const auto is = surface::projectReference(*after, was.foot);
            QVERIFY(is.ok());
            const double moved = distance(is.foot, was.foot) / spacing;
            most = std::max(most, moved), sum += moved * moved, ++count;
        }
    }
    const double rms = std::sqrt(sum / std::max(1, count));
    QVERIFY2(count > 10 && rms < 0.0007 && most < 0.015,
             (std::to_string(rms) + " " + std::to_string(most) + " seed " + std::to_string(test::seed())).c_str());
}

void FewSamplesTest::denseModelsAndWideBrushesKeepAll() {
    const auto radius = static_cast<float>(spacing);
    QVERIFY(!process::refinedUnder(ball(few, 38), place, radius));
    QVERIFY(!process::refinedUnder(ball(few), place, 4 * radius)); // supports are below half of it
    QVERIFY(!process::refinedUnder(ball(few), place, 0));
    QVERIFY(!process::refinedUnder({}, place, radius));
}

void FewSamplesTest::maskedSamplesStay() {
    surfel::SurfelList list = ball(few).tree().surfels();
    for (surfel::Surfel& each : list.items)
        each.mask = each.position.x > 0.3f ? 1.0f : 0.0f;
    const surface::Surface before{tree::SurfelTree::build(list), fewNeighbours()};
    const auto after = process::refinedUnder(before, place, static_cast<float>(spacing));
    QVERIFY(after);
    const std::vector<surfel::Surfel> now = surfelsOf(*after);
    for (const surfel::Surfel& each : list.items)
        QVERIFY(each.mask == 0 || std::find(now.begin(), now.end(), each) != now.end());
}

/// And what is new belongs to the cell that it is in.
void FewSamplesTest::cellsAreRefinedAwayFromCreases() {
    surfel::SurfelList list = ball(few).tree().surfels();
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    for (const char* name : {"cell", "partner", "sign"})
        layout->add(name, surfel::ScalarType::UInt8);
    list.layout = layout;
    list.extra.clear();
    for (const surfel::Surfel& each : list.items) {
        const std::uint32_t cell = each.position.z > -0.5f ? 3 : 5;
        list.extra.insert(list.extra.end(), {cell, cell, 0});
    }
    const surface::Surface before{tree::SurfelTree::build(list), fewNeighbours()};
    const auto radius = static_cast<float>(spacing);
    QVERIFY(!process::refinedUnder(before, {std::sqrt(0.75f), 0, -0.5f}, radius));
    const auto after = process::refinedUnder(before, place, radius);
    QVERIFY(after && after->tree().size() > before.tree().size() + 100);
    const std::size_t word = after->tree().layout()->find("cell")->firstWord;
    const surfel::SurfelList now = after->tree().surfels();
    for (std::size_t i = 0; i < now.size(); ++i)
        QCOMPARE(now.extraOf(i)[word], now.items[i].position.z > -0.5f ? 3u : 5u);
}

void FewSamplesTest::onceIsEnough() {
    const auto radius = static_cast<float>(spacing);
    for (const surface::Surface& before : {ball(few), ring()}) {
        const Vec3f at = before.tree().block(0)->position(0);
        const auto after = process::refinedUnder(before, at, radius);
        QVERIFY(after);
        QVERIFY(!process::refinedUnder(*after, at, radius));
        // nor after a short way
        QVERIFY(
            !process::refinedUnder(*after, at + base::perpendicular(base::normalized(at)) * (0.2f * radius), radius));
    }
}

void FewSamplesTest::dabsAreThoseOfDenseModels_data() {
    QTest::addColumn<double>("radius"); // in spacings
    for (const double radius : {1.0, 2.0, 3.0})
        QTest::addRow("%g spacings", radius) << radius;
}

/// Of the height that both raise the surface by, half a percent in the mean.
void FewSamplesTest::dabsAreThoseOfDenseModels() {
    QFETCH(double, radius);
    const auto r = static_cast<float>(radius * spacing);
    const surface::Surface coarse = raised(ball(few), place * 2.0f, -place, r);
    const surface::Surface dense = raised(ball(many), place * 2.0f, -place, r);
    std::vector<Vec3d> places;
    double height = 0;
    for (const surfel::Surfel& each : surfelsOf(dense)) {
        const auto p = base::cast<double>(each.position);
        height = std::max(height, length(p) - 1);
        if (distance(each.position, place) < 1.2f * r && static_cast<int>(places.size()) < test::effort(400))
            places.push_back(p);
    }
    QVERIFY2(height > 0.3 * double(r), std::to_string(height / double(r)).c_str());
    const auto [off, lost] = away(coarse, places);
    QCOMPARE(lost, 0);
    QVERIFY2(off <= 0.005 * height, std::to_string(off / height).c_str());
}

/// The upper part of a ball, which ends where its samples do.
static surface::Surface bowl(std::size_t count, float lowest) {
    surface::SurfaceDefinition definition = fewNeighbours();
    definition.boundary = surface::Boundary::Limit;
    definition.boundaryLimit = 0.24f;
    surfel::SurfelList all = ball(count).tree().surfels();
    std::erase_if(all.items, [&](const surfel::Surfel& each) { return each.position.z < lowest; });
    return {tree::SurfelTree::build(all), definition};
}

void FewSamplesTest::atRimsToo() {
    const auto r = static_cast<float>(spacing);
    const Vec3f at = base::normalized(Vec3f{0.6f, 0.8f, 0.1f});
    const surface::Surface coarse = bowl(few, 0);
    const auto refined = process::refinedUnder(coarse, at, r);
    QVERIFY(refined);
    for (const surfel::Surfel& each : surfelsOf(*refined))
        QVERIFY(distance(each.position, at) > r || each.support <= 0.5f * r);
    const surface::Surface raisedCoarse = raised(coarse, at * 2.0f, -at, r);
    std::vector<Vec3d> places;
    double height = 0;
    for (const surfel::Surfel& each : surfelsOf(raised(bowl(many, -0.2f), at * 2.0f, -at, r))) {
        const auto p = base::cast<double>(each.position);
        const Vec3d below = base::normalized(base::normalized(p) - Vec3d{0, 0, 0.3 * spacing});
        if (distance(each.position, at) > 1.2f * r || away(coarse, {below}).second > 0)
            continue; // it is at the rim itself, which moves by a twentieth of a spacing
        height = std::max(height, length(p) - 1);
        if (static_cast<int>(places.size()) < test::effort(400))
            places.push_back(p);
    }
    const auto [off, lost] = away(raisedCoarse, places);
    QCOMPARE(lost, 0);
    QVERIFY2(off <= 0.01 * height, std::to_string(off / height).c_str());
}

/// A path: what was refined under it stays fine at its end.
void FewSamplesTest::theStrokeKeepsTheFineSpacing() {
    const auto r = static_cast<float>(spacing);
    sculpt::Stroke stroke(ball(few), test::settingsOf("draw", r));
    for (int k = 0; k <= test::effort(20); ++k)
        stroke.add(test::down(-0.2f + 0.02f * static_cast<float>(k), 0.1f));
    const std::size_t during = stroke.surface().tree().size();
    stroke.finish();
    const std::size_t after = stroke.surface().tree().size();
    QVERIFY(during > few + 80);
    QVERIFY2(double(after) > 0.9 * double(during) && double(after) < 1.2 * double(during),
             (std::to_string(during) + " " + std::to_string(after)).c_str());
}

void FewSamplesTest::theSameBitsAtAnyThreadCount() {
    const auto r = static_cast<float>(1.3 * spacing);
    const auto hash = [&] { return raised(ball(few), place * 2.0f, -place, r).tree().contentHash(); };
    const auto one = test::onThreads(1, hash);
    QVERIFY(one == test::onThreads(4, hash));
}

static const test::Registered<FewSamplesTest> registered;
#include "few_samples_test.moc"
