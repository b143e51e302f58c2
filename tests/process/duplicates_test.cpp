// Points at one place: what is merged, what is left alone, and by which measure.
#include "core/process/estimation/duplicates.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "core/process/samples/samples.h"
#include "support/registry.h"

#include <array>
#include <numeric>
#include <QTest>

using namespace process;
using base::Vec3d;
using base::Vec3f;

class DuplicatesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void copiesGoAndOriginalsStay_data();
    void copiesGoAndOriginalsStay();
    void aPileOfAnySizeIsOnePoint_data();
    void aPileOfAnySizeIsOnePoint();
    void whatIsNotDoubleStays_data();
    void whatIsNotDoubleStays();
    void aModelAmongStraysIsNoPile();
    void theFirstStaysWithAllItBrings();
    void pointsAtOnePlaceAloneAreRefused();
    void sameAtAnyThreadCount();
};

using Points = std::vector<Vec3f>;

static std::vector<surfel::Surfel> surfelsAt(const Points& points) {
    std::vector<surfel::Surfel> out(points.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i].position = points[i];
    return out;
}

static std::vector<std::uint32_t> firsts(const Points& points) {
    const Cloud cloud(surfelsAt(points));
    std::vector<std::uint32_t> out = firstOfDuplicates(cloud, neighboursOf(cloud, 0, {}));
    if (out.empty()) {
        out.resize(points.size());
        std::iota(out.begin(), out.end(), 0u);
    }
    return out;
}

static std::size_t mergedOf(const Points& points) {
    const auto first = firsts(points);
    std::size_t out = 0;
    for (std::uint32_t i = 0; i < first.size(); ++i)
        out += first[i] != i ? 1 : 0;
    return out;
}

static Points sampled(const char* id, std::size_t count) {
    Points out;
    for (const surfel::Surfel& s : sample(id).make(count, 1).items)
        out.push_back(s.position);
    return out;
}

/// A wavy sheet whose spacing grows evenly from `least` to 20 times that.
static Points unevenSheet(base::Random& random, double least) {
    Points out;
    double step = least;
    for (double x = 0; step < 20 * least; x += step, step *= 1.03)
        for (double y = 0; y < 40 * step; y += step) {
            const double u = x + 0.3 * step * random.uniform(-1, 1), v = y + 0.3 * step * random.uniform(-1, 1);
            out.push_back(base::cast<float>(Vec3d{u, v, 0.1 * std::sin(u) * std::sin(v)}));
        }
    return out;
}

static std::vector<float> nearestOthers(const Points& points) {
    const auto surfels = surfelsAt(points);
    const Cloud cloud(surfels);
    std::vector<float> out(points.size());
    Neighbours near;
    for (std::size_t i = 0; i < out.size(); ++i) {
        cloud.nearest(cloud.places()[i], 1, near);
        out[i] = std::sqrt(near.distanceSq[0]);
    }
    return out;
}

static Vec3f beside(base::Random& random, const Vec3f& p, float distance) {
    return base::cast<float>(base::cast<double>(p) + random.unitVector() * (double(distance) * random.uniform()));
}

void DuplicatesTest::copiesGoAndOriginalsStay_data() {
    QTest::addColumn<double>("reach");
    QTest::addColumn<double>("far");
    QTest::newRow("exact") << 0.0 << 0.0;
    QTest::newRow("a rounding apart") << 1e-4 << 0.0;
    QTest::newRow("exact, far from zero") << 0.0 << 1e4;
}

void DuplicatesTest::copiesGoAndOriginalsStay() {
    QFETCH(double, reach);
    QFETCH(double, far);
    base::Random random(test::seed());
    Points points = unevenSheet(random, 0.01);
    for (Vec3f& p : points)
        p += Vec3f{float(far), 0, float(far)};
    const std::size_t originals = points.size();
    const std::vector<float> gap = nearestOthers(points);
    for (std::uint32_t i = 0; i < originals; ++i)
        if (gap[i] > 0)
            for (std::size_t copies = random.below(5); copies > 0; --copies)
                points.push_back(beside(random, points[i], float(reach) * gap[i]));
    const auto first = firsts(points);
    std::size_t wrong = 0;
    for (std::uint32_t i = 0; i < points.size(); ++i) // of those at one place the one that stays is an original
        wrong += i < originals ? (first[i] != i && gap[i] > 0 ? 1 : 0) : first[i] < originals ? 0 : 1;
    QVERIFY2(wrong == 0, qPrintable(QString("%1 of %2, seed %3").arg(wrong).arg(points.size()).arg(test::seed())));
}

void DuplicatesTest::aPileOfAnySizeIsOnePoint_data() {
    QTest::addColumn<int>("size");
    QTest::addColumn<double>("part");
    for (const int size : {2, 3, 6, 7, 8, 12, 13, 40, 64, 65, 300, 3000})
        for (const double part : {0.0, 2e-4})
            QTest::addRow("%d %g", size, part) << size << part;
}

void DuplicatesTest::aPileOfAnySizeIsOnePoint() {
    QFETCH(int, size);
    QFETCH(double, part);
    base::Random random(test::seed());
    for (const char* id : {"sphere", "torus", "clay"}) {
        Points points = sampled(id, 6000);
        const std::vector<float> gap = nearestOthers(points);
        const std::size_t at = random.below(points.size());
        const Vec3f p = points[at];
        for (int k = 1; k < size; ++k)
            points.insert(points.begin() + static_cast<std::ptrdiff_t>(random.below(points.size())),
                          beside(random, p, float(part) * gap[at]));
        QVERIFY2(mergedOf(points) == std::size_t(size) - 1,
                 qPrintable(QString("%1: %2, seed %3").arg(id).arg(mergedOf(points)).arg(test::seed())));
    }
}

