// Whether it is told that normals contradict each other.
#include "core/base/random.h"
#include "core/process/estimation/orientation/contradictions.h"
#include "process/even_shapes.h"
#include "support/registry.h"

#include <QTest>

class ContradictionsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void flippedNormalsContradict();
    void thinWallsDoNot();
};

void ContradictionsTest::flippedNormalsContradict() {
    base::Random random(test::seed());
    surfel::SurfelList list = test::spherePoints(3000);
    QCOMPARE(process::contradictions(tree::SurfelTree::build(list)), 0.0);
    const double part = random.uniform(0.1, 0.5);
    for (surfel::Surfel& s : list.items)
        if (random.uniform() < part)
            s.normal = -s.normal;
    const double found = process::contradictions(tree::SurfelTree::build(list));
    QVERIFY2(std::abs(found - 2 * part * (1 - part)) < 0.06, QByteArray::number(found));
}

/// Two sheets of a plate, nearer than their points are apart, each with points of its own places.
void ContradictionsTest::thinWallsDoNot() {
    base::Random random(test::seed());
    const float spacing = 0.05f, wall = spacing * static_cast<float>(random.uniform(0.4, 1));
    surfel::SurfelList list;
    list.layout = test::spherePoints(4).layout;
    for (const float side : {-1.0f, 1.0f})
        for (int i = 0; i < 40; ++i)
            for (int k = 0; k < 40; ++k) {
                const auto by = [&] { return static_cast<float>(random.uniform(-0.2, 0.2)); };
                surfel::Surfel s;
                s.position = {spacing * (static_cast<float>(i) + by()), spacing * (static_cast<float>(k) + by()),
                              side * wall / 2};
                s.normal = {0, 0, side};
                s.support = 3.5f * spacing;
                list.append(s, {});
            }
    const double found = process::contradictions(tree::SurfelTree::build(list));
    QVERIFY2(found < 0.01, QByteArray::number(found));
}

static const test::Registered<ContradictionsTest> registered;
#include "contradictions_test.moc"
