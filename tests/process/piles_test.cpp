// Many points about one place, or in a part of the model, beside others that are far sparser.
#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
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
    void noSupportHoldsTheDensePartBesideASparseOne();
    void theDensePartStaysSmooth();
};

/// Ten times the neighbours asked for, and what counting every 16th may err by.
constexpr std::size_t mostHeld = 2 * 10 * 38;

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
    QVERIFY2(most < mostHeld, qPrintable(QString("%1 in one support, seed %2").arg(most).arg(test::seed())));
    for (std::size_t i = 0; i < samples; ++i) // the rest of the model knows nothing of it
        if (list.items[i].position.x < 0.3f)
            QCOMPARE(list.items[i].support, alone.items[i].support);
}

/// Half a sphere `jump` times as sparse as the other, with exact normals. The dense half's spacing is 1.
static surfel::SurfelList jumpingSphere(double radius, double jump, base::Random& random) {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    for (const double spacing : {1.0, jump}) {
        const auto count = static_cast<std::size_t>(12.57 * radius * radius / (spacing * spacing));
        for (std::size_t i = 0; i < count; ++i) { // a golden spiral
            const auto k = static_cast<double>(i);
            const double z = 1 - (2 * k + 1) / static_cast<double>(count), angle = k * 2.39996322972865;
            const Vec3d on{std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z};
            const Vec3d n = base::normalized(on * radius + random.unitVector() * (0.25 * spacing));
            if ((n.z > 0) != (spacing == 1))
                continue;
            surfel::Surfel& s = out.items.emplace_back();
            s.position = base::cast<float>(n * radius), s.normal = base::cast<float>(n);
        }
    }
    return out;
}

/// However abruptly: a query there would take as long as the dense part is large.
void PilesTest::noSupportHoldsTheDensePartBesideASparseOne() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(3); ++round) {
        const double jump = random.uniform(10, 25);
        surfel::SurfelList list = jumpingSphere(6 * jump, jump, random);
        process::assignSupports(list, {});
        std::size_t most = 0;
        for (int k = 0; k < 1000;) {
            const std::size_t i = random.below(list.size());
            if (list.items[i].position.z < 0 || list.items[i].position.z > 2 * jump)
                continue;
            most = std::max(most, heldBy(list, i));
            ++k;
        }
        QVERIFY2(most < mostHeld,
                 qPrintable(QString("%1 in one support, jump %2, seed %3").arg(most).arg(jump).arg(test::seed())));
    }
}

/// Sparse samples beside it do not ripple it: f on the sphere stays within a thousandth of their spacing.
void PilesTest::theDensePartStaysSmooth() {
    base::Random random(test::seed());
    const double jump = 20, radius = 8 * jump;
    const surface::Surface surface = process::prepare(jumpingSphere(radius, jump, random), {});
    double square = 0;
    const int count = 3000;
    for (int k = 0; k < count; ++k) {
        const double z = random.uniform(0, 1.5 * jump), angle = random.uniform(0, 6.2831853);
        const double r = std::sqrt(radius * radius - z * z);
        const auto at = surface.evaluate(base::cast<float>(Vec3d{r * std::cos(angle), r * std::sin(angle), z}),
                                         surface::Need::Value);
        QVERIFY(at.ok());
        square += double(at.value) * double(at.value);
    }
    const double rms = std::sqrt(square / count) / jump;
    QVERIFY2(rms < 0.0005, qPrintable(QString("%1, seed %2").arg(rms).arg(test::seed())));
}

static const test::Registered<PilesTest> registered;
#include "piles_test.moc"
