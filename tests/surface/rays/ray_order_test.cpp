// Rays of a view put in an order of tiles: a permutation, whose runs lie closer together than rows do.
#include "core/surface/rays/ray_order.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using namespace surface;
using base::Vec3f;

class RayOrderTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void rowsBecomeTiles();
    void whatIsInOrderStaysAsItIs();
    void raysThatRunAllWaysStayAsTheyAre();
    void oddRaysAreOrderedToo();
};

namespace {

const base::Box3f bounds{{-1, -1, -1}, {1, 1, 1}};
constexpr std::size_t side = 64, run = 32;

/// Row by row, or tiles of 8 x 8.
std::vector<base::Rayf> view(bool tiles) {
    std::vector<base::Rayf> out;
    for (std::size_t i = 0; i < side * side; ++i) {
        const std::size_t tile = i / 64, x = tiles ? tile % 8 * 8 + i % 8 : i % side,
                          y = tiles ? tile / 8 * 8 + i % 64 / 8 : i / side;
        const Vec3f d{(float(x) + 0.5f) / side - 0.5f, (float(y) + 0.5f) / side - 0.5f, -2};
        out.push_back({{0, 0, 4}, base::normalized(d)});
    }
    return out;
}

void verifyPermutation(std::vector<std::uint32_t> order, std::size_t count) {
    std::sort(order.begin(), order.end());
    QCOMPARE(order.size(), count);
    for (std::size_t i = 0; i < count; ++i)
        QCOMPARE(order[i], std::uint32_t(i));
}

} // namespace

void RayOrderTest::rowsBecomeTiles() {
    const std::vector<base::Rayf> rays = view(false);
    const std::vector<std::uint32_t> order = viewOrder(rays, bounds);
    verifyPermutation(order, rays.size());
    const auto reach = [&](auto&& index) {
        float sum = 0;
        for (std::size_t first = 0; first < rays.size(); first += run) {
            base::Box3f box;
            for (std::size_t i = first; i < first + run; ++i)
                box.extend(rays[index(i)].direction);
            sum += box.diagonal();
        }
        return sum;
    };
    const float rows = reach([](std::size_t i) { return i; });
    const float tiles = reach([&](std::size_t i) { return std::size_t(order[i]); });
    QVERIFY2(tiles < 0.5f * rows, qPrintable(QString("%1 of %2").arg(tiles).arg(rows)));
}

void RayOrderTest::whatIsInOrderStaysAsItIs() {
    QVERIFY(viewOrder(view(true), bounds).empty());
    QVERIFY(viewOrder({}, bounds).empty());
    QVERIFY(viewOrder(view(false), {}).empty());
}

void RayOrderTest::raysThatRunAllWaysStayAsTheyAre() {
    base::Random random(test::seed());
    std::vector<base::Rayf> rays;
    for (int i = 0; i < 1000; ++i) {
        const base::Vec3d d = random.unitVector();
        rays.push_back({base::cast<float>(d * -3.0), base::cast<float>(d)});
    }
    QVERIFY(viewOrder(rays, bounds).empty());
}

/// Without a direction, past the box, or with no numbers in them.
void RayOrderTest::oddRaysAreOrderedToo() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    std::vector<base::Rayf> rays = view(false);
    rays[5].direction = {};
    rays[70].direction = {nan, 0, -1};
    rays[71].origin = {inf, 0, 4};
    rays[72].origin = {100, 0, 4};
    const std::vector<std::uint32_t> order = viewOrder(rays, bounds);
    if (!order.empty())
        verifyPermutation(order, rays.size());
}

static const test::Registered<RayOrderTest> registered;
#include "ray_order_test.moc"
