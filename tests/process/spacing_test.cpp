#include "core/process/estimation/spacing.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/estimation/supports.h"
#include "core/process/samples/samples.h"
#include "support/registry.h"

#include <algorithm>
#include <numbers>
#include <QTest>

using namespace process;
using surface::SurfaceDefinition;
using surface::Weight;

class SpacingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void hexagonalSpacingIsTheRootOfAreaPerPoint();
    void agreesWithBruteForce();
    void duplicatesDoNotMatter();
    void fewPointsAndOutliersAreSane();
    void hexagonalSupportsHoldTheNeighboursAskedFor();
    void gaussianSupportsHaveTheSameSecondMoment();
    void oneRadiusForAll();
    void neighboursDifferByAtMostHalfTheirDistance();
    void gradingKeepsAtLeastHalf();
    void supportsDoNotLookThroughThinWalls();
    void sameBitsAtAnyThreadCount();
    void cancelStops();
    void sampledSpacingIsThatOfTheWhole();
    void fewSurfelsHaveNoSampledSpacing();
};

static surfel::SurfelList hexagonal(int n, float a) {
    surfel::SurfelList out;
    for (int row = -n; row <= n; ++row)
        for (int column = -n; column <= n; ++column) {
            surfel::Surfel s;
            s.position = {a * (static_cast<float>(column) + 0.5f * static_cast<float>(row & 1)),
                          a * 0.8660254f * static_cast<float>(row), 0.3f};
            out.items.push_back(s);
        }
    return out;
}

/// The point next to the middle of the layout.
static std::size_t middle(const surfel::SurfelList& list) {
    return list.size() / 2;
}

static surfel::SurfelList randomPoints(std::size_t n, std::uint64_t seed) {
    base::Random random(seed);
    surfel::SurfelList out;
    for (std::size_t i = 0; i < n; ++i) {
        surfel::Surfel s;
        const double dense = random.uniform();
        s.position = base::cast<float>(random.unitVector() * (dense * dense * dense));
        out.items.push_back(s);
    }
    return out;
}

void SpacingTest::hexagonalSpacingIsTheRootOfAreaPerPoint() {
    const float a = 0.037f;
    const auto list = hexagonal(12, a);
    const float s = spacings(list.items)[middle(list)];
    QVERIFY(std::abs(s / (0.93f * a) - 1) < 1e-5f);
    const float areaPerPoint = a * a * 0.8660254f;
    QVERIFY(std::abs(s / std::sqrt(areaPerPoint) - 1) < 1e-3f); // 0.93 for 0.930605
}

void SpacingTest::agreesWithBruteForce() {
    const auto list = randomPoints(700, test::seed());
    const auto s = spacings(list.items);
    for (std::size_t i = 0; i < list.size(); ++i) {
        std::vector<double> d;
        for (std::size_t j = 0; j < list.size(); ++j)
            if (j != i)
                d.push_back(base::distance(base::cast<double>(list.items[i].position),
                                           base::cast<double>(list.items[j].position)));
        std::sort(d.begin(), d.end());
        const double expected = 0.93 * (d[0] + d[1] + d[2] + d[3] + d[4] + d[5]) / 6;
        QVERIFY2(std::abs(static_cast<double>(s[i]) - expected) < 1e-5 * expected + 1e-7,
                 qPrintable(QString("point %1, seed %2").arg(i).arg(test::seed())));
    }
}

void SpacingTest::duplicatesDoNotMatter() {
    const auto list = randomPoints(2000, test::seed());
    auto doubled = list;
    base::Random random(test::seed() + 1);
    for (int k = 0; k < 5000; ++k)
        doubled.items.push_back(list.items[random.below(list.size())]);
    const auto a = spacings(list.items), b = spacings(doubled.items);
    QVERIFY(std::equal(a.begin(), a.end(), b.begin()));
    auto graded = list, gradedDoubled = doubled;
    assignSupports(graded, {});
    assignSupports(gradedDoubled, {});
    for (std::size_t i = 0; i < list.size(); ++i)
        QCOMPARE(gradedDoubled.items[i].support, graded.items[i].support);
}

