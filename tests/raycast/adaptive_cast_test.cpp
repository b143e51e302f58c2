#include "core/raycast/adaptive_cast.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "raycast_models.h"
#include "support/registry.h"
#include "support/threads.h"

#include <atomic>
#include <QTest>

using namespace raycast;
using base::Vec3d;
using surface::Surface;
using namespace views;

class AdaptiveCastTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void smoothShapesNeedFewRays_data();
    void smoothShapesNeedFewRays();
    void planeIsNotSplitAgain();
    void anyCameraGetsItsQuality();
    void qualityZeroIsTheFullCast();
    void parallelRaysAndPlanesAsWell();
    void coloursFollowTheSurface();
    void levelsOnlyAdd();
    void coarserQualityCastsFewer();
    void staticViewCastsNothing();
    void sameBitsAtAnyThreadCount();
    void cancellingKeepsWhatWasCast();
    void emptyModelIsBackground();
};

namespace {

QByteArray text(const Difference& d, const CastCounts& counts) {
    return QString("%1 of %2 hits pass, %3 false, %4 lost, %5 rays for %6 pixels, seed %7")
        .arg(d.passed)
        .arg(d.hits)
        .arg(d.falseHits)
        .arg(d.lost)
        .arg(counts.rays)
        .arg(counts.pixels)
        .arg(test::seed())
        .toUtf8();
}

} // namespace

void AdaptiveCastTest::smoothShapesNeedFewRays_data() {
    QTest::addColumn<bool>("ring");
    QTest::addColumn<double>("pixelsPerRay");
    QTest::newRow("sphere") << false << 9.0;
    QTest::newRow("torus") << true << 4.5;
}

void AdaptiveCastTest::smoothShapesNeedFewRays() {
    // Outlines cost rays by their length, and count for more in small pictures: the scans have the full size.
    QFETCH(bool, ring);
    QFETCH(double, pixelsPerRay);
    const Surface& model = ring ? torus() : sphere();
    const ImageRays view = filling({}, 1.02, {0.3, 0.5, -1}, 256);
    const Cast cast = fresh(model, view, 1);
    const auto d = difference(cast.samples, full(model, view));
    QVERIFY2(d.share() >= 0.995 && d.falseHits == 0 && d.lost == 0, text(d, cast.counts));
    QCOMPARE(cast.counts.hits, d.hits);
    QCOMPARE(cast.counts.pixels, std::size_t(256 * 256));
    QVERIFY2(static_cast<double>(cast.counts.rays) * pixelsPerRay <= 256 * 256, text(d, cast.counts));
    QCOMPARE(std::ranges::count(cast.known, Known::Nothing), std::ptrdiff_t(0));
    // Beside the image rays are cast too, up to a start cell away.
    const auto exact = static_cast<std::size_t>(std::ranges::count(cast.known, Known::Exact));
    QVERIFY(exact <= cast.counts.rays && exact + 2 * 257 >= cast.counts.rays);
}

void AdaptiveCastTest::planeIsNotSplitAgain() {
    const Surface model = shapes::surfaceOf(shapes::plane(60, 0.05, 0.175));
    const Vec3d direction{0.4, -0.3, -1};
    const ImageRays view = filling({}, 1, direction, 128); // all of it plane
    const Cast cast = fresh(model, view, 0.25);
    const auto d = difference(cast.samples, full(model, view), 0.01);
    QVERIFY2(d.hits == 128 * 128 && d.passed == d.hits, text(d, cast.counts));
    // Spacing 3.2 pixels: start cells of 8, samples at every fourth pixel.
    QVERIFY2(cast.counts.rays == 33 * 33, text(d, cast.counts));
}

