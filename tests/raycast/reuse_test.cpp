// What an adaptive cast keeps: in another view, and after an edit.
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/raycast/edited_region.h"
#include "raycast_models.h"
#include "support/registry.h"

#include <atomic>
#include <QTest>

using namespace raycast;
using namespace views;

class ReuseTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void turnedViewCastsFewer_data();
    void turnedViewCastsFewer();
    void errorsDoNotAddUpOverManyViews();
    void backAndForthCastsLittle();
    void finerQualityDoesNotRestOnCoarser();
    void editCastsOnlyItsPart();
    void editIsSeenInAnotherView();
    void newSheetInFrontIsSeen();
    void sameContentCastsNothing();
    void otherDefinitionForgets();
    void sameBitsAtAnyThreadCount();
    void cancelledTurnGoesOn();
    void editedRegionHoldsEveryChange();
};

static ImageRays start(int pixels = 200) {
    return filling({}, 1.02, {0.3, 0.5, -1}, pixels);
}

static ImageRays around(double degrees, int pixels = 200) {
    return turned(start(pixels), {}, {0.2, 1, 0.1}, degrees);
}

static QByteArray text(const Difference& d, std::size_t rays, std::size_t fresh) {
    return QString("%1 of %2 hits pass, %3 false, %4 lost, %5 rays, %6 fresh, seed %7")
        .arg(d.passed)
        .arg(d.hits)
        .arg(d.falseHits)
        .arg(d.lost)
        .arg(rays)
        .arg(fresh)
        .arg(test::seed())
        .toUtf8();
}

/// The model with the surfels near `centre` raised along their normals, as a brush does it.
static Surface dabbed(const Surface& model, const base::Vec3f& centre, float radius, float height) {
    tree::Edit edit;
    model.tree().forBlocksInBall(centre, radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
        auto changed = block.clone();
        for (int i = 0; i < block.size(); ++i) {
            const float r = distance(block.position(i), centre) / radius;
            if (r < 1)
                changed->setPosition(i, block.position(i) + block.normal(i) * (height * (1 - r) * (1 - r)));
        }
        changed->seal();
        edit.blocks.push_back({number, changed, {}});
    });
    return {model.tree().apply(edit), model.definition()};
}

void ReuseTest::turnedViewCastsFewer_data() {
    QTest::addColumn<bool>("ring");
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("share"); // small pictures have long outlines
    QTest::newRow("sphere by 1 degree") << false << 1.0 << 0.4;
    QTest::newRow("sphere by 10 degrees") << false << 10.0 << 0.55;
    QTest::newRow("torus by 1 degree") << true << 1.0 << 0.4;
    QTest::newRow("torus by 10 degrees") << true << 10.0 << 0.55;
}

void ReuseTest::turnedViewCastsFewer() {
    QFETCH(bool, ring);
    QFETCH(double, degrees);
    QFETCH(double, share);
    const Surface& model = ring ? torus() : sphere();
    AdaptiveCast caster(model);
    once(caster, start(256), 1);
    const ImageRays next = around(degrees, 256);
    const Cast second = once(caster, next, 1);
    const std::size_t rays = fresh(model, next, 1).counts.rays;
    const auto d = difference(second.samples, full(model, next));
    QVERIFY2(d.share() >= 0.995 && d.falseHits == 0 && d.lost == 0, text(d, second.counts.rays, rays));
    QVERIFY2(static_cast<double>(second.counts.rays) <= share * static_cast<double>(rays),
             text(d, second.counts.rays, rays));
    QCOMPARE(second.counts.hits, d.hits);
}

void ReuseTest::errorsDoNotAddUpOverManyViews() {
    AdaptiveCast caster(torus());
    for (int step = 0; step <= test::effort(40); ++step) {
        const ImageRays view = around(9.0 * step, 120);
        const Cast cast = once(caster, view, 1);
        if (step % 8)
            continue;
        const auto d = difference(cast.samples, full(torus(), view));
        QVERIFY2(d.share() >= 0.98 && d.falseHits <= 1 && d.lost == 0, text(d, cast.counts.rays, 0));
    }
}

