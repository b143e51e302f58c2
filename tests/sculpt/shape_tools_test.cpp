// What the tools that raise, gather and level do, against analytic shapes.
#include "sculpt/dabs.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;
using test::applied;
using test::dabOf;

class ShapeToolsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void drawSharpHasATip();
    void drawSharpHasAnEdgeAlongTheStroke();
    void clayStripsAreSquareAndNeverPassTheirPlane();
    void inflateSwellsASphereIntoASphere();
    void shrinkingStopsBeforeTwoSidesMeet();
    void layerNeverExceedsItsHeight();
    void layerCarriesFineReliefOnTop();
    void blobSpreadsAndCreaseGathers();
    void pinchKeepsThePlaneAndMovesAcrossTheStroke();
    void gatheringStopsWhereAFoldCloses();
    void flattenMakesANoisyPlaneFlatter();
    void fillMovesOnlyUpAndScrapeOnlyDown();
    void invertedLevellingIsItsOpposite();
};

constexpr double s = 0.02;

static surface::Surface plane(int rows = 80) {
    return test::surfaceOf(test::planePoints(rows, s));
}

static surface::Surface noisyPlane(float height) {
    surfel::SurfelList points = test::planePoints(80, s);
    base::Random random(test::seed());
    for (surfel::Surfel& each : points.items)
        each.position.z = height * float(random.uniform(-1, 1));
    return test::surfaceOf(points);
}

void ShapeToolsTest::drawSharpHasATip() {
    const Dab dab = dabOf(tool("draw-sharp"), {0.003f, 0.001f, 0}, 0.4f, 0.8f);
    for (const surfel::Surfel& each : applied(tool("draw-sharp"), plane(), dab).tree().surfels().items) {
        const double r =
            std::hypot(double(each.position.x - dab.centre.x), double(each.position.y - dab.centre.y)) / 0.4;
        const double left = std::max(0.0, 1 - r);
        const double expected = -0.8 * 0.1 * 0.4 * double(weight(Falloff::Smooth, float(r))) * left * left;
        QVERIFY(std::abs(double(each.position.z) - expected) < 1e-6);
        // At the tip itself the normals lean by the slope of the cone: 2 * 0.8 * 0.1.
        if (r > 1e-3 && r < 0.1)
            QVERIFY(std::abs(std::hypot(double(each.normal.x), double(each.normal.y)) / double(each.normal.z) - 0.16) <
                    0.04);
    }
}

void ShapeToolsTest::drawSharpHasAnEdgeAlongTheStroke() {
    Dab dab = dabOf(tool("draw-sharp"), {0.003f, 0.001f, 0}, 0.4f, -0.8f);
    dab.travel = {0, 0.04f, 0.01f};
    for (const surfel::Surfel& each : applied(tool("draw-sharp"), plane(), dab).tree().surfels().items) {
        const double x = double(each.position.x - dab.centre.x), y = double(each.position.y - dab.centre.y);
        const double r = std::hypot(x, y) / 0.4, left = std::max(0.0, 1 - std::abs(x) / 0.4);
        const double expected = 0.8 * 0.1 * 0.4 * double(weight(Falloff::Smooth, float(r))) * left * left;
        QVERIFY(std::abs(double(each.position.z) - expected) < 1e-6);
        if (std::abs(y) < 0.01 && std::abs(x) > 1e-3 && std::abs(x) < 0.04)
            QVERIFY(double(each.normal.x) * x > 0 && std::abs(double(each.normal.x)) > 0.1); // away from the crest
    }
}

