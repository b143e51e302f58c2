// Large discs that stand out over their surface give way to finer ones that lie on it, and only those do.
#include "core/cells/labels.h"
#include "core/render/splats/cpu_splatter.h"
#include "core/render/splats/finer_blocks.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using namespace render;
using base::Vec3d;

class FinerBlocksTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void finerDiscsLieOnTheSurface();
    void finestDiscsHardlyStandOut();
    void discsStandOutAsTheirSurfaceBends();
    void edgesHoldTheirFinerDiscs_data();
    void edgesHoldTheirFinerDiscs();
    void discsOffTheSurfaceAreSettled();
    void facesWithoutCellsStayWhole();
    void updatesAreTheWholePicture_data();
    void updatesAreTheWholePicture();
};

namespace {

constexpr float radius = splatRadiusOfSupport;

std::vector<const surfel::SurfelBlock*> blocksOf(const tree::SurfelTree& model) {
    std::vector<const surfel::SurfelBlock*> out;
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) { out.push_back(&block); });
    return out;
}

std::vector<FinerBlocks::Wish> spreadOf(const std::vector<const surfel::SurfelBlock*>& blocks) {
    std::vector<FinerBlocks::Wish> out;
    for (const surfel::SurfelBlock* block : blocks)
        out.push_back({block, true, true});
    return out;
}

/// Samples of a cylinder of radius and half height 1 about z, some `spacing` apart, with a cell for the side (0) and
/// for each end; of a tube one for the inside (3), too.
surfel::SurfelList cylinder(double spacing, std::uint64_t seed, double inner = 0) {
    base::Random random(seed);
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    std::vector<cells::Label> labels;
    const auto add = [&](const Vec3d& p, const Vec3d& n, std::uint32_t cell, double toEdge) {
        surfel::Surfel s;
        s.position = base::cast<float>(p), s.normal = base::cast<float>(n);
        s.support = static_cast<float>(test::supportOfSpacing * spacing);
        out.items.push_back(s);
        cells::Label label{cell, cell};
        if (toEdge < 2 * spacing) {
            label.partner = cell == 0 || cell == 3                 ? (p.z > 0 ? 1u : 2u)
                            : 2 * std::hypot(p.x, p.y) < 1 + inner ? 3u
                                                                   : 0u;
            label.meeting = cells::Meeting::Convex;
        }
        labels.push_back(label);
    };
    const auto jitter = [&] { return 0.3 * spacing * random.uniform(-1, 1); };
    const auto lattice = [&](double wide, double high, const auto& fn) {
        const auto columns = static_cast<int>(std::lround(wide / spacing)),
                   rows = static_cast<int>(std::lround(high / spacing));
        for (int i = 0; i < columns; ++i)
            for (int j = 0; j < rows; ++j)
                fn((i + 0.5) * wide / columns + jitter(), (j + 0.5) * high / rows + jitter());
    };
    for (const double wall : {1.0, inner}) {
        if (wall > 0)
            lattice(2 * std::numbers::pi * wall, 2, [&](double way, double z) {
                const Vec3d n{std::cos(way / wall), std::sin(way / wall), 0};
                if (std::abs(z - 1) < 1)
                    add({wall * n.x, wall * n.y, z - 1}, wall < 1 ? -n : n, wall < 1 ? 3 : 0, 1 - std::abs(z - 1));
            });
    }
    for (const double end : {1.0, -1.0})
        lattice(2, 2, [&](double x, double y) {
            const Vec3d p{x - 1, y - 1, end};
            if (const double far = std::hypot(p.x, p.y); far < 1 && far > inner)
                add(p, {0, 0, end}, end > 0 ? 1 : 2, inner > 0 ? std::min(1 - far, far - inner) : 1 - far);
        });
    cells::setLabels(out, labels);
    return out;
}

double above(const Vec3d& x, double inner) {
    const double r = std::hypot(x.x, x.y);
    return std::max({r - 1, std::abs(x.z) - 1, inner > 0 ? inner - r : -1});
}

struct DrawnDisc {
    base::Vec3f centre, normal;
    float radius;
    DiscCut cut;

    bool covers(const base::Vec3f& x) const {
        const base::Vec3f way = x - centre, along = way - normal * dot(way, normal);
        const auto beyond = [&](const CutLine& line) {
            return line.part > 0 && dot(along, line.direction) > radius * line.part;
        };
        return length(along) <= radius * cut.radius && std::abs(dot(way, normal)) < radius && !beyond(cut) &&
               !beyond(cut.second);
    }
};

} // namespace

