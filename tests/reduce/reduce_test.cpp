// Reduced sets: exact shapes, what comes along, boundaries, walls, densities, requests, and what is refused.
#include "core/reduce/reduce.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/process/samples/samples.h"
#include "core/reduce/coverage.h"
#include "core/reduce/watch.h"
#include "reduce/reduced_models.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/thread_counts.h"

#include <QTest>

using namespace reduce;
using test::Shape;
using test::Vec3d;
using test::Vec3f;

class ReduceTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void exactShapesKeepTheirSurface_data();
    void exactShapesKeepTheirSurface();
    void aReducedSetBeatsThinningFiveTimes();
    void theReportIsWhatBruteForceMeasures();
    void countsAreExact();
    void anyNumberFromFewToNearlyAllIsASurface();
    void openSurfacesEndWhereTheyDid();
    void thinWallsStayApart();
    void densitiesMayDiffer();
    void straysDoNotReachTheModel();
    void errorIsKeptByTheLeastCount();
    void attributesComeAlong();
    void sidelessSurfacesAreReduced();
    void sameBitsAtAnyThreadCount();
    void whoLooksOnSeesTheSamplesSpread();
    void cancellingStops();
    void whatCannotBeReducedIsRefused();
};

namespace {

std::string hashOf(const surface::Surface& surface) {
    return surface.tree().contentHash().text();
}

QByteArray told(const Report& r) {
    return (summaryOf(r) + "; surf rms " + std::to_string(r.surfaceRms) + ", normals " + std::to_string(r.normalsDeg) +
            ", least supports " + std::to_string(r.leastSupports))
        .c_str();
}

std::string refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const base::Error& error) {
        return error.message();
    }
    return {};
}

} // namespace

void ReduceTest::exactShapesKeepTheirSurface_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<double>("most"); // rms distance to the exact shape, in the model's spacings
    QTest::newRow("plane") << 0 << 1e-4;
    QTest::newRow("sphere") << 1 << 0.01;
    QTest::newRow("torus") << 2 << 0.03;
}

void ReduceTest::exactShapesKeepTheirSurface() {
    QFETCH(int, which);
    QFETCH(double, most);
    const int count = test::effort(10000);
    const Shape shape = which == 0   ? test::plane(int(std::sqrt(count)))
                        : which == 1 ? test::sphere(std::size_t(count))
                                     : test::torus(std::size_t(count));
    const Reduced result = reduceToCount(shape.surface, std::size_t(count / 10));
    result.surface.tree().validate();
    const test::Errors errors = test::errorsOf(result.surface, shape, test::positionsOf(shape.surface));
    const QByteArray all = told(result.report) + QString("; exact rms %1 s, max %2 s, lost %3")
                                                     .arg(errors.rms / shape.spacing)
                                                     .arg(errors.max / shape.spacing)
                                                     .arg(errors.lost)
                                                     .toUtf8();
    qInfo("%s", all.constData());
    QVERIFY2(errors.rms < most * shape.spacing, all);
    QVERIFY2(errors.max < 12 * most * shape.spacing, all);
    QVERIFY2(result.report.holes == 0 && result.report.leastSupports >= 3, all);
}

void ReduceTest::aReducedSetBeatsThinningFiveTimes() {
    const std::size_t count = std::size_t(test::effort(10000));
    for (const Shape& shape : {test::sphere(count), test::torus(count)}) {
        const Reduced result = reduceToCount(shape.surface, count / 10);
        const std::vector<base::Vec3f> places = test::positionsOf(shape.surface);
        const double reduced = test::errorsOf(result.surface, shape, places).rms;
        const double thinned = test::errorsOf(test::thinned(shape.surface, count / 10), shape, places).rms;
        QVERIFY2(5 * reduced < thinned, qPrintable(QString("%1 against %2").arg(reduced).arg(thinned)));
    }
}