void ShapeToolsTest::clayStripsAreSquareAndNeverPassTheirPlane() {
    Dab dab = dabOf(tool("clay-strips"), {}, 0.4f, 1);
    dab.travel = normalized(base::Vec3f{1, 1, 0}) * 0.04f;
    surface::Surface now = plane();
    const surface::Surface once = applied(tool("clay-strips"), now, dab);
    float corner = 0, side = 0, full = 0;
    for (const surfel::Surfel& each : once.tree().surfels().items) {
        const float u = (each.position.x + each.position.y) * std::sqrt(0.5f) / 0.4f,
                    v = (each.position.y - each.position.x) * std::sqrt(0.5f) / 0.4f;
        const float z = each.position.z;
        if (std::abs(u) < 0.2f && std::abs(v) < 0.2f)
            full = std::max(full, z);
        if (std::abs(u) > 0.66f || std::abs(v) > 0.66f)
            side = std::max(side, z);
        if (std::abs(u) > 0.35f && std::abs(u) < 0.42f && std::abs(v) > 0.35f && std::abs(v) < 0.42f)
            corner = std::max(corner, z);
    }
    QVERIFY(full > 0.01f && side == 0);
    QVERIFY2(corner > 0.8f * full,
             qPrintable(QString::number(double(corner / full)))); // a round tip has fallen off here
    for (int k = 0; k < 200; ++k)
        now = applied(tool("clay-strips"), now, dab);
    const float top = now.tree().bounds().hi.z;
    QVERIFY(top <= 0.18f * 0.4f && top > 0.9f * 0.18f * 0.4f);
}

void ShapeToolsTest::inflateSwellsASphereIntoASphere() {
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(8000));
    for (const float strength : {1.0f, -1.0f}) {
        Dab dab = dabOf(tool("inflate"), {0, 0, 1}, 4, strength);
        dab.falloff = Falloff::Constant;
        for (const surfel::Surfel& each : applied(tool("inflate"), sphere, dab).tree().surfels().items) {
            QVERIFY(std::abs(length(each.position) - (1 + 0.2f * strength)) < 2e-4f);
            QVERIFY(length(each.normal - normalized(each.position)) < 3e-3f);
        }
    }
}

void ShapeToolsTest::shrinkingStopsBeforeTwoSidesMeet() {
    surfel::SurfelList plate = test::planePoints(60, s);
    const std::size_t side = plate.items.size();
    for (std::size_t i = 0; i < side; ++i) {
        surfel::Surfel& above = plate.items[i];
        above.position.z = 3 * float(s);
        surfel::Surfel below = above;
        below.position.z = -above.position.z, below.normal = -above.normal;
        plate.items.push_back(below);
    }
    for (const float radius : {0.3f, 0.6f, 1.2f}) { // with the last, one dab goes half through
        surface::Surface now = test::surfaceOf(plate);
        const Dab dab = dabOf(tool("inflate"), {0, 0, 3 * float(s)}, radius, -1);
        for (int k = 0; k < 8; ++k)
            now = applied(tool("inflate"), now, dab);
        float thinnest = 1;
        for (const surfel::Surfel& each : now.tree().surfels().items) {
            QVERIFY(each.normal.z * each.position.z > 0); // on its own side, and facing out
            thinnest = std::min(thinnest, std::abs(each.position.z));
        }
        QVERIFY(radius > 0.6f || thinnest < 2.5f * float(s));
    }
}

void ShapeToolsTest::layerNeverExceedsItsHeight() {
    const ToolRow& row = tool("layer");
    for (const float sign : {1.0f, -1.0f}) {
        const surface::Surface first = test::surfaceOf(test::spherePoints(6000));
        surface::Surface now = first;
        std::vector<PastDab> past;
        base::Random random(test::seed());
        double highest = 0;
        for (int k = 0; k < 40; ++k) {
            const base::Vec3d towards =
                normalized(base::Vec3d{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 1});
            Dab dab = dabOf(row, base::cast<float>(towards), 0.5f, sign * float(random.uniform(0.3, 1)));
            dab.first = &first;
            dab.past = past;
            now = applied(row, now, dab);
            past.push_back({dab.centre, dab.radius, dab.strength});
        }
        for (const surfel::Surfel& each : now.tree().surfels().items) {
            const double height = double(sign) * (double(length(each.position)) - 1);
            QVERIFY2(height > -1e-4 && height < 0.05 + 1e-4, qPrintable(QString::number(height)));
            highest = std::max(highest, height);
        }
        QVERIFY2(highest > 0.049, qPrintable(QString::number(highest)));
    }
}