/// Seven for each surfel of a torus, but for some that have no foot near by. Of half of one, with a boundary limit,
/// none lies beyond it.
void FinerBlocksTest::finerDiscsLieOnTheSurface() {
    for (const bool ends : {false, true}) {
        surfel::SurfelList list = test::torus(0.7, 0.3, 1500, test::seed());
        if (ends)
            std::erase_if(list.items, [](const surfel::Surfel& s) { return s.position.x > 0; });
        const auto model = test::built(list);
        surface::SurfaceDefinition definition;
        if (ends)
            definition.boundaryLimit = 0.3f;
        FinerBlocks finer;
        finer.use(definition, radius);
        finer.follow(model);
        const auto blocks = blocksOf(model);
        finer.standOut(blocks);
        finer.prepare(spreadOf(blocks));
        const surface::Surface surface(model, definition);
        std::size_t count = 0, cut = 0;
        for (const surfel::SurfelBlock* block : blocks)
            for (const FinerBlocks::Part& part : finer.of(block)) {
                cut += part.cuts ? 1 : 0;
                for (int i = 0; i < part.block->size(); ++i, ++count) {
                    const surface::Evaluationf at = surface.evaluate(part.block->position(i), surface::Need::Gradient);
                    const float support = part.block->support(i);
                    const QString told = QString("%1 of %2, seed %3").arg(i).arg(count).arg(test::seed());
                    QVERIFY2(at.ok() && std::abs(at.value) < 1e-4f * support, qPrintable(told));
                    QVERIFY2(dot(part.block->normal(i), normalized(at.gradient)) > 0.999f, qPrintable(told));
                    QVERIFY2(!ends || at.offCentre <= 1.001f * definition.boundaryLimit * at.unit, qPrintable(told));
                }
            }
        QCOMPARE(cut > 0, ends);
        QVERIFY2(double(count) > 6.9 * double(list.size()),
                 qPrintable(QString("%1 for %2, seed %3").arg(count).arg(list.size()).arg(test::seed())));
    }
}

/// As many as it takes for few pixels, most of them without a projection of their own: what stands out is below one,
/// and they lie on the surface to half of that.
void FinerBlocksTest::finestDiscsHardlyStandOut() {
    const surfel::SurfelList list = test::torus(0.7, 0.3, 400, test::seed());
    const auto model = test::built(list);
    FinerBlocks finer;
    finer.use({}, radius);
    finer.follow(model);
    const auto blocks = blocksOf(model);
    finer.standOut(blocks);
    std::vector<FinerBlocks::Wish> wishes = spreadOf(blocks);
    const float pixel = radius * list.items.front().support / 40;
    for (FinerBlocks::Wish& wish : wishes)
        wish.pixel = pixel;
    finer.prepare(wishes);
    const surface::Surface surface(model, {});
    std::size_t count = 0, far = 0, large = 0;
    for (const surfel::SurfelBlock* block : blocks)
        for (const FinerBlocks::Part& part : finer.of(block))
            for (int i = 0; i < part.block->size(); ++i, ++count) {
                const surface::Evaluationf at = surface.evaluate(part.block->position(i), surface::Need::Gradient);
                far += !at.ok() || std::abs(at.value) > 0.5f * pixel ? 1 : 0;
                const float r = radius * part.block->support(i);
                large += r * r / (2 * 0.3f) > 1.5f * pixel ? 1 : 0;
            }
    const QString told = QString("%1 of %2 far, %3 large, seed %4").arg(far).arg(count).arg(large).arg(test::seed());
    QVERIFY2(count > 15 * list.size(), qPrintable(told));
    QVERIFY2(200 * far < count && 50 * large < count, qPrintable(told));
}

/// A ball whose samples lie off it by noise: one disc for each on its surface; without noise nothing is off, and with
/// cells nobody asks.
void FinerBlocksTest::discsOffTheSurfaceAreSettled() {
    surfel::SurfelList list = test::sphere({0, 0, 0}, 1, 4000);
    const float support = list.items.front().support;
    const auto offOf = [](FinerBlocks& finer, const tree::SurfelTree& model) {
        finer.use({}, radius);
        finer.follow(model);
        return finer.offSurface(blocksOf(model));
    };
    FinerBlocks clean, noisy, divided;
    for (const float each : offOf(clean, test::built(list)))
        QVERIFY2(each < 0.02f * support, qPrintable(QString::number(double(each / support))));
    for (const float each : offOf(divided, test::built(cylinder(0.19, test::seed(), 0))))
        QCOMPARE(each, 0.0f);
    base::Random random(test::seed());
    for (surfel::Surfel& s : list.items)
        s.position += s.normal * (support * random.uniform(-0.2f, 0.2f));
    const auto model = test::built(list);
    for (const float each : offOf(noisy, model))
        QVERIFY2(each > 0.1f * support, qPrintable(QString::number(double(each / support))));
    const surface::Surface surface(model, {});
    std::vector<FinerBlocks::Wish> wishes;
    for (const surfel::SurfelBlock* block : blocksOf(model))
        wishes.push_back({block, false, false});
    noisy.prepare(wishes);
    for (const FinerBlocks::Wish& wish : wishes) {
        QCOMPARE(noisy.of(wish.block).size(), std::size_t(1));
        const surfel::SurfelBlock& there = *noisy.of(wish.block).front().block;
        QCOMPARE(there.size(), wish.block->size());
        for (int i = 0; i < there.size(); ++i) {
            const surface::Evaluationf at = surface.evaluate(there.position(i), surface::Need::Gradient);
            QVERIFY2(at.ok() && std::abs(at.value) < 1e-3f * support,
                     qPrintable(QString("%1, seed %2").arg(double(at.value / support)).arg(test::seed())));
            QCOMPARE(there.support(i), wish.block->support(i));
        }
    }
}

