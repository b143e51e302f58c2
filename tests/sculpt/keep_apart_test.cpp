// What is thin keeps its two sides, whatever tool works on it; what is not thin is not looked at.
#include "core/sculpt/keep_apart.h"
#include "sculpt/random_plate.h"
#include "sculpt/stroke_samples.h"
#include "support/registry.h"

#include <algorithm>
#include <array>
#include <QTest>

using namespace sculpt;
using base::Vec3f;

class KeepApartTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void initTestCase();
    void strongStrokesLeaveThinPlatesTheirTwoSides_data();
    void strongStrokesLeaveThinPlatesTheirTwoSides();
    void whatComesTooNearStops();
    void whatIsThickIsAsTheToolHasIt();
    void howSurfelsLieInBlocksChangesNothing();

  private:
    struct Plate {
        double thick;
        surface::Surface surface;
    };
    std::vector<Plate> m_plates; ///< for all tools
};

constexpr double s = 0.02;

void KeepApartTest::initTestCase() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(4); ++k) {
        const double thick = random.uniform(0.8, 2.4) * s;
        m_plates.push_back({thick, test::randomPlate(random, {0.45, 0.35, thick}, s)});
    }
}

/// Surfels without a foot of their own: where two sides have become one nothing is left of the surface.
static int withoutFoot(const surface::Surface& surface) {
    const auto surfels = surface.tree().surfels().items;
    std::vector<Vec3f> places;
    for (const surfel::Surfel& each : surfels)
        places.push_back(each.position);
    surface::ProjectOptions options;
    options.checkBoundary = false;
    std::vector<surface::Projection<float>> feet(places.size());
    surface::project(surface, places, options, feet);
    int out = 0;
    for (std::size_t i = 0; i < feet.size(); ++i)
        out += !feet[i].ok() || distance(feet[i].foot, places[i]) > 0.5f * surfels[i].support ? 1 : 0;
    return out;
}

void KeepApartTest::strongStrokesLeaveThinPlatesTheirTwoSides_data() {
    QTest::addColumn<QString>("tool");
    for (const ToolRow& each : toolTable())
        if (movesSurfaces(each))
            QTest::newRow(each.id) << each.id;
}

void KeepApartTest::strongStrokesLeaveThinPlatesTheirTwoSides() {
    QFETCH(QString, tool);
    base::Random random(test::seed());
    int k = 0;
    for (const auto& [thick, plate] : m_plates) {
        StrokeSettings settings = test::settingsOf(qPrintable(tool), float(random.uniform(0.08, 0.16)));
        settings.strength = float(random.uniform(0.7, 1));
        settings.invert = k++ % 3 == 2;
        if (sculpt::tool(settings.tool).needs.source)
            settings.parameters = {{"x", 0.1}, {"y", 0.1}, {"z", 0.5 * thick}};
        const Vec3f view = normalized(Vec3f{0, 0, -1} + base::cast<float>(random.unitVector()) * 0.5f);
        const Vec3f at{float(random.uniform(-0.2, 0.2)), float(random.uniform(-0.15, 0.15)), 0};
        const Vec3f along = base::perpendicular(view) * (1.5f * settings.radius);
        std::vector<StrokeSample> path;
        for (int i = 0; i <= 16; ++i)
            path.push_back({{at + along * (float(i) / 8 - 1) - view, view}, 1, 0.1f * float(i)});
        const int lost = withoutFoot(test::stroked(plate, settings, path));
        QVERIFY2(
            lost <= 5,
            qPrintable(QString("%1 without a foot, %2 spacings, seed %3").arg(lost).arg(thick / s).arg(test::seed())));
    }
}

/// All surfels of the version moved at random, by up to `way`, smoothly.
static tree::Edit shaken(const surface::Surface& version, base::Random& random, float way) {
    const Vec3f wave = base::cast<float>(random.unitVector()) * 40.0f, by{0, 0, way};
    tree::Edit out;
    version.tree().forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        const surfel::MutableBlockPtr changed = block.clone();
        for (int slot = 0; slot < block.size(); ++slot) {
            const Vec3f p = block.position(slot);
            const float side = block.normal(slot).z > 0 ? -1.0f : 0.5f;
            changed->setPosition(slot, p + by * (side * std::sin(dot(wave, p))));
        }
        changed->seal();
        out.blocks.push_back({number, changed, {}});
    });
    return out;
}