void ReuseTest::backAndForthCastsLittle() {
    AdaptiveCast caster(torus());
    const std::size_t first = once(caster, start(), 1).counts.rays;
    once(caster, around(5), 1);
    const Cast back = once(caster, start(), 1);
    const auto d = difference(back.samples, full(torus(), start()));
    QVERIFY2(d.share() >= 0.995 && back.counts.rays * 5 < first, text(d, back.counts.rays, first));
}

void ReuseTest::finerQualityDoesNotRestOnCoarser() {
    AdaptiveCast caster(torus());
    once(caster, start(), 4);
    for (const double quality : {4.0, 0.5}) {
        const Cast cast = once(caster, around(3), quality);
        const auto d = difference(cast.samples, full(torus(), around(3)), quality);
        QVERIFY2(d.share() >= 0.98, text(d, cast.counts.rays, 0));
    }
}

void ReuseTest::editCastsOnlyItsPart() {
    AdaptiveCast caster(sphere());
    const Cast before = once(caster, start(), 1);
    const base::Vec3f centre = base::cast<float>(start().eye / length(start().eye));
    const Surface edited = dabbed(sphere(), centre, 0.1f, 0.03f);
    caster.setSurface(edited);
    const Cast after = once(caster, start(), 1);
    const Cast anew = fresh(edited, start(), 1);
    const auto d = difference(after.samples, full(edited, start()));
    QVERIFY2(d.share() >= 0.995 && d.falseHits == 0 && d.lost == 0, text(d, after.counts.rays, anew.counts.rays));
    QVERIFY2(after.counts.rays > 0 && after.counts.rays * 4 < anew.counts.rays,
             text(d, after.counts.rays, anew.counts.rays));
    const auto boxes = editedRegion(sphere().tree(), edited.tree());
    const base::Box3f near = [&] {
        base::Box3f all;
        for (const base::Box3f& box : boxes)
            all.extend(box);
        return all.inflated(0.1f); // of a cell of 16 pixels that reaches into it
    }();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < before.samples.size(); ++i)
        if (const auto& hit = before.samples[i].hit; hit.hit && !near.contains(hit.position)) {
            QVERIFY(sameBits(before.samples[i], after.samples[i]));
            ++kept;
        }
    QVERIFY(kept * 2 > d.hits);
}

void ReuseTest::editIsSeenInAnotherView() {
    for (const bool castBetween : {false, true}) {
        AdaptiveCast caster(torus());
        once(caster, start(), 1);
        const Surface edited = dabbed(torus(), {0.5f, 0.5f, 0.3f}, 0.25f, 0.1f);
        caster.setSurface(edited);
        if (castBetween)
            once(caster, start(), 1);
        const Cast cast = once(caster, around(4), 1);
        const std::size_t rays = fresh(edited, around(4), 1).counts.rays;
        const auto d = difference(cast.samples, full(edited, around(4)));
        QVERIFY2(d.share() >= 0.99 && d.falseHits == 0 && d.lost == 0, text(d, cast.counts.rays, rays));
        QVERIFY2(cast.counts.rays * 3 < rays * 2, text(d, cast.counts.rays, rays));
    }
}

void ReuseTest::newSheetInFrontIsSeen() {
    AdaptiveCast caster(sphere());
    once(caster, start(), 1);
    // A small ball between the eye and the sphere.
    const Vec3d place = normalized(start().eye) * 1.6;
    tree::Edit edit;
    edit.inserted = shapes::sphere(600, 0.15, 3.5 * shapes::sphereSpacing(600, 0.15));
    for (surfel::Surfel& s : edit.inserted.items)
        s.position += base::cast<float>(place);
    const Surface edited{sphere().tree().apply(edit), sphere().definition()};
    caster.setSurface(edited);
    for (const double degrees : {0.0, 3.0}) {
        const ImageRays view = around(degrees);
        const Cast cast = once(caster, view, 1);
        const auto d = difference(cast.samples, full(edited, view));
        QVERIFY2(d.share() >= 0.99 && d.falseHits == 0 && d.lost == 0, text(d, cast.counts.rays, 0));
    }
}