/// R^2 / 2 rho on a ball of radius rho, nothing in a plane.
void FinerBlocksTest::discsStandOutAsTheirSurfaceBends() {
    const auto most = [](const surfel::SurfelList& list) {
        const auto model = test::built(list);
        FinerBlocks finer;
        finer.use({}, radius);
        finer.follow(model);
        std::pair<float, float> out{1e9f, 0};
        for (const float each : finer.standOut(blocksOf(model)))
            out = {std::min(out.first, each), std::max(out.second, each)};
        return out;
    };
    const surfel::SurfelList ball = test::sphere({0, 0, 0}, 1, 4000);
    const float disc = radius * ball.items.front().support, told = 0.5f * disc * disc;
    const auto [least, largest] = most(ball);
    QVERIFY2(least > 0.98f * told && largest < 1.02f * told,
             qPrintable(QString("%1 %2 of %3").arg(least).arg(largest).arg(told)));
    QVERIFY(most(test::disc({0, 0, 0}, {0, 0, 1}, 1, 0.05)).second < 1e-6f);
}

void FinerBlocksTest::edgesHoldTheirFinerDiscs_data() {
    QTest::addColumn<double>("inner");
    QTest::newRow("cylinder") << 0.0;
    QTest::newRow("tube of a thin wall") << 0.875; // its ends are narrower than a spacing
}

/// Around the ends of a cylinder: discs lie on their own side of the edge, none reaches past it by more than bent ones
/// of their size do, and together they cover all of it.
void FinerBlocksTest::edgesHoldTheirFinerDiscs() {
    QFETCH(double, inner);
    const auto model = test::built(cylinder(0.19, test::seed(), inner));
    FinerBlocks finer;
    finer.use({}, radius);
    finer.follow(model);
    const auto blocks = blocksOf(model);
    for (const float each : finer.standOut(blocks)) // ends are flat, and their edges are not
        QVERIFY2(each > 0.05f * radius, qPrintable(QString::number(each)));
    finer.prepare(spreadOf(blocks));
    base::Random random(test::seed());
    std::vector<DrawnDisc> discs;
    std::size_t cut = 0, points = 0, out = 0;
    double farthest = 0;
    for (const surfel::SurfelBlock* block : blocks)
        for (const FinerBlocks::Part& part : finer.of(block))
            for (int i = 0; i < part.block->size(); ++i) {
                const float support = part.block->support(i);
                const CutCode code = part.cuts ? (*part.cuts)[static_cast<std::size_t>(i)] : wholeDisc;
                const DrawnDisc disc{part.block->position(i), part.block->normal(i), radius * support,
                                     discCut(part.block->normal(i), support, code)};
                cut += code != wholeDisc ? 1 : 0;
                discs.push_back(disc);
                farthest = std::max(farthest, std::abs(above(base::cast<double>(disc.centre), inner)));
                const double bend = 0.5 * double(disc.radius) * double(disc.radius);
                for (int k = 0; k < 8; ++k) {
                    const base::Vec3f u = base::perpendicular(disc.normal), v = cross(disc.normal, u);
                    const auto angle = static_cast<float>(random.uniform(0, 2 * std::numbers::pi));
                    const float far = disc.radius * static_cast<float>(std::sqrt(random.uniform()));
                    const base::Vec3f x = disc.centre + (u * std::cos(angle) + v * std::sin(angle)) * far;
                    if (!disc.covers(x))
                        continue;
                    ++points;
                    out += above(base::cast<double>(x), inner) > 1.2 * bend + 0.05 * double(disc.radius) ? 1 : 0;
                }
            }
    std::size_t bare = 0;
    constexpr std::size_t places = 4000;
    for (std::size_t k = 0; k < places; ++k) { // within a spacing of the upper edge
        const double angle = random.uniform(0, 2 * std::numbers::pi),
                     back = random.uniform(0, std::min(0.19, 1 - inner));
        const bool side = k % 2 == 0;
        const double r = side ? 1 : 1 - back;
        const auto x = base::cast<float>(Vec3d{r * std::cos(angle), r * std::sin(angle), side ? 1 - back : 1});
        bare += std::none_of(discs.begin(), discs.end(),
                             [&](const DrawnDisc& each) {
                                 const bool ofSide = std::abs(each.normal.z) < 0.5f;
                                 return ofSide == side && each.covers(x);
                             })
                    ? 1
                    : 0;
    }
    const QString told = QString("%1 discs, %2 cut, %3 of %4 points out, %5 of %6 bare, centres off by %7, seed %8")
                             .arg(discs.size())
                             .arg(cut)
                             .arg(out)
                             .arg(points)
                             .arg(bare)
                             .arg(places)
                             .arg(farthest)
                             .arg(test::seed());
    QVERIFY2(discs.size() > 6 * model.size() && cut > model.size() / 4, qPrintable(told));
    QVERIFY2(farthest < 0.02, qPrintable(told));
    QVERIFY2(out <= points / (inner > 0 ? 500 : 1000), qPrintable(told));
    QVERIFY2(inner > 0 || bare <= places / 200, qPrintable(told)); // one row has gaps of its own
}