void ShapeToolsTest::layerCarriesFineReliefOnTop() {
    const ToolRow& row = tool("layer");
    const surface::Surface first = noisyPlane(0.004f);
    surface::Surface now = first;
    std::vector<PastDab> past;
    for (int k = 0; k < 20; ++k) {
        Dab dab = dabOf(row, {0.01f * float(k % 3), 0, 0}, 0.4f, 1);
        dab.first = &first;
        dab.past = past;
        now = applied(row, now, dab);
        past.push_back({dab.centre, dab.radius, dab.strength});
    }
    const auto roughness = [](const surface::Surface& surface) {
        double sum = 0, sq = 0, n = 0;
        for (const surfel::Surfel& each : surface.tree().surfels().items)
            if (std::hypot(each.position.x, each.position.y) < 0.15f)
                sum += double(each.position.z), sq += double(each.position.z) * double(each.position.z), ++n;
        return std::pair{sum / n, std::sqrt(sq / n - sum / n * sum / n)};
    };
    QVERIFY(std::abs(roughness(now).first - 0.04) < 1e-3);
    QVERIFY2(std::abs(roughness(now).second / roughness(first).second - 1) < 0.05,
             qPrintable(QString::number(roughness(now).second / roughness(first).second)));
}

/// Mean of the radial movement of what lies half way to the rim.
static double spread(const char* id, float strength, const base::Vec3f& travel) {
    const surface::Surface before = plane();
    Dab dab = dabOf(tool(id), {}, 0.4f, strength);
    dab.travel = travel;
    const tree::Edit edit = tool(id).apply(before, dab);
    double sum = 0, n = 0;
    for (const tree::BlockEdit& change : edit.blocks) {
        const surfel::BlockPtr old = before.tree().block(change.block);
        for (int slot = 0; slot < old->size(); ++slot) {
            const base::Vec3f p = old->position(slot), d = change.changed->position(slot) - p;
            if (length(p) > 0.15f && length(p) < 0.25f)
                sum += double(dot(d, p) / length(p)), ++n;
        }
    }
    return sum / n;
}

void ShapeToolsTest::blobSpreadsAndCreaseGathers() {
    for (const float strength : {0.8f, -0.8f}) {
        QVERIFY(spread("blob", strength, {}) > 1e-4);
        QVERIFY(spread("crease", strength, {}) < -1e-4);
    }
    const auto heightOf = [](const char* id, float strength) {
        const base::Box3f box = applied(tool(id), plane(), dabOf(tool(id), {}, 0.4f, strength)).tree().bounds();
        return box.hi.z + box.lo.z;
    };
    QVERIFY(std::abs(heightOf("blob", 1) - 0.02f) < 1e-5f && std::abs(heightOf("blob", -1) + 0.02f) < 1e-5f);
    QVERIFY(std::abs(heightOf("crease", 1) + 0.02f) < 1e-5f && std::abs(heightOf("crease", -1) - 0.02f) < 1e-5f);
}

void ShapeToolsTest::pinchKeepsThePlaneAndMovesAcrossTheStroke() {
    const surface::Surface before = plane();
    for (const float strength : {1.0f, -1.0f}) {
        Dab dab = dabOf(tool("pinch"), {0.01f, 0, 0}, 0.4f, strength);
        dab.travel = {0, 0.04f, 0};
        const tree::Edit edit = tool("pinch").apply(before, dab);
        QVERIFY(!edit.empty());
        for (const tree::BlockEdit& change : edit.blocks) {
            const surfel::BlockPtr old = before.tree().block(change.block);
            for (int slot = 0; slot < old->size(); ++slot) {
                const base::Vec3f p = old->position(slot), q = change.changed->position(slot);
                QVERIFY(q.z == 0 && q.y == p.y && length(change.changed->normal(slot) - base::Vec3f{0, 0, 1}) < 1e-6f);
                const double r = double(distance(p, dab.centre)) / 0.4, x = double(p.x) - 0.01;
                const double expected = -double(strength) * 0.1 * double(weight(Falloff::Smooth, float(r))) * x;
                QVERIFY(std::abs(double(q.x) - double(p.x) - expected) < 1e-6);
            }
        }
    }
    QVERIFY(spread("pinch", 1, {}) < -1e-4 && spread("pinch", -1, {}) > 1e-4); // from all sides without a direction
}

