// Neighbours, to the bit, against the distances to all others.
#include "core/process/neighbours/knn.h"

#include "core/base/random.h"
#include "core/process/neighbours/cloud_neighbours.h"
#include "core/process/neighbours/curve_order.h"
#include "support/registry.h"

#include <algorithm>
#include <cstring>
#include <QTest>

using namespace process;
using base::Vec3d;
using base::Vec3f;

namespace {

using Points = std::vector<Vec3f>;

Vec3d inCube(base::Random& random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

Points made(std::size_t n, const auto& at) {
    Points out;
    for (std::size_t i = 0; i < n; ++i)
        out.push_back(base::cast<float>(Vec3d(at(i))));
    return out;
}

/// Clouds of all kinds; `n` is about how many points they have.
const std::vector<std::pair<const char*, std::function<Points(base::Random&, std::size_t)>>> kinds = {
    {"volume", [](auto& r, auto n) { return made(n, [&](auto) { return inCube(r); }); }},
    {"sphere", [](auto& r, auto n) { return made(n, [&](auto) { return r.unitVector(); }); }},
    {"dense middle",
     [](auto& r, auto n) { return made(n, [&](auto) { return r.unitVector() * std::pow(r.uniform(), 6); }); }},
    {"sheets of 1 to 1000",
     [](auto& r, auto n) {
         return made(n, [&](auto i) {
             const Vec3d p{r.uniform(), r.uniform(), 0};
             return i % 10 == 0 ? p * 1000.0 : p;
         });
     }},
    {"dense among strays",
     [](auto& r, auto n) { return made(n, [&](auto i) { return inCube(r) * (i % 50 == 0 ? 1000.0 : 1e-3); }); }},
    {"lattice",
     [](auto&, auto n) {
         const auto side = std::max<std::size_t>(2, static_cast<std::size_t>(std::cbrt(static_cast<double>(n))));
         return made(side * side * side, [&](auto i) {
             return Vec3d{double(i % side), double(i / side % side), double(i / side / side)};
         });
     }},
    {"plane lattice",
     [](auto&, auto n) {
         const auto side = std::max<std::size_t>(2, static_cast<std::size_t>(std::sqrt(static_cast<double>(n))));
         return made(side * side, [&](auto i) { return Vec3d{double(i % side), double(i / side), 3}; });
     }},
    {"line", [](auto&, auto n) { return made(n, [](auto i) {
                                     return Vec3d{double(i), 2.0 * double(i), 0};
                                 }); }},
    {"coincident",
     [](auto& r, auto n) {
         Points out = made(n / 4 + 2, [&](auto) { return inCube(r); });
         for (std::size_t i = 0; i < n; ++i)
             out.push_back(out[i % 7 == 0 ? 0 : r.below(out.size())]);
         return out;
     }},
    {"far away",
     [](auto& r, auto n) { return made(n, [&](auto) {
                               return inCube(r) * 50.0 + Vec3d{1e7, -1e7, 3e6};
                           }); }},
    {"piles",
     [](auto& r, auto n) {
         return made(n, [&](auto i) { return i % 3 ? inCube(r) * 1e-6 + Vec3d{0.5, 0.25, 0} : inCube(r); });
     }},
    {"squares that vanish", [](auto& r, auto n) { return made(n, [&](auto) { return inCube(r) * 1e-22; }); }},
    {"least floats", [](auto& r, auto n) { return made(n, [&](auto) { return inCube(r) * 1e-43; }); }},
    {"squares beyond numbers", [](auto& r, auto n) { return made(n, [&](auto) { return inCube(r) * 1e19; }); }},
    {"one at equal distance from all",
     [](auto&, auto n) {
         return made(n, [&](auto i) {
             const double angle = double(i) * 1e-2;
             return i == 0 ? Vec3d{} : Vec3d{std::cos(angle), std::sin(angle), double(i % 2)};
         });
     }},
};

std::vector<surfel::Surfel> surfelsAt(const Points& points) {
    std::vector<surfel::Surfel> out(points.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i].position = points[i];
    return out;
}

struct Near {
    float distanceSq;
    std::uint32_t index;
    auto operator<=>(const Near&) const = default;
};

std::vector<Near> bruteForce(std::span<const Vec3f> positions, std::size_t i, std::size_t k) {
    std::vector<Near> out;
    for (std::uint32_t j = 0; j < positions.size(); ++j)
        if (j != i)
            out.push_back({base::distanceSq(positions[i], positions[j]), j});
    k = std::min(k, out.size());
    std::partial_sort(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(k), out.end());
    out.resize(k);
    return out;
}

bool same(const std::vector<Near>& expected, const Neighbours& found) {
    if (expected.size() != found.size() || found.distanceSq.size() != found.index.size())
        return false;
    for (std::size_t k = 0; k < expected.size(); ++k)
        if (!(expected[k] == Near{found.distanceSq[k], found.index[k]}))
            return false;
    return true;
}

template <class Item>
bool sameBytes(std::span<const Item> a, std::span<const Item> b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

} // namespace

class KnnTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void neighboursAreThoseOfBruteForce_data();
    void neighboursAreThoseOfBruteForce();
    void positionsAreDistinctAndPointsKeepTheirs_data();
    void positionsAreDistinctAndPointsKeepTheirs();
    void fewPositionsHaveFewNeighbours();
    void reachFromAnywhere();
    void cancelStops();
    void tablesKeepRows();
    void pointsArePutInOrderOnceWithWhatTheyCarry();
    void neighboursOfWhatStaysAreThoseOfASearch_data();
    void neighboursOfWhatStaysAreThoseOfASearch();
};

void KnnTest::neighboursAreThoseOfBruteForce_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("count");
    for (int kind = 0; kind < static_cast<int>(kinds.size()); ++kind)
        for (const int count : {9, 150, test::effort(3000)})
            QTest::addRow("%s %d", kinds[static_cast<std::size_t>(kind)].first, count) << kind << count;
}