void FinerBlocksTest::facesWithoutCellsStayWhole() {
    const auto model = test::built(test::sphere({0, 0, 0}, 1, 500));
    RenderOptions options;
    QVERIFY(FinerBlocks::any(model, options));
    options.detailPx = 2; // in a view that moves
    QVERIFY(!FinerBlocks::any(model, options));
    options = {};
    options.definition.manifold = surface::Manifold::Curve;
    QVERIFY(!FinerBlocks::any(model, options));
    for (const bool cells : {false, true}) {
        surfel::SurfelList list = cells ? cylinder(0.3, test::seed()) : test::sphere({0, 0, 0}, 1, 100);
        auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
        layout->add("patch", surfel::ScalarType::Int32); // faces with sharp edges
        surfel::SurfelList with;
        with.layout = layout;
        for (std::size_t i = 0; i < list.size(); ++i) {
            std::vector<std::uint32_t> words(list.extraOf(i).begin(), list.extraOf(i).end());
            words.resize(layout->words());
            with.append(list.items[i], words);
        }
        QCOMPARE(FinerBlocks::any(tree::SurfelTree::build(with), {}), cells);
    }
}

/// Finer discs of blocks that an edit leaves alone follow what is about them.
void FinerBlocksTest::updatesAreTheWholePicture_data() {
    QTest::addColumn<bool>("cells");
    QTest::newRow("smooth") << false;
    QTest::newRow("cells") << true;
}

void FinerBlocksTest::updatesAreTheWholePicture() {
    QFETCH(bool, cells);
    auto version = test::built(cells ? cylinder(0.17, test::seed()) : test::torus(0.7, 0.3, 1500, test::seed()));
    const Camera camera = test::cutTilesCamera();
    CpuSplatter splatter;
    Image image;
    base::Random random(test::seed());
    for (int k = 0; k < 6; ++k) {
        RenderOptions options;
        options.detailPx = k == 3 ? 2 : 1; // and what an edit changed in between
        splatter.update(version, camera, options, image);
        CpuSplatter fresh;
        const Image whole = test::drawn(fresh, version, camera, options);
        QVERIFY2(image.colour == whole.colour && image.depth == whole.depth,
                 qPrintable(QString("%1, seed %2").arg(k).arg(test::seed())));
        const base::Vec3f centre = base::cast<float>(random.unitVector() * 0.8);
        tree::Edit edit;
        edit.inserted.layout = version.layout();
        version.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
            std::bitset<surfel::blockCapacity> gone;
            for (int slot = 0; slot < block.size(); ++slot)
                if (distance(block.position(slot), centre) < 0.3f) {
                    gone[static_cast<std::size_t>(slot)] = true;
                    surfel::Surfel moved = block.surfel(slot);
                    moved.position += moved.normal * 0.05f;
                    std::vector<std::uint32_t> words(version.layout()->words());
                    for (std::size_t w = 0; w < words.size(); ++w)
                        words[w] = block.words(slot / surfel::clusterSize,
                                               surfel::Extra + static_cast<int>(w))[slot % surfel::clusterSize];
                    edit.inserted.append(moved, words);
                }
            if (gone.any())
                edit.blocks.push_back({number, {}, gone});
        });
        version = version.apply(edit);
    }
}

static const test::Registered<FinerBlocksTest> registered;
#include "finer_blocks_test.moc"
