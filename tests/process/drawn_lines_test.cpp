// Whether points that draw lines in a plane are told from those of surfaces.
#include "core/process/estimation/drawn_lines.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <functional>
#include <QTest>

using base::Vec3d;

class DrawnLinesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void plansAreLines();
    void sheetsAreNot();
    void linesOnABodyAreNot();
};

/// Places in a plane that stands anywhere, as thick as `relief` in it.
static tree::SurfelTree placed(std::size_t count, double relief, const std::function<Vec3d(base::Random&)>& place) {
    base::Random random(test::seed());
    const Vec3d n = random.unitVector(), u = base::normalized(cross(n, random.unitVector())), v = cross(n, u);
    surfel::SurfelList list;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d p = place(random);
        surfel::Surfel s;
        s.support = 0.1f;
        s.position = base::cast<float>(u * p.x + v * p.y + n * (p.z + relief * random.uniform(-1, 1)));
        list.append(s, {});
    }
    return tree::SurfelTree::build(list);
}

/// Some rectangles and circles, drawn with a trembling hand.
static Vec3d plan(base::Random& random) {
    const auto which = static_cast<int>(random.uniform(0, 6));
    const Vec3d middle{which * 1.7, which % 3 * 2.1, 0}, wide{0.4 + 0.1 * which, 0.8 - 0.05 * which, 0};
    const double turn = random.uniform(0, 6.283185307), r = random.uniform(-1, 1), noise = 0.004;
    Vec3d p{std::cos(turn), std::sin(turn), 0};
    if (which % 2 == 0)
        p = random.uniform() < 0.5 ? Vec3d{r, p.x > 0 ? 1.0 : -1.0, 0} : Vec3d{p.x > 0 ? 1.0 : -1.0, r, 0};
    return middle +
           Vec3d{p.x * wide.x + noise * random.uniform(-1, 1), p.y * wide.y + noise * random.uniform(-1, 1), 0};
}

void DrawnLinesTest::plansAreLines() {
    for (const std::size_t count : {1500, 6000})
        QVERIFY2(process::drawsLines(placed(count, 0, plan)), QByteArray::number(test::seed()));
}

/// By chance, in a grid, and drawn out to one side.
void DrawnLinesTest::sheetsAreNot() {
    for (const double along : {1.0, 3.0}) {
        const auto chance = [along](base::Random& r) { return Vec3d{along * r.uniform(-1, 1), r.uniform(-1, 1), 0}; };
        QVERIFY2(!process::drawsLines(placed(3000, 0, chance)), QByteArray::number(test::seed()));
    }
    int at = 0;
    QVERIFY(!process::drawsLines(placed(2500, 0, [&at](base::Random&) {
        const int i = at++;
        return Vec3d{0.1 * (i % 50), 0.1 * (i / 50), 0};
    })));
    QVERIFY(!process::drawsLines({}));
}

/// A body that was scanned in lines is no drawing, and neither is a sheet that is not flat.
void DrawnLinesTest::linesOnABodyAreNot() {
    QVERIFY(!process::drawsLines(placed(3000, 0.05, plan)));
    const auto rings = [](base::Random& r) {
        const double z = 0.2 * std::floor(r.uniform(-5, 5)), turn = r.uniform(0, 6.283185307);
        return Vec3d{std::cos(turn), std::sin(turn), z};
    };
    QVERIFY(!process::drawsLines(placed(3000, 0, rings)));
}

static const test::Registered<DrawnLinesTest> registered;
#include "drawn_lines_test.moc"