void ReduceTest::theReportIsWhatBruteForceMeasures() {
    const Shape shape = test::torus(1500);
    const Reduced result = reduceToCount(shape.surface, 300);
    double sum = 0, max = 0;
    int least = 1000;
    const std::vector<base::Vec3f> places = test::positionsOf(shape.surface);
    for (const base::Vec3f& p : places) {
        const auto foot = surface::projectReference(result.surface, base::cast<double>(p));
        QVERIFY(foot.ok());
        const double d = distance(foot.foot, base::cast<double>(p));
        sum += d * d, max = std::max(max, d);
        least = std::min(least, foot.at.samples);
    }
    const double rms = std::sqrt(sum / double(places.size()));
    QVERIFY(std::abs(rms - result.report.rms) < 0.01 * rms);
    QVERIFY(std::abs(max - result.report.max) < 0.01 * max);
    QVERIFY(result.report.p999 <= result.report.max && result.report.rms < result.report.p999);
    QVERIFY(result.report.leastSupports <= least);
    QCOMPARE(result.report.count, std::size_t(300));
    QCOMPARE(result.surface.tree().size(), std::size_t(300));
}

void ReduceTest::countsAreExact() {
    base::Random random(test::seed());
    const Shape shape = test::torus(2000);
    for (int k = 0; k < test::effort(6); ++k) {
        const std::size_t count = 8 + random.below(1990);
        QVERIFY2(reduceToCount(shape.surface, count).surface.tree().size() == count,
                 qPrintable(QString("seed %1: %2").arg(test::seed()).arg(count)));
    }
    QCOMPARE(reduceByRatio(shape.surface, 0.1).surface.tree().size(), std::size_t(200));
}

void ReduceTest::anyNumberFromFewToNearlyAllIsASurface() {
    const Shape shape = test::sphere(600);
    double before = 1;
    for (const std::size_t count : {12u, 40u, 120u, 400u, 590u}) {
        const Reduced result = reduceToCount(shape.surface, count);
        QVERIFY2(result.report.holes == 0, told(result.report));
        QVERIFY2(result.report.rms < before, told(result.report));
        before = result.report.rms * 1.5 + 1e-4;
    }
    QCOMPARE(reduceToCount(test::sphere(10).surface, 9).surface.tree().size(), std::size_t(9));
}

void ReduceTest::openSurfacesEndWhereTheyDid() {
    const Shape shape = test::halfSphere(std::size_t(test::effort(6000)));
    QVERIFY(std::isfinite(shape.surface.definition().boundaryLimit));
    const Reduced result = reduceByRatio(shape.surface, 0.1);
    QVERIFY2(result.report.holes == 0, told(result.report));
    const double reducedSpacing = shape.spacing * std::sqrt(10.0);
    QVERIFY(std::isfinite(result.surface.definition().boundaryLimit));
    // Beyond the rim by less than a reduced spacing, nothing.
    for (int k = 0; k < 200; ++k) {
        const double a = 2 * std::numbers::pi * k / 200, down = 0.8 * reducedSpacing;
        const base::Vec3d x{std::cos(down) * std::cos(a), std::cos(down) * std::sin(a), -std::sin(down)};
        surface::ProjectOptions options;
        const auto foot = surface::project(result.surface, base::cast<float>(x), options);
        const bool there = foot.ok() && double(foot.foot.z) < -0.7 * reducedSpacing;
        QVERIFY2(!there, qPrintable(QString("%1: %2").arg(a).arg(double(foot.foot.z) / reducedSpacing)));
    }
}

void ReduceTest::thinWallsStayApart() {
    const Shape shape = test::plate(test::effort(60), 1.5);
    const Reduced result = reduceByRatio(shape.surface, 0.1);
    // As many holes as a handful at the rims; both sheets where they were.
    QVERIFY2(double(result.report.holes) < 0.002 * double(shape.surface.tree().size()), told(result.report));
    const test::Errors errors = test::errorsOf(result.surface, shape, test::positionsOf(shape.surface));
    QVERIFY2(errors.rms < 0.05 * shape.spacing,
             told(result.report) + QByteArray::number(errors.rms / shape.spacing) + " s");
}

/// A sphere whose spacing grows from one pole to the other by 20.
static Shape unevenSphere(std::size_t count) {
    base::Random random(7);
    std::vector<std::pair<Vec3d, Vec3d>> points;
    while (points.size() < count) {
        const Vec3d d = random.unitVector();
        const double part = std::pow(20.0, -(d.z + 1)); // of the densest, in area: 1 : 400
        if (random.uniform() < part)
            points.push_back({d, d});
    }
    Shape out = test::sphere(100);
    out.surface = test::prepared(points);
    return out;
}