void ReuseTest::sameContentCastsNothing() {
    AdaptiveCast caster(torus());
    const Cast before = once(caster, start(), 1);
    tree::Edit edit;
    edit.blocks.push_back({0, torus().tree().block(0)->clone(), {}});
    auto copy = torus().tree().block(0)->clone();
    copy->seal();
    edit.blocks[0].changed = copy;
    caster.setSurface({torus().tree().apply(edit), torus().definition()});
    const Cast after = once(caster, start(), 1);
    QCOMPARE(after.counts.rays, std::size_t(0));
    QVERIFY(same(before.samples, after.samples));
}

void ReuseTest::otherDefinitionForgets() {
    AdaptiveCast caster(torus());
    const std::size_t rays = once(caster, start(), 1).counts.rays;
    surface::SurfaceDefinition other = torus().definition();
    other.shrinkFree = false;
    caster.setSurface({torus().tree(), other});
    const Cast cast = once(caster, start(), 1);
    QVERIFY(cast.counts.rays * 2 > rays);
    QVERIFY(same(cast.samples, fresh({torus().tree(), other}, start(), 1).samples));
}

void ReuseTest::sameBitsAtAnyThreadCount() {
    const auto run = [](int threads) {
        base::setThreadCount(threads);
        AdaptiveCast caster(torus());
        once(caster, start(), 1);
        once(caster, around(4), 1);
        caster.setSurface(dabbed(torus(), {0.5f, 0.5f, 0.3f}, 0.2f, 0.05f));
        once(caster, around(4), 1);
        return once(caster, around(8), 1);
    };
    const Cast one = run(1), two = run(2);
    base::setThreadCount(0);
    QVERIFY(same(one.samples, two.samples) && one.known == two.known);
    QCOMPARE(one.counts.rays, two.counts.rays);
}

void ReuseTest::cancelledTurnGoesOn() {
    for (const int steps : {1, 2, 3, 4}) {
        AdaptiveCast caster(torus());
        once(caster, start(), 1);
        std::atomic<bool> stop{false};
        int left = steps;
        const base::Progress progress{[&](double, std::string_view) { stop = --left <= 0; }, &stop};
        CastCounts counts;
        QVERIFY_EXCEPTION_THROWN(caster.cast(around(5), {1}, counts, {}, progress), base::Cancelled);
        const Cast cast = once(caster, around(6), 1);
        const auto d = difference(cast.samples, full(torus(), around(6)));
        QVERIFY2(d.share() >= 0.99 && d.falseHits == 0 && d.lost == 0, text(d, cast.counts.rays, 0));
        QVERIFY(cast.counts.rays * 2 < fresh(torus(), around(6), 1).counts.rays);
    }
}

void ReuseTest::editedRegionHoldsEveryChange() {
    base::Random random(test::seed());
    const Surface edited = dabbed(torus(), {0.5f, 0.5f, 0.3f}, 0.3f, 0.1f);
    const auto boxes = editedRegion(torus().tree(), edited.tree());
    QVERIFY(!boxes.empty() && editedRegion(torus().tree(), torus().tree()).empty());
    int inside = 0;
    for (int i = 0; i < test::effort(4000); ++i) {
        const base::Vec3f x =
            base::cast<float>(Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.5, 0.5)});
        if (std::ranges::any_of(boxes, [&](const base::Box3f& box) { return box.contains(x); })) {
            ++inside;
            continue;
        }
        const auto a = torus().evaluate(x), b = edited.evaluate(x);
        QVERIFY2(a.status == b.status && (!a.ok() || (a.value == b.value && a.gradient == b.gradient)),
                 qPrintable(QString("seed %1").arg(test::seed())));
    }
    QVERIFY(inside > 0 && inside < test::effort(4000) / 4);
}

static const test::Registered<ReuseTest> registered;
#include "reuse_test.moc"