void KnnTest::neighboursAreThoseOfBruteForce() {
    QFETCH(int, kind);
    QFETCH(int, count);
    base::Random random(test::seed());
    const Points points = kinds[static_cast<std::size_t>(kind)].second(random, static_cast<std::size_t>(count));
    const Cloud cloud(surfelsAt(points));
    const std::size_t stride = std::max<std::size_t>(1, cloud.size() / 400);
    for (const std::size_t k : {1u, 6u, 12u, 18u, 24u, 100u}) {
        std::vector<std::uint8_t> right(cloud.size(), 2), asked(cloud.size(), 0);
        cloud.forEach(k, {}, "", [&](std::size_t i, const Neighbours& found) {
            asked[i] = 1;
            if (i % stride == 0)
                right[i] = same(bruteForce(cloud.positions(), i, k), found);
        });
        QVERIFY(std::count(asked.begin(), asked.end(), 1) == static_cast<std::ptrdiff_t>(asked.size()));
        const auto wrong = std::find(right.begin(), right.end(), 0);
        QVERIFY2(wrong == right.end(), qPrintable(QString("%1 of %2, k %3, seed %4")
                                                      .arg(wrong - right.begin())
                                                      .arg(cloud.size())
                                                      .arg(k)
                                                      .arg(test::seed())));
        Neighbours alone;
        for (std::size_t i = 0; i < cloud.size(); i += 5 * stride) {
            cloud.nearest(i, k, alone);
            QVERIFY2(same(bruteForce(cloud.positions(), i, k), alone),
                     qPrintable(QString("%1 alone, k %2, seed %3").arg(i).arg(k).arg(test::seed())));
        }
    }
}

void KnnTest::positionsAreDistinctAndPointsKeepTheirs_data() {
    QTest::addColumn<int>("kind");
    for (int kind = 0; kind < static_cast<int>(kinds.size()); ++kind)
        QTest::addRow("%s", kinds[static_cast<std::size_t>(kind)].first) << kind;
}

