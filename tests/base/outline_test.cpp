// What an outline holds, against a look at all its edges: random ones, most of which cross themselves.
#include "core/base/outline.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using base::Outline;
using base::Point2;

class OutlineTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void pointsAreEvenOdd();
};

/// By all edges, one after the other.
static bool evenOdd(const std::vector<Point2>& corners, const Point2& p) {
    bool in = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y))
            in = !in;
    }
    return in;
}

static std::vector<Point2> randomOutline(base::Random& random, std::size_t corners) {
    std::vector<Point2> out;
    for (std::size_t i = 0; i < corners; ++i)
        out.push_back({400 * random.uniform(), 300 * random.uniform()});
    return out;
}

void OutlineTest::pointsAreEvenOdd() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(30); ++round) {
        const std::vector<Point2> corners = randomOutline(random, 3 + random.below(60));
        const Outline outline(corners);
        for (int k = 0; k < 300; ++k) {
            const Point2 p{-50 + 500 * random.uniform(), -50 + 400 * random.uniform()};
            QCOMPARE(outline.holds(p), evenOdd(corners, p));
            // A rectangle that no edge meets is of one kind.
            const Point2 q{p.x + 40 * random.uniform(), p.y + 40 * random.uniform()};
            if (!outline.meets(p, q))
                for (int c = 0; c < 5; ++c)
                    QCOMPARE(
                        evenOdd(corners, {p.x + random.uniform() * (q.x - p.x), p.y + random.uniform() * (q.y - p.y)}),
                        evenOdd(corners, p));
        }
    }
    QVERIFY(!Outline().holds({0, 0}));
    const Point2 flat[] = {{0, 0}, {5, 0}, {9, 0}};
    QVERIFY(!Outline(flat).holds({5, 0}));
    const Point2 square[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    QVERIFY(Outline(square).holds({2, 2}) && Outline(square).holds({0, 0}) && !Outline(square).holds({4, 4}));
}

static const test::Registered<OutlineTest> registered;
#include "outline_test.moc"