void AdaptiveCastTest::anyCameraGetsItsQuality() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(12); ++round) {
        const Surface& model = round % 2 ? torus() : sphere();
        const Vec3d centre = random.unitVector() * random.uniform(0, 0.6);
        const ImageRays view = filling(centre, random.uniform(0.3, 1.5), random.unitVector(),
                                       static_cast<int>(90 + random.below(60)), random.below(3) == 0);
        const double quality = random.uniform(0.5, 2);
        const Cast cast = fresh(model, view, quality);
        const auto d = difference(cast.samples, full(model, view), quality);
        QVERIFY2(d.share() >= 0.985 && d.falseHits == 0 && d.lost == 0, text(d, cast.counts));
    }
}

void AdaptiveCastTest::qualityZeroIsTheFullCast() {
    const ImageRays view = filling({}, 1.02, {0.3, 0.5, -1}, 90);
    AdaptiveCast caster(torus());
    once(caster, view, 2);
    const Cast cast = once(caster, view, 0);
    QVERIFY(same(cast.samples, full(torus(), view)));
    QCOMPARE(std::ranges::count(cast.known, Known::Exact), std::ptrdiff_t(90 * 90));
    QCOMPARE(cast.counts.rays, std::size_t(90 * 90));
    QVERIFY(same(fresh(torus(), view, 0).samples, cast.samples));
    QCOMPARE(once(caster, view, 0).counts.rays, std::size_t(0));
}

void AdaptiveCastTest::parallelRaysAndPlanesAsWell() {
    const base::Plane planes[] = {{normalized(Vec3d{1, 0.2, 0.1}), -0.3}, {normalized(Vec3d{0, -1, 0.3}), -0.4}};
    for (const bool parallel : {false, true}) {
        ImageRays view = filling({}, 1.02, {0.3, 0.5, -1}, 200, parallel);
        view.clips = planes;
        const Cast cast = fresh(torus(), view, 1);
        const auto d = difference(cast.samples, full(torus(), view));
        QVERIFY2(d.share() >= 0.99 && d.falseHits == 0 && d.lost == 0, text(d, cast.counts));
        QVERIFY2(cast.counts.rays * 3 < cast.counts.pixels, text(d, cast.counts));
        for (const Sample& sample : cast.samples)
            for (const base::Plane& plane : planes)
                QVERIFY(!sample.hit.hit || plane.distance(base::cast<double>(sample.hit.position)) > -1e-3);
    }
}

void AdaptiveCastTest::coloursFollowTheSurface() {
    surfel::SurfelList list = shapes::sphere(8000, sphereRadius, 3.5 * shapes::sphereSpacing(8000, sphereRadius));
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->colours = layout->masks = true;
    list.layout = layout;
    for (surfel::Surfel& s : list.items) {
        const auto stripe = static_cast<unsigned>(127.5f + 120 * std::sin(8 * s.position.x));
        s.colour = surfel::rgba(stripe, 40, 255 - stripe);
        s.mask = 0.5f + 0.5f * std::sin(5 * s.position.y);
    }
    const Surface model = shapes::surfaceOf(list);
    const ImageRays view = filling({}, 1.02, {0.3, 0.5, -1}, 200);
    const Cast cast = fresh(model, view, 1);
    const auto exact = full(model, view);
    std::size_t off = 0, hits = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        if (!exact[i].hit.hit)
            continue;
        ++hits;
        bool near = std::abs(exact[i].mask - cast.samples[i].mask) <= 8 / 255.0f;
        for (int k = 0; k < 3; ++k) {
            const auto byte = [k](surfel::Colour c) { return static_cast<int>(c >> (8 * k) & 255u); };
            near = near && std::abs(byte(exact[i].colour) - byte(cast.samples[i].colour)) <= 8;
        }
        off += near ? 0 : 1;
    }
    QVERIFY2(off * 200 <= hits, text({hits, hits - off}, cast.counts));
    QVERIFY(cast.counts.rays * 3 < cast.counts.pixels);
}