void KeepApartTest::whatComesTooNearStops() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(5); ++k) {
        const double thick = random.uniform(0.6, 2) * s;
        const surface::Surface plate = test::randomPlate(random, {0.3, 0.3, thick}, s);
        const tree::Edit plain = shaken(plate, random, float(thick)), kept = keptApart(plate, plain, 0);
        const auto before = plate.tree().surfels().items;
        const auto nearest = [&](const tree::Edit& edit) { // of two sides, in spacings, along the plate's normal
            const auto after = plate.tree().apply(edit).surfels().items;
            double out = 10;
            for (std::size_t i = 0; i < before.size(); ++i)
                for (std::size_t j = 0; j < before.size(); ++j) {
                    const Vec3f d = before[i].position - before[j].position;
                    if (before[i].normal.z > 0.9f && before[j].normal.z < -0.9f && std::hypot(d.x, d.y) < 0.5 * s)
                        out = std::min(out, double(after[i].position.z - after[j].position.z) / s);
                }
            return out;
        };
        // Spacings are estimated, and two that both give way share what lacks by their ways.
        QVERIFY2(nearest(kept) > 0.35 && nearest(plain) < 0.35,
                 qPrintable(QString("%1 from %2, seed %3").arg(nearest(kept)).arg(nearest(plain)).arg(test::seed())));
    }
}

void KeepApartTest::whatIsThickIsAsTheToolHasIt() {
    base::Random random(test::seed());
    for (const surface::Surface& thick :
         {test::surfaceOf(test::spherePoints(4000)), test::randomPlate(random, {0.4, 0.4, 0.2}, s)}) {
        const tree::Edit plain = shaken(thick, random, float(s)), kept = keptApart(thick, plain, 0);
        for (std::size_t i = 0; i < plain.blocks.size(); ++i)
            QVERIFY(kept.blocks[i].changed == plain.blocks[i].changed);
    }
}

/// Those that face against the push are pushed, most in the middle.
static tree::Edit pushed(const tree::SurfelTree& tree, const Vec3f& centre, float radius, const Vec3f& push) {
    tree::Edit out;
    for (std::uint32_t number = 0; number < tree.blockCount(); ++number) {
        const surfel::BlockPtr block = tree.block(number);
        const surfel::MutableBlockPtr changed = block->clone();
        bool any = false;
        for (int slot = 0; slot < block->size(); ++slot) {
            const float off = distance(block->position(slot), centre) / radius;
            if (off >= 1 || dot(block->normal(slot), push) >= 0)
                continue;
            changed->setPosition(slot, block->position(slot) + push * (1 - off * off));
            any = true;
        }
        if (!any)
            continue;
        changed->seal();
        tree::BlockEdit edit;
        edit.block = number;
        edit.changed = changed;
        out.blocks.push_back(edit);
    }
    return out;
}

/// Blocks and clusters are left out as wholes: one surfel far away has all of them cut elsewhere.
void KeepApartTest::howSurfelsLieInBlocksChangesNothing() {
    base::Random random(test::seed() + 1);
    int held = 0;
    for (int round = 0; round < test::effort(10); ++round) {
        const Plate& plate = m_plates[random.below(m_plates.size())];
        const surfel::SurfelList list = plate.surface.tree().surfels();
        surfel::SurfelList cutElsewhere = list;
        cutElsewhere.items.push_back(list.items[0]);
        cutElsewhere.items.back().position = {10, 7, 3};
        const surfel::Surfel& at = list.items[random.below(list.size())];
        const Vec3f push = (base::cast<float>(random.unitVector()) * 0.5f - at.normal) *
                           static_cast<float>(random.uniform(0.5, 12) * s);
        using Way = std::array<float, 6>; // before, after
        const auto waysIn = [&](const surfel::SurfelList& surfels) {
            const surface::Surface version(tree::SurfelTree::build(surfels), plate.surface.definition());
            const tree::Edit whole = pushed(version.tree(), at.position, 0.2f, push);
            const tree::Edit kept = keptApart(version, whole, static_cast<float>(s));
            std::vector<Way> out;
            for (std::size_t i = 0; i < kept.blocks.size(); ++i)
                for (int slot = 0; slot < kept.blocks[i].changed->size(); ++slot) {
                    const Vec3f from = version.tree().block(kept.blocks[i].block)->position(slot);
                    const Vec3f to = kept.blocks[i].changed->position(slot);
                    held += to != whole.blocks[i].changed->position(slot) ? 1 : 0;
                    if (to != from)
                        out.push_back({from.x, from.y, from.z, to.x, to.y, to.z});
                }
            std::sort(out.begin(), out.end());
            return out;
        };
        QVERIFY2(waysIn(list) == waysIn(cutElsewhere),
                 qPrintable(QString("round %1, seed %2").arg(round).arg(test::seed())));
    }
    QVERIFY(held > 0);
}

static const test::Registered<KeepApartTest> registered;
#include "keep_apart_test.moc"
