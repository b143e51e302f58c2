// A thinned model is a part of the model: nothing closer than asked for, nothing left that had room.
#include "core/base/random.h"
#include "core/process/cleaning/thin.h"
#include "process/even_shapes.h"
#include "support/registry.h"

#include <QTest>

using namespace process;
using base::Vec3d;

class ThinTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void keptPointsStandApartAndCoverAll();
    void theOrderOfTheListDoesNotMatter();
    void twoSidesOfAWallAreThinnedApart();
    void maskedPointsStay();
    void manyAtOnePlaceAreQuick();
};

static surfel::SurfelList randomSphere(std::size_t count, base::Random& random) {
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d d = random.unitVector();
        out.append(test::surfelAt(d, d, 0.02), {});
    }
    return out;
}

void ThinTest::keptPointsStandApartAndCoverAll() {
    base::Random random(test::seed());
    const surfel::SurfelList list = randomSphere(2500, random);
    const float s = 0.1f;
    const std::vector<std::uint8_t> removed = thinned(list, s);
    for (std::size_t i = 0; i < list.size(); ++i) {
        float nearest = 1e9f; // among those that stay, by brute force
        for (std::size_t j = 0; j < list.size(); ++j)
            if (j != i && !removed[j])
                nearest = std::min(nearest, distance(list.items[i].position, list.items[j].position));
        QVERIFY2(removed[i] ? nearest < s : nearest >= s,
                 qPrintable(QString("%1 seed %2").arg(nearest).arg(test::seed())));
    }
}

void ThinTest::theOrderOfTheListDoesNotMatter() {
    base::Random random(test::seed());
    const surfel::SurfelList list = randomSphere(2000, random);
    surfel::SurfelList turned = list;
    std::reverse(turned.items.begin(), turned.items.end());
    const auto one = thinned(list, 0.07f), other = thinned(turned, 0.07f);
    QVERIFY(std::equal(one.begin(), one.end(), other.rbegin()));
}

void ThinTest::twoSidesOfAWallAreThinnedApart() {
    surfel::SurfelList list = test::planePoints(40, 0.02), upper = list;
    const std::size_t half = list.size();
    for (std::size_t i = 0; i < half; ++i) {
        surfel::Surfel s = list.items[i];
        s.position.z -= 0.01f;
        s.normal = -s.normal;
        list.append(s, {});
    }
    const auto alone = thinned(upper, 0.06f), both = thinned(list, 0.06f);
    QVERIFY(std::equal(alone.begin(), alone.end(), both.begin()));
    const auto below = std::count(both.begin() + std::ptrdiff_t(half), both.end(), 0);
    QVERIFY(below > 100);
}

void ThinTest::maskedPointsStay() {
    base::Random random(test::seed());
    surfel::SurfelList list = randomSphere(2000, random);
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->masks = true;
    list.layout = layout;
    for (std::size_t i = 0; i < list.size(); i += 3)
        list.items[i].mask = 1;
    const auto removed = thinned(list, 0.2f);
    for (std::size_t i = 0; i < list.size(); ++i)
        QVERIFY(list.items[i].mask < 1 || !removed[i]);
}

void ThinTest::manyAtOnePlaceAreQuick() {
    surfel::SurfelList list;
    for (int i = 0; i < test::effort(200000); ++i)
        list.items.push_back({});
    for (const float s : {1e-30f, 1.0f, 1e30f}) {
        const auto removed = thinned(list, s);
        QCOMPARE(std::count(removed.begin(), removed.end(), 0), std::ptrdiff_t(1));
    }
}

static const test::Registered<ThinTest> registered;
#include "thin_test.moc"