void ReduceTest::densitiesMayDiffer() {
    const Shape shape = unevenSphere(std::size_t(test::effort(10000)));
    const Reduced result = reduceByRatio(shape.surface, 0.1);
    QVERIFY2(double(result.report.holes) <= 0.0005 * double(shape.surface.tree().size()), told(result.report));
    QVERIFY2(result.report.surfaceRms < 0.01, told(result.report));
}

void ReduceTest::straysDoNotReachTheModel() {
    base::Random random(test::seed());
    const std::size_t count = std::size_t(test::effort(5000));
    std::vector<std::pair<Vec3d, Vec3d>> points;
    for (const Vec3d& d : test::shakenDirections(count, 0.3, random))
        points.push_back({d, d});
    for (std::size_t k = 0; k < count / 100; ++k) // single ones, and little groups
        for (std::size_t j = 0; j < 1 + k % 4; ++j)
            points.push_back({random.unitVector() * random.uniform(1.5, 3), random.unitVector()});
    const Shape clean = test::sphere(count);
    const Reduced result = reduceByRatio(test::prepared(points), 0.1);
    std::vector<Vec3f> places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back(base::cast<float>(points[i].first));
    const test::Errors errors = test::errorsOf(result.surface, clean, places);
    const QByteArray all =
        told(result.report) + QByteArray::number(errors.rms) + ", lost " + QByteArray::number(errors.lost);
    QVERIFY2(errors.lost == 0 && errors.rms < 0.1 * clean.spacing, all);
}

void ReduceTest::errorIsKeptByTheLeastCount() {
    if (test::sanitized)
        QSKIP("seconds under a sanitizer");
    const Shape shape = test::torus(3000);
    const double error = reduceToCount(shape.surface, 400).report.rms;
    const Reduced found = reduceToError(shape.surface, error);
    QVERIFY2(found.report.rms <= error, told(found.report));
    QVERIFY2(found.report.count <= 440, told(found.report));
    const Reduced fewer = reduceToCount(shape.surface, found.report.count * 3 / 4);
    QVERIFY2(fewer.report.rms > error, told(fewer.report));
    QVERIFY(!refusal([&] { reduceToError(shape.surface, 1e-12); }).empty());
}

void ReduceTest::attributesComeAlong() {
    const Shape shape = test::sphere(4000);
    surfel::SurfelList list = shape.surface.tree().surfels();
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->colours = layout->masks = true;
    layout->add("label", surfel::ScalarType::Int32);
    layout->add("height", surfel::ScalarType::Float32);
    list.layout = layout;
    for (surfel::Surfel& s : list.items) {
        const bool up = s.position.z > 0;
        s.colour = up ? surfel::rgba(200, 100, 0) : surfel::rgba(0, 100, 200);
        s.mask = up ? 1.0f : 0.0f;
        list.extra.insert(list.extra.end(), layout->words(), 0);
        const std::span words = std::span(list.extra).last(layout->words());
        surfel::write(layout->attributes()[0], words, up ? 7 : 3);
        surfel::write(layout->attributes()[1], words, double(s.position.z));
    }
    const Reduced result = reduceByRatio({tree::SurfelTree::build(list), shape.surface.definition()}, 0.1);
    const surfel::SurfelList out = result.surface.tree().surfels();
    QVERIFY(*out.layout == *layout);
    const float far = 0.3f;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const surfel::Surfel& s = out.items[i];
        const double label = surfel::read(layout->attributes()[0], out.extraOf(i));
        QVERIFY(label == 7 || label == 3);
        QVERIFY(std::abs(surfel::read(layout->attributes()[1], out.extraOf(i)) - double(s.position.z)) < 0.05);
        if (std::abs(s.position.z) < far)
            continue;
        QCOMPARE(label, s.position.z > 0 ? 7.0 : 3.0);
        QCOMPARE(s.colour, s.position.z > 0 ? surfel::rgba(200, 100, 0) : surfel::rgba(0, 100, 200));
        QCOMPARE(s.mask, s.position.z > 0 ? 1.0f : 0.0f);
    }
}