void AdaptiveCastTest::levelsOnlyAdd() {
    const ImageRays view = filling({}, 1.02, {0.3, 0.5, -1}, 200);
    AdaptiveCast caster(torus());
    std::vector<double> qualities;
    std::vector<std::size_t> unknown;
    std::vector<Known> before;
    CastCounts counts;
    const auto shown = [&](const AdaptiveImage& image) {
        qualities.push_back(image.quality);
        unknown.push_back(static_cast<std::size_t>(std::ranges::count(image.known, Known::Nothing)));
        QCOMPARE(image.complete, unknown.back() == 0);
        for (std::size_t i = 0; i < before.size(); ++i)
            QVERIFY(before[i] != Known::Exact || image.known[i] == Known::Exact);
        before.assign(image.known.begin(), image.known.end());
    };
    const AdaptiveImage image = caster.cast(view, {1}, counts, shown);
    QVERIFY((qualities == std::vector<double>{4, 4, 2, 1}));
    QVERIFY(unknown[0] > 0 && unknown[0] < 200 * 200 / 2);
    const Cast direct = fresh(torus(), view, 1);
    QVERIFY(same(image.samples, direct.samples));
    QCOMPARE(counts.rays, direct.counts.rays);
}

void AdaptiveCastTest::coarserQualityCastsFewer() {
    const ImageRays view = filling({}, 1.02, {0.3, 0.5, -1}, 256);
    std::size_t before = 256 * 256;
    for (const double quality : {0.25, 1.0, 4.0}) {
        const std::size_t rays = fresh(torus(), view, quality).counts.rays;
        QVERIFY(rays < before);
        before = rays;
    }
}

void AdaptiveCastTest::staticViewCastsNothing() {
    const ImageRays view = filling({}, 1.02, {0.3, 0.5, -1}, 160);
    AdaptiveCast caster(torus());
    const Cast first = once(caster, view, 1), second = once(caster, view, 1), coarser = once(caster, view, 2);
    QVERIFY(first.counts.rays > 0);
    QCOMPARE(second.counts.rays + coarser.counts.rays, std::size_t(0));
    QVERIFY(same(first.samples, second.samples) && same(first.samples, coarser.samples));
    caster.setSurface(torus());
    QCOMPARE(once(caster, view, 1).counts.rays, std::size_t(0));
}

void AdaptiveCastTest::sameBitsAtAnyThreadCount() {
    const ImageRays view = filling({}, 1.02, {0.3, 0.5, -1}, 200);
    const auto work = [&] { return fresh(torus(), view, 1); };
    const Cast one = test::onThreads(1, work), two = test::onThreads(2, work);
    QVERIFY(same(one.samples, two.samples) && one.known == two.known);
    QCOMPARE(one.counts.rays, two.counts.rays);
}

void AdaptiveCastTest::cancellingKeepsWhatWasCast() {
    const ImageRays view = filling({}, 1.02, {0.3, 0.5, -1}, 200);
    const Cast whole = fresh(torus(), view, 1);
    for (const int steps : {1, 2, 3, 4}) {
        AdaptiveCast caster(torus());
        std::atomic<bool> stop{false};
        int left = steps;
        const base::Progress progress{[&](double, std::string_view) { stop = --left <= 0; }, &stop};
        CastCounts counts, more;
        QVERIFY_EXCEPTION_THROWN(caster.cast(view, {1}, counts, {}, progress), base::Cancelled);
        const AdaptiveImage image = caster.cast(view, {1}, more);
        QVERIFY(same(image.samples, whole.samples));
        QCOMPARE(counts.rays + more.rays, whole.counts.rays);
    }
}

void AdaptiveCastTest::emptyModelIsBackground() {
    const Cast cast = fresh(Surface{}, filling({}, 1, {0, 0, -1}, 64), 1);
    QCOMPARE(cast.counts.rays + cast.counts.hits, std::size_t(0));
    QCOMPARE(std::ranges::count(cast.known, Known::Nothing), std::ptrdiff_t(0));
}

static const test::Registered<AdaptiveCastTest> registered;
#include "adaptive_cast_test.moc"