void DuplicatesTest::whatIsNotDoubleStays_data() {
    QTest::addColumn<QString>("model");
    for (const char* model : {"uneven", "noisy", "sheets", "random", "outliers", "grid", "line"})
        QTest::newRow(model) << model;
}

static Points modelOf(const QString& model, base::Random& random) {
    if (model == "uneven")
        return unevenSheet(random, 0.01);
    Points out = sampled("torus", 8000);
    if (model == "noisy")
        for (Vec3f& p : out)
            p = beside(random, p, 0.05f);
    if (model == "sheets") { // two, a fiftieth of the spacing apart
        const std::size_t n = out.size();
        for (std::size_t i = 0; i < n; ++i)
            out.push_back(out[i] * 1.0005f);
    }
    if (model == "outliers")
        for (int k = 0; k < 30; ++k)
            out.push_back(base::cast<float>(random.unitVector() * std::pow(10.0, random.uniform(1, 6))));
    if (model == "random")
        for (Vec3f& p : out)
            p = {float(random.uniform()), float(random.uniform()), float(random.uniform())};
    if (model == "grid")
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = {float(i % 20), float(i / 20 % 20), float(i / 400)};
    if (model == "line")
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = {float(i), 0, 0};
    return out;
}

void DuplicatesTest::whatIsNotDoubleStays() {
    QFETCH(QString, model);
    base::Random random(test::seed());
    Points points = modelOf(model, random);
    const std::size_t merged = mergedOf(points);
    // Points thrown at random do come that close, though hardly ever.
    QVERIFY2(merged <= (model == "random" || model == "noisy" ? 2u : 0u),
             qPrintable(QString("%1, seed %2").arg(merged).arg(test::seed())));
}

/// Seen from strays far away a whole model is one place; and so are several small ones among many strays.
void DuplicatesTest::aModelAmongStraysIsNoPile() {
    base::Random random(test::seed());
    for (const int models : {1, 2, 5})
        for (const int strays : {1, 6, 13, 40, 200}) {
            Points points;
            for (int k = 0; k < models; ++k) {
                const Vec3f at = base::cast<float>(random.unitVector() * (1e6 * random.uniform()));
                for (const Vec3f& p : sampled("sphere", 1000))
                    points.push_back(at + p * 10.0f);
            }
            for (int k = 0; k < strays; ++k)
                points.push_back(base::cast<float>(random.unitVector() * (1e6 * random.uniform())));
            std::size_t coincident = points.size();
            const auto surfels = surfelsAt(points);
            coincident -= Cloud(surfels).size();
            QVERIFY2(mergedOf(points) <= coincident + 2, // floats are coarse out there
                     qPrintable(QString("%1 models, %2 strays, seed %3").arg(models).arg(strays).arg(test::seed())));
        }
}

void DuplicatesTest::theFirstStaysWithAllItBrings() {
    surfel::SurfelList list;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = layout->colours = true;
    layout->add("number", surfel::ScalarType::UInt32);
    list.layout = layout;
    const auto ball = sample("sphere").make(500, 1);
    for (std::uint32_t i = 0; i < 500; ++i) {
        surfel::Surfel s = ball.items[i];
        s.colour = i;
        list.append(s, std::array{i});
    }
    const surfel::SurfelList before = list;
    for (std::uint32_t i = 0; i < 100; ++i) { // the same place, another colour; the normal turned, or the other way
        surfel::Surfel s = before.items[i];
        s.colour = 5000 + i;
        s.normal = i % 2 == 0 ? -s.normal : normalized(s.normal + Vec3f{0.3f, 0.1f, -0.2f});
        list.append(s, std::array{5000 + i});
    }
    std::size_t merged = 0;
    PrepareOptions options;
    options.merged = &merged;
    const surfel::SurfelList out = prepare(list, options).tree().surfels();
    QCOMPARE(merged, std::size_t(100));
    QCOMPARE(out.size(), before.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::uint32_t number = out.extraOf(i)[0];
        QVERIFY(number < 500 && out.items[i].colour == number);
        QVERIFY(out.items[i].position == before.items[number].position);
        if (number >= 100 || number % 2 == 0)
            QVERIFY(out.items[i].normal == before.items[number].normal);
        else
            QVERIFY(dot(out.items[i].normal, list.items[500 + number].normal) > 0.98f);
    }
}

void DuplicatesTest::pointsAtOnePlaceAloneAreRefused() {
    std::size_t merged = 0;
    PrepareOptions options;
    options.merged = &merged;
    surfel::SurfelList list;
    list.items.resize(20000);
    QVERIFY_EXCEPTION_THROWN(prepare(list, options), base::Error);
    const auto ball = sample("sphere").make(200, 1); // and now one in a hundred elsewhere
    std::copy(ball.items.begin(), ball.items.end(), list.items.begin() + 5000);
    for (surfel::Surfel& s : list.items)
        s.normal = {};
    QCOMPARE(prepare(list, options).tree().size(), std::size_t(201));
    QCOMPARE(merged, std::size_t(20000 - 201));
}

void DuplicatesTest::sameAtAnyThreadCount() {
    base::Random random(test::seed());
    Points points = unevenSheet(random, 0.01);
    const std::vector<float> gap = nearestOthers(points);
    for (int k = 0; k < 20000; ++k) {
        const std::size_t i = random.below(gap.size());
        points.push_back(beside(random, points[i], 0.002f * gap[i]));
    }
    base::setThreadCount(1);
    const auto one = firsts(points);
    base::setThreadCount(0);
    QVERIFY(firsts(points) == one);
}

static const test::Registered<DuplicatesTest> registered;
#include "duplicates_test.moc"