void KnnTest::positionsAreDistinctAndPointsKeepTheirs() {
    QFETCH(int, kind);
    base::Random random(test::seed());
    const Points points = kinds[static_cast<std::size_t>(kind)].second(random, 2000);
    const Cloud cloud(surfelsAt(points));
    for (std::size_t i = 0; i < points.size(); ++i)
        QVERIFY(cloud.positions()[cloud.places()[i]] == points[i]);
    Points sorted(cloud.positions().begin(), cloud.positions().end());
    const auto before = [](const Vec3f& a, const Vec3f& b) {
        return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z);
    };
    std::sort(sorted.begin(), sorted.end(), before);
    QVERIFY(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
    // Whatever the order of the points, that of the positions is the same.
    Points shuffled = points;
    for (std::size_t i = shuffled.size(); i > 1; --i)
        std::swap(shuffled[i - 1], shuffled[random.below(i)]);
    const Cloud other(surfelsAt(shuffled));
    QVERIFY(std::ranges::equal(cloud.positions(), other.positions()));
    // Who stands there in order already has the place that it has in the list.
    const Points inOrder(cloud.positions().begin(), cloud.positions().end());
    const Cloud same(surfelsAt(inOrder));
    QVERIFY(std::ranges::equal(same.positions(), inOrder) && same.places().areOwn());
    for (std::size_t i = 0; i < inOrder.size(); ++i)
        QCOMPARE(std::size_t(same.places()[i]), i);
}

void KnnTest::fewPositionsHaveFewNeighbours() {
    Neighbours near;
    const Cloud one(surfelsAt({{1, 2, 3}, {1, 2, 3}}));
    QCOMPARE(one.size(), std::size_t(1));
    one.nearest(0, 12, near);
    QCOMPARE(near.size(), std::size_t(0));
    int calls = 0;
    one.forEach(12, {}, "", [&](std::size_t, const Neighbours& found) { calls += found.size() == 0 ? 1 : 100; });
    QCOMPARE(calls, 1);
    const Cloud two(surfelsAt({{1, 2, 3}, {1, 2, 4}, {1, 2, 3}}));
    two.nearest(0, 12, near);
    QCOMPARE(near.index, std::vector<std::uint32_t>{1});
    QCOMPARE(Cloud(std::span<const surfel::Surfel>()).size(), std::size_t(0));
}

void KnnTest::reachFromAnywhere() {
    base::Random random(test::seed());
    for (const auto& [name, make] : kinds) {
        const Points points = make(random, std::size_t(test::effort(600)));
        const Cloud cloud(surfelsAt(points));
        const auto positions = cloud.positions();
        for (int n = 0; n < 40; ++n) {
            const Vec3f& p = positions[random.below(positions.size())];
            const Vec3f x = n % 3 == 0 ? p : p + base::cast<float>(inCube(random) * (n % 3 == 1 ? 0.1 : 5.0));
            std::vector<float> all;
            for (const Vec3f& each : positions)
                all.push_back(distanceSq(x, each));
            std::sort(all.begin(), all.end());
            for (const std::size_t k : {std::size_t(1), std::size_t(4), std::size_t(64), positions.size() + 5})
                QVERIFY2(cloud.reach(x, k) == std::sqrt(all[std::min(k, all.size()) - 1]),
                         qPrintable(QString("%1 k %2 seed %3").arg(name).arg(k).arg(test::seed())));
        }
    }
}

void KnnTest::cancelStops() {
    base::Random random(test::seed());
    const Cloud cloud(surfelsAt(kinds[0].second(random, 1000)));
    const std::atomic<bool> cancel = true;
    const base::Progress progress{{}, &cancel};
    QVERIFY_EXCEPTION_THROWN(cloud.forEach(6, progress, "", [](std::size_t, const Neighbours&) {}), base::Cancelled);
}

void KnnTest::tablesKeepRows() {
    base::Random random(test::seed());
    constexpr std::size_t rows = 200000;
    for (const std::size_t count : {1u, 5u, 12u}) {
        NeighbourTable table(rows, count);
        std::vector<std::pair<std::size_t, std::vector<std::uint32_t>>> written;
        for (int n = 0; n < test::effort(3000); ++n) {
            const std::size_t i = random.below(rows), reach = n % 3 == 0 ? rows : n % 3 == 1 ? 32768 : 100;
            std::vector<std::uint32_t> row;
            for (std::size_t k = 0; k < count; ++k) {
                const auto from = static_cast<std::int64_t>(i) - static_cast<std::int64_t>(random.below(reach + 1));
                const auto to =
                    std::clamp<std::int64_t>(n % 2 ? from : 2 * static_cast<std::int64_t>(i) - from, 0, rows - 1);
                row.push_back(static_cast<std::uint32_t>(to));
            }
            table.set(i, row);
            std::erase_if(written, [&](const auto& each) { return each.first == i; });
            written.push_back({i, row});
        }
        for (const auto& [i, row] : written) {
            const NeighbourTable::Row found = table.row(i);
            QVERIFY2(std::equal(row.begin(), row.end(), found.begin()), qPrintable(QString::number(test::seed())));
            QVERIFY(table.sees(i, row.back()));
            QVERIFY(table.sees(i, row.front(), 1));
        }
    }
}