void ShapeToolsTest::gatheringStopsWhereAFoldCloses() {
    // Two walls half a support apart that face each other: their normals cancel.
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    for (const surfel::Surfel& each : test::planePoints(40, s).items)
        for (const float side : {-1.0f, 1.0f}) {
            surfel::Surfel wall = each;
            wall.position = {side * 0.01f, each.position.x, each.position.y};
            wall.normal = {-side, 0, 0};
            points.append(wall, {});
        }
    const surface::Surface fold = test::surfaceOf(points);
    for (const float strength : {1.0f, -1.0f}) {
        const tree::Edit edit = tool("pinch").apply(fold, dabOf(tool("pinch"), {0, 0, 0}, 0.2f, strength));
        QCOMPARE(edit.empty(), strength > 0); // spreading goes on
    }
}

static double roughness(const surface::Surface& surface) {
    double sq = 0, n = 0;
    for (const surfel::Surfel& each : surface.tree().surfels().items)
        if (std::hypot(each.position.x, each.position.y) < 0.2f)
            sq += double(each.position.z) * double(each.position.z), ++n;
    return std::sqrt(sq / n);
}

void ShapeToolsTest::flattenMakesANoisyPlaneFlatter() {
    const surface::Surface before = noisyPlane(0.02f);
    surface::Surface now = before;
    const Dab dab = dabOf(tool("flatten"), {}, 0.5f, 1);
    double last = roughness(now);
    for (int k = 0; k < 20; ++k) {
        now = applied(tool("flatten"), now, dab);
        QVERIFY(roughness(now) < last);
        last = roughness(now);
    }
    QVERIFY2(last < 0.1 * roughness(before), qPrintable(QString::number(last / roughness(before))));
}

void ShapeToolsTest::fillMovesOnlyUpAndScrapeOnlyDown() {
    const surface::Surface before = noisyPlane(0.02f);
    for (const char* id : {"fill", "scrape"}) {
        const float sign = std::string(id) == "fill" ? 1.0f : -1.0f;
        const tree::Edit edit = tool(id).apply(before, dabOf(tool(id), {}, 0.5f, 1));
        int moved = 0;
        for (const tree::BlockEdit& change : edit.blocks) {
            const surfel::BlockPtr old = before.tree().block(change.block);
            for (int slot = 0; slot < old->size(); ++slot) {
                const float z = old->position(slot).z, by = change.changed->position(slot).z - z;
                QVERIFY(sign * by >= 0 && (by == 0 || sign * z < 0));
                QVERIFY(sign * (z + by) <= std::max(0.0f, sign * z)); // never past the plane
                moved += by != 0;
            }
        }
        QVERIFY(moved > 200);
    }
}

void ShapeToolsTest::invertedLevellingIsItsOpposite() {
    const surface::Surface before = noisyPlane(0.02f);
    const auto after = [&](const char* id, float strength) {
        return test::hashOf(applied(tool(id), before, dabOf(tool(id), {}, 0.5f, strength)));
    };
    QVERIFY(after("fill", -0.7f) == after("scrape", 0.7f));
    QVERIFY(after("scrape", -0.7f) == after("fill", 0.7f));
    QVERIFY(roughness(applied(tool("flatten"), before, dabOf(tool("flatten"), {}, 0.5f, -1))) >
            1.05 * roughness(before));
}

static const test::Registered<ShapeToolsTest> registered;
#include "shape_tools_test.moc"
