// Many points about one place, in a surrounding that is far sparser.
#include "core/base/random.h"
#include "core/process/estimation/supports.h"
#include "support/registry.h"

#include <algorithm>
#include <cmath>
#include <QTest>

using base::Vec3d;

class PilesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void noSupportHoldsThePile_data();
    void noSupportHoldsThePile();
};

/// Samples of a unit sphere, and `pile` more points within `jitter` spacings of one of them.
static surfel::SurfelList sphereWithPile(std::size_t samples, std::size_t pile, double jitter, base::Random& random) {
    surfel::SurfelList out;
    const auto add = [&](const Vec3d& p) { out.items.emplace_back().position = base::cast<float>(p); };
    for (std::size_t i = 0; i < samples; ++i)
        add(random.unitVector());
    const double spacing = std::sqrt(12.57 / static_cast<double>(samples));
    for (std::size_t i = 0; i < pile; ++i)
        add(Vec3d{1, 0, 0} + random.unitVector() * (jitter * spacing * std::cbrt(random.uniform())));
    return out;
}

static std::size_t heldBy(const surfel::SurfelList& list, std::size_t i) {
    const surfel::Surfel& s = list.items[i];
    return static_cast<std::size_t>(std::count_if(list.items.begin(), list.items.end(), [&](const surfel::Surfel& o) {
        return distanceSq(o.position, s.position) < s.support * s.support;
    }));
}

void PilesTest::noSupportHoldsThePile_data() {
    QTest::addColumn<double>("jitter");
    for (const double jitter : {0.003, 0.01, 0.1, 1.0})
        QTest::addRow("%g spacings", jitter) << jitter;
}

void PilesTest::noSupportHoldsThePile() {
    QFETCH(double, jitter);
    base::Random random(test::seed());
    const std::size_t samples = 3000, pile = 30000;
    surfel::SurfelList list = sphereWithPile(samples, pile, jitter, random);
    surfel::SurfelList alone = list;
    alone.items.resize(samples);
    process::assignSupports(list, {});
    process::assignSupports(alone, {});
    std::size_t most = 0;
    for (int k = 0; k < 300; ++k)
        most = std::max(most, heldBy(list, samples + random.below(pile)));
    QVERIFY2(most < 2 * 4096, qPrintable(QString("%1 in one support, seed %2").arg(most).arg(test::seed())));
    for (std::size_t i = 0; i < samples; ++i) // the rest of the model knows nothing of it
        if (list.items[i].position.x < 0.3f)
            QCOMPARE(list.items[i].support, alone.items[i].support);
}

static const test::Registered<PilesTest> registered;
#include "piles_test.moc"