void SpacingTest::fewPointsAndOutliersAreSane() {
    surfel::SurfelList list;
    assignSupports(list, {}); // nothing to do
    QVERIFY(spacings(list.items).empty());
    for (const base::Vec3f p : {base::Vec3f{1, 1, 1}, {1, 1, 1}, {1, 1, 2}, {4, 1, 1}}) {
        surfel::Surfel s;
        s.position = p;
        list.items.push_back(s);
        assignSupports(list, {});
        for (const auto& item : list.items)
            QVERIFY(item.support > 0 && std::isfinite(item.support));
    }
    auto sheet = hexagonal(20, 0.1f);
    surfel::Surfel far;
    far.position = {1e4f, 0, 0};
    sheet.items.push_back(far);
    assignSupports(sheet, {});
    for (const auto& item : sheet.items)
        QVERIFY2(item.support > 0.1f && item.support < 4, qPrintable(QString::number(item.support)));
    QVERIFY(std::abs(sheet.items[middle(sheet)].support - 0.093f * std::sqrt(38 / std::numbers::pi_v<float>)) < 1e-4f);
}

void SpacingTest::hexagonalSupportsHoldTheNeighboursAskedFor() {
    for (const int k : {19, 38, 60}) {
        auto list = hexagonal(30, 0.05f);
        SurfaceDefinition definition;
        definition.neighbours = k;
        assignSupports(list, definition);
        const auto& centre = list.items[middle(list)];
        const double s = 0.93 * 0.05;
        QVERIFY(std::abs(static_cast<double>(centre.support) - s * std::sqrt(k / std::numbers::pi)) < 1e-6);
        const auto inside = std::count_if(list.items.begin(), list.items.end(), [&](const auto& o) {
            return base::distance(o.position, centre.position) < centre.support;
        });
        QVERIFY2(std::abs(static_cast<double>(inside) - k) <= 0.2 * k, qPrintable(QString::number(inside)));
    }
}

void SpacingTest::gaussianSupportsHaveTheSameSecondMoment() {
    auto wendland = sample("torus").make(3000, 1), gaussian = wendland;
    SurfaceDefinition definition;
    assignSupports(wendland, definition);
    definition.weight = Weight::Gaussian;
    assignSupports(gaussian, definition);
    for (std::size_t i = 0; i < wendland.size(); ++i) {
        const double h = static_cast<double>(wendland.items[i].support);
        const double scale = static_cast<double>(surface::unitOf(Weight::Gaussian, gaussian.items[i].support));
        QVERIFY(std::abs(scale * scale / (5 * h * h / 36) - 1) < 1e-5); // mean squared distances in a plane
    }
}

void SpacingTest::oneRadiusForAll() {
    auto list = randomPoints(50, test::seed());
    SurfaceDefinition definition;
    definition.support = 0.25f;
    assignSupports(list, definition);
    for (const auto& s : list.items)
        QCOMPARE(s.support, 0.25f);
    definition.weight = Weight::Gaussian;
    assignSupports(list, definition);
    for (const auto& s : list.items)
        QCOMPARE(surface::unitOf(Weight::Gaussian, s.support), 0.25f);
}

/// But where that would make one hold too many.
void SpacingTest::neighboursDifferByAtMostHalfTheirDistance() {
    auto list = randomPoints(1500, test::seed());
    assignSupports(list, {});
    const auto held = [&](const surfel::Surfel& s) {
        return std::count_if(list.items.begin(), list.items.end(), [&](const surfel::Surfel& other) {
            return base::distance(other.position, s.position) < s.support;
        });
    };
    int cut = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto& a = list.items[i];
        std::vector<std::pair<float, std::size_t>> near;
        for (std::size_t j = 0; j < list.size(); ++j)
            if (j != i)
                near.emplace_back(base::distance(a.position, list.items[j].position), j);
        std::partial_sort(near.begin(), near.begin() + 8, near.end());
        for (std::size_t k = 0; k < 8; ++k) {
            const auto& b = list.items[near[k].second];
            if (std::abs(a.support - b.support) <= 0.50001f * near[k].first + 1e-6f)
                continue;
            ++cut;
            QVERIFY2(held(a.support < b.support ? a : b) > 5 * 38,
                     qPrintable(QString("point %1, seed %2").arg(i).arg(test::seed())));
        }
    }
    QVERIFY2(cut < 8 * 1500 / 2, qPrintable(QString("%1, seed %2").arg(cut).arg(test::seed())));
}

