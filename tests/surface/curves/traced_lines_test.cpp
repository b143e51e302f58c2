// Curves traced so far (traced_lines.h): what is found is what comes near, at a price that knows the place alone.
#include "core/base/random.h"
#include "core/surface/curves/traced_lines.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using surface::TracedLines;

class TracedLinesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void findsTheFirstLineThatComesNear();
    void oneWideSupportSlowsNothing();
};

namespace {

struct Point {
    Vec3d position, direction{1, 0, 0};
    double unit = 1;

    Vec3d tangent() const { return direction; }
};
using Line = std::vector<Point>;

/// A way of steps of up to a quarter of h, from somewhere, that turns as it goes.
Line randomLine(base::Random& random, double unit, std::size_t count) {
    Line out;
    Point at{{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)}, random.unitVector(), unit};
    for (std::size_t i = 0; i < count; ++i) {
        out.push_back(at);
        at.direction = base::normalized(at.direction + random.unitVector() * 0.3);
        at.position = at.position + at.direction * (unit * random.uniform(0.001, 0.25));
    }
    return out;
}

bool near(const Line& line, bool closed, const Point& p, double radius) {
    for (std::size_t i = closed || line.size() == 1 ? 0 : 1; i < line.size(); ++i) {
        const Point &a = line[i == 0 ? line.size() - 1 : i - 1], &b = line[i];
        const Vec3d way = b.position - a.position;
        const double square = lengthSq(way);
        const double part = square > 0 ? std::clamp(dot(p.position - a.position, way) / square, 0.0, 1.0) : 0;
        if (distance(a.position + way * part, p.position) < radius && std::abs(dot(a.tangent(), p.tangent())) > 0.5)
            return true;
    }
    return false;
}

} // namespace

/// Supports that differ a thousandfold, asked for and traced in turns.
void TracedLinesTest::findsTheFirstLineThatComesNear() {
    base::Random random(test::seed());
    int found = 0;
    for (int round = 0; round < test::effort(10); ++round) {
        TracedLines traced;
        std::vector<std::pair<Line, bool>> lines;
        for (std::size_t number = 0; number < 20; ++number) {
            const double unit = std::exp(random.uniform(std::log(0.003), std::log(3.0)));
            lines.emplace_back(randomLine(random, unit, 1 + random.below(40)), random.uniform() < 0.3);
            traced.add(lines.back().first, lines.back().second, number);
            for (int i = 0; i < 20; ++i) {
                const Line& beside = lines[random.below(lines.size())].first;
                Point p = beside[random.below(beside.size())];
                p.unit *= std::exp(random.uniform(-3, 3));
                const double reach = random.uniform(0, 0.12);
                p.position = p.position + random.unitVector() * (reach * p.unit * random.uniform(0, 2));
                std::ptrdiff_t expected = -1;
                for (std::size_t k = 0; k < lines.size() && expected < 0; ++k)
                    if (near(lines[k].first, lines[k].second, p, reach * p.unit))
                        expected = static_cast<std::ptrdiff_t>(k);
                found += expected >= 0;
                QVERIFY2(traced.lineAt(p, reach) == expected, qPrintable(QString("seed %1").arg(test::seed())));
            }
        }
    }
    QVERIFY(found > 20);
}

void TracedLinesTest::oneWideSupportSlowsNothing() {
    constexpr std::size_t count = 2000;
    constexpr double unit = 0.01;
    std::size_t compared[2];
    for (const bool wide : {false, true}) {
        base::Random random(test::seed());
        TracedLines traced;
        if (wide)
            traced.add(Line{{{5, 5, 5}, {1, 0, 0}, 3}, {{5.7, 5, 5}, {1, 0, 0}, 3}}, false, 0);
        const Line line = randomLine(random, unit, count);
        traced.add(line, false, 1);
        for (const Point& p : line)
            QCOMPARE(traced.lineAt(p, 0.02), std::ptrdiff_t(1));
        compared[wide] = traced.compared();
    }
    const QString told = QString("seed %1: %2 and %3").arg(test::seed()).arg(compared[0]).arg(compared[1]);
    QVERIFY2(compared[0] < 100 * count && compared[1] <= compared[0] + count, qPrintable(told));
}

static const test::Registered<TracedLinesTest> registered;
#include "traced_lines_test.moc"