void ReduceTest::sidelessSurfacesAreReduced() {
    const surface::Surface strip = process::prepare(process::sample("moebius").make(4000, 1), {});
    QVERIFY(!strip.tree().layout()->oriented);
    const Reduced result = reduceByRatio(strip, 0.15);
    QVERIFY(!result.surface.tree().layout()->oriented);
    QVERIFY2(result.report.holes == 0 && result.report.surfaceRms < 0.2 * result.report.max + 1e-3,
             told(result.report));
}

void ReduceTest::sameBitsAtAnyThreadCount() {
    const Shape shape = test::torus(std::size_t(test::effort(5000)));
    const int threads = base::threadCount();
    std::vector<std::string> hashes;
    for (const int n : test::comparedThreads(test::sanitized ? std::vector{5} : std::vector{2, 5})) {
        base::setThreadCount(n);
        hashes.push_back(hashOf(reduceByRatio(shape.surface, 0.1).surface));
    }
    base::setThreadCount(threads);
    for (const std::string& each : hashes)
        QCOMPARE(each, hashes[0]);
}

/// All of them after every round, each on the surface and with less and less of a way to go; the result is the same.
void ReduceTest::whoLooksOnSeesTheSamplesSpread() {
    const Shape shape = test::sphere(2000);
    const std::string unseen = hashOf(reduceToCount(shape.surface, 200, Shapes::Spheres).surface);
    std::vector<std::vector<Vec3f>> seen;
    std::string watched;
    {
        const WatchScope scope([&](const Sites& floaters) {
            seen.push_back(floaters.position);
            QCOMPARE(floaters.normal.size(), floaters.size());
            QCOMPARE(floaters.spacing.size(), floaters.size());
        });
        watched = hashOf(reduceToCount(shape.surface, 200, Shapes::Spheres).surface);
    }
    QCOMPARE(watched, unseen);
    QVERIFY(seen.size() >= 10);
    for (const auto& floaters : seen) {
        QCOMPARE(floaters.size(), std::size_t(200));
        for (const Vec3f& p : floaters)
            QVERIFY(std::abs(length(p) - 1) < 0.02f);
    }
    const auto way = [](const std::vector<Vec3f>& from, const std::vector<Vec3f>& to) {
        double sum = 0;
        for (std::size_t i = 0; i < from.size(); ++i)
            sum += double(distance(from[i], to[i]));
        return sum;
    };
    QVERIFY(way(seen[8], seen[9]) < 0.5 * way(seen[0], seen[1]));
    const std::size_t told = seen.size();
    reduceToCount(shape.surface, 200, Shapes::Spheres); // nobody looks on any more
    QCOMPARE(seen.size(), told);
}

void ReduceTest::cancellingStops() {
    const Shape shape = test::torus(3000);
    // After any number of reports: each stage throws.
    for (int after = 0; after < 40; after += test::sanitized ? 9 : 3) {
        std::atomic<bool> cancel = false;
        int reports = 0;
        base::Progress progress;
        progress.cancel = &cancel;
        progress.report = [&](double, std::string_view) { cancel = ++reports > after; };
        try {
            reduceByRatio(shape.surface, 0.1, Shapes::Auto, progress);
            QVERIFY(after > 5);
        } catch (const base::Cancelled&) {
        }
    }
}

void ReduceTest::whatCannotBeReducedIsRefused() {
    const Shape shape = test::sphere(200);
    QVERIFY(refusal([&] { reduceToCount(shape.surface, 200); }).find("200") != std::string::npos);
    QVERIFY(!refusal([&] { reduceToCount(shape.surface, 3); }).empty());
    QVERIFY(!refusal([&] { reduceByRatio(shape.surface, 1); }).empty());
    QVERIFY(!refusal([&] { reduceByRatio(test::sphere(6).surface, 0.5); }).empty());
    surface::SurfaceDefinition definition;
    definition.manifold = surface::Manifold::Curve;
    QVERIFY(refusal([&] { reduceToCount({shape.surface.tree(), definition}, 50); }).find("curve") != std::string::npos);
}

static const test::Registered<ReduceTest> registered;
#include "reduce_test.moc"