void KnnTest::pointsArePutInOrderOnceWithWhatTheyCarry() {
    base::Random random(test::seed());
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->add("number", surfel::ScalarType::UInt32);
    for (const auto& [name, make] : kinds) {
        surfel::SurfelList list{layout, surfelsAt(make(random, 1500)), {}};
        for (std::uint32_t i = 0; i < list.size(); ++i) {
            list.items[i].colour = i;
            list.extra.push_back(i);
        }
        const surfel::SurfelList before = list;
        const base::LargeArray<std::uint32_t> numbers = putInCurveOrder(list);
        std::vector<std::uint8_t> seen(list.size(), 0);
        for (std::uint32_t i = 0; i < list.size(); ++i) {
            const std::uint32_t number = numbers.empty() ? i : numbers[i];
            QVERIFY2(list.items[i] == before.items[number] && list.extra[i] == number && seen[number]++ == 0, name);
        }
        const auto stands = list.items;
        QVERIFY2(putInCurveOrder(list).empty() && list.items == stands, name);
        QVERIFY2(std::ranges::equal(Cloud(before.items).positions(), Cloud(list.items).positions()), name);
    }
}

void KnnTest::neighboursOfWhatStaysAreThoseOfASearch_data() {
    QTest::addColumn<int>("kind");
    for (int kind = 0; kind < static_cast<int>(kinds.size()); ++kind)
        QTest::addRow("%s", kinds[static_cast<std::size_t>(kind)].first) << kind;
}

void KnnTest::neighboursOfWhatStaysAreThoseOfASearch() {
    QFETCH(int, kind);
    base::Random random(test::seed());
    const Points points = kinds[static_cast<std::size_t>(kind)].second(random, std::size_t(test::effort(800)));
    const Cloud cloud(surfelsAt(points));
    const std::size_t n = cloud.size();
    // One, some anywhere, some side by side, the first and the last along the curve, more than pays, nearly all.
    const auto anyOf = [&](std::size_t each) { return [&, each](std::size_t) { return random.below(each) == 0; }; };
    const std::vector<std::function<bool(std::size_t)>> goes = {
        [&](std::size_t i) { return i == n / 2; },
        anyOf(100),
        [&](std::size_t i) { return i > n / 3 && i < n / 3 + n / 20; },
        [&](std::size_t i) { return i == 0 || i == n - 1; },
        anyOf(3),
        [&](std::size_t i) { return i >= 5; },
    };
    for (std::size_t way = 0; way < goes.size(); ++way) {
        std::vector<std::uint8_t> stays(n);
        Points left;
        for (std::size_t i = 0; i < n; ++i)
            if ((stays[i] = goes[way](i) ? 0 : 1) != 0)
                left.push_back(cloud.positions()[i]);
        const Cloud rest(surfelsAt(left));
        for (const std::size_t looked : {0u, 18u}) {
            base::setThreadCount(looked == 0 ? 1 : 0);
            KeptNeighbours kept(cloud, neighboursOf(cloud, looked, {}), stays);
            const CloudNeighbours found = std::move(kept).in(rest, looked, {}), sought = neighboursOf(rest, looked, {});
            const QString where = QString("way %1, %2 looked at, seed %3").arg(way).arg(looked).arg(test::seed());
            QVERIFY2(sameBytes<float>(found.spacing, sought.spacing), qPrintable(where));
            QVERIFY2(sameBytes<Vec3f>(found.normals, sought.normals), qPrintable(where));
            QVERIFY2(found.table.size() == rest.size() && found.table.count() == sought.table.count(),
                     qPrintable(where));
            for (std::size_t i = 0; i < rest.size(); ++i) {
                const NeighbourTable::Row a = found.table.row(i), b = sought.table.row(i);
                QVERIFY2(std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(found.table.count()), b.begin()),
                         qPrintable(QString("%1 of %2, ").arg(i).arg(rest.size()) + where));
            }
        }
    }
    base::setThreadCount(0);
}

static const test::Registered<KnnTest> registered;
#include "knn_test.moc"