void SpacingTest::gradingKeepsAtLeastHalf() {
    // A sheet whose spacing jumps by 8: without cover at the jump the surface would tear there.
    auto list = hexagonal(30, 0.1f);
    const std::size_t coarse = list.size();
    for (auto fine : hexagonal(40, 0.0125f).items) {
        fine.position.x += 3.1f + 41 * 0.0125f;
        list.items.push_back(fine);
    }
    assignSupports(list, {});
    const auto s = spacings(list.items);
    for (std::size_t i = 0; i < coarse; ++i)
        QVERIFY(list.items[i].support >= 0.49f * std::min(s[i], 0.093f) * std::sqrt(38 / std::numbers::pi_v<float>));
}

void SpacingTest::supportsDoNotLookThroughThinWalls() {
    // Both sides of a plate of a tenth of the spacing, jittered, with oriented normals: each side has its own supports.
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    base::Random random(test::seed());
    surfel::SurfelList side = hexagonal(20, 0.1f), both;
    side.layout = both.layout = layout;
    for (auto& s : side.items) {
        s.position += base::cast<float>(random.unitVector() * 0.02);
        s.position.z = 0;
        s.normal = {0, 0, 1};
    }
    both.items = side.items;
    for (auto back : side.items) {
        back.position.z = -0.01f;
        back.normal = {0, 0, -1};
        both.items.push_back(back);
    }
    assignSupports(side, {});
    assignSupports(both, {});
    for (std::size_t i = 0; i < side.size(); ++i)
        QVERIFY2(std::abs(both.items[i].support / side.items[i].support - 1) < 0.01f,
                 qPrintable(QString("%1, seed %2").arg(i).arg(test::seed())));
}

void SpacingTest::sameBitsAtAnyThreadCount() {
    auto one = randomPoints(30000, test::seed()), two = one;
    base::setThreadCount(1);
    assignSupports(one, {});
    base::setThreadCount(0);
    assignSupports(two, {});
    QVERIFY(one.items == two.items);
}

void SpacingTest::cancelStops() {
    const auto list = randomPoints(30000, test::seed());
    const std::atomic<bool> cancel = true;
    QVERIFY_EXCEPTION_THROWN(spacings(list.items, base::Progress{{}, &cancel}), base::Cancelled);
}

void SpacingTest::sampledSpacingIsThatOfTheWhole() {
    auto list = sample("knot").make(20000, test::seed());
    assignSupports(list, {});
    const double whole = static_cast<double>(summarise(spacings(list.items)).median);
    const auto check = [&](const surfel::SurfelList& points) {
        const auto built = tree::SurfelTree::build(points);
        const double sampled = static_cast<double>(typicalSpacing(built));
        QVERIFY2(std::abs(sampled / whole - 1) < 0.03, qPrintable(QString::number(sampled / whole)));
        for (const SpacingSample& each : sampleSpacing(built))
            QVERIFY(each.support > each.spacing);
    };
    check(list);
    auto doubled = list;
    doubled.items.insert(doubled.items.end(), list.items.begin(), list.items.end());
    check(doubled);
}

void SpacingTest::fewSurfelsHaveNoSampledSpacing() {
    QCOMPARE(typicalSpacing({}), 0.0f);
    auto list = hexagonal(1, 0.1f); // 9
    assignSupports(list, {});
    QVERIFY(typicalSpacing(tree::SurfelTree::build(list)) > 0.09f);
    list.items.resize(6);
    QCOMPARE(typicalSpacing(tree::SurfelTree::build(list)), 0.0f);
}

static const test::Registered<SpacingTest> registered;
#include "spacing_test.moc"
