// What draws an open surface out along its rim leaves the rim where it is: there, too, samples come where there is
// room.
#include "core/base/random.h"
#include "core/process/resampling/resample.h"
#include "core/surface/rims.h"
#include "process/even_shapes.h"
#include "support/registry.h"

#include <QTest>

#include <numeric>

class StretchedRimsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aRimThatIsDrawnAlongItselfStaysWhole_data();
    void aRimThatIsDrawnAlongItselfStaysWhole();
    void samplesOfADrawnRimTellOfIt();
    void aHoleThatIsDrawnWideStaysOpen();
};

using base::Vec3d;

namespace {

/// An even sheet, spacing 1, `size` long and wide, as jittered as many scans; bent across by `bend` per length. What
/// is within `hole` of its middle is left out.
surface::Surface sheet(base::Random& random, const Vec3d& size, double bend, double hole) {
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    for (double y = 0.5; y < size.y; ++y)
        for (double x = 0.5; x < size.x; ++x) {
            const double u = x - size.x / 2 + random.uniform(-0.3, 0.3), v = y - size.y / 2 + random.uniform(-0.3, 0.3);
            if (std::hypot(u, v) < hole)
                continue;
            out.append(test::surfelAt({u, v, bend * v * v}, normalized(Vec3d{0, -2 * bend * v, 1}), 1), {});
        }
    return test::surfaceOf(out);
}

/// The same, whose surfels tell of the rims along it (surface/rims.h).
surface::Surface knowing(const surface::Surface& sheet, double halfWidth) {
    surfel::SurfelList list = sheet.tree().surfels(), out;
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->add(surface::rimName, surfel::ScalarType::UInt8);
    out.layout = layout;
    for (const surfel::Surfel& each : list.items) {
        const bool beside = halfWidth - std::abs(each.position.y) < surface::rimReach * each.support;
        std::vector<std::uint32_t> words(layout->words(), 0);
        surfel::write(*layout->find(surface::rimName), words, beside ? 1 : 0);
        out.append(each, words);
    }
    surface::SurfaceDefinition definition = sheet.definition();
    definition.knownRims = true;
    definition.boundaryLimit = 0.3F;
    return {tree::SurfelTree::build(out), definition};
}

/// As far as a stroke goes before what it has drawn out is resampled, and how often.
constexpr float drawn = 1.8F;
constexpr int rounds = 6;

/// Drawn out along x, and resampled each time as under a stroke.
surface::Surface drawnOut(surface::Surface now) {
    process::ResampleOptions options;
    options.spacing = 1;
    options.sweeps = 2;
    options.fitRounds = 0;
    options.drawnApart = [](const surfel::SurfelBlock&, int) { return true; };
    for (int k = 0; k < rounds; ++k) {
        surfel::SurfelList list = now.tree().surfels();
        for (surfel::Surfel& each : list.items)
            each.position.x *= drawn;
        const surface::Surface longer(tree::SurfelTree::build(list), now.definition());
        now = {longer.tree().apply(process::resample(longer, process::selectAll(longer.tree()), options)),
               longer.definition()};
    }
    return now;
}

} // namespace

void StretchedRimsTest::aRimThatIsDrawnAlongItselfStaysWhole_data() {
    QTest::addColumn<double>("bend");
    QTest::newRow("flat") << 0.0;
    QTest::newRow("bent") << 0.02;
}

void StretchedRimsTest::aRimThatIsDrawnAlongItselfStaysWhole() {
    QFETCH(double, bend);
    base::Random random(test::seed());
    const surface::Surface now = drawnOut(sheet(random, {6, 16, 0}, bend, 0));
    // along both rims, in pieces of two spacings: how far out the last sample lies
    const double half = 3 * std::pow(double(drawn), rounds) - 4;
    std::vector<double> last[2];
    for (std::vector<double>& side : last)
        side.assign(std::size_t(half), 0);
    double farthest = 0;
    for (const surfel::Surfel& each : now.tree().surfels().items) {
        const double x = double(each.position.x), y = double(each.position.y);
        farthest = std::max(farthest, std::abs(y));
        if (std::abs(x) < half) {
            double& most = last[y > 0].at(std::min(std::size_t((x + half) / 2), std::size_t(half) - 1));
            most = std::max(most, std::abs(y));
        }
    }
    double mean = 0;
    for (const std::vector<double>& side : last)
        mean += std::accumulate(side.begin(), side.end(), 0.0) / double(2 * side.size());
    const QByteArray told = QString("last samples at %1 of 7.5 (%2)").arg(mean).arg(farthest).toUtf8();
    qInfo("%s", told.constData());
    QVERIFY2(mean > 7.12 && mean < 7.8 && farthest < 8.7, told);
}

/// Those of the last row nearly all, or the surface would go on beyond them, as a tab: where the majority about a new
/// sample decided, a tenth of them said nothing. Those far inside need not.
void StretchedRimsTest::samplesOfADrawnRimTellOfIt() {
    base::Random random(test::seed());
    const surface::Surface now = drawnOut(knowing(sheet(random, {6, 16, 0}, 0, 0), 8));
    const surfel::AttributeLayout& layout = *now.tree().layout();
    const double half = 3 * std::pow(double(drawn), rounds) - 4;
    std::size_t last = 0, silent = 0, inner = 0, mistaken = 0;
    now.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const base::Vec3f x = block.position(slot);
            if (std::abs(double(x.x)) > half)
                continue;
            const bool tells = surface::isBesideRim(block, slot, layout);
            const double y = std::abs(double(x.y));
            last += y > 7, silent += y > 7 && !tells;
            inner += y < 4, mistaken += y < 4 && tells;
        }
    });
    const QByteArray told =
        QString("%1 of %2 silent, %3 of %4 mistaken").arg(silent).arg(last).arg(mistaken).arg(inner).toUtf8();
    qInfo("%s", told.constData());
    QVERIFY2(silent * 40 < last && mistaken * 200 < inner, told);
}

void StretchedRimsTest::aHoleThatIsDrawnWideStaysOpen() {
    base::Random random(test::seed());
    const surface::Surface now = drawnOut(sheet(random, {12, 16, 0}, 0, 4));
    // an ellipse now: nothing has grown into it farther than its own rim was ragged
    const double wide = 4 * std::pow(double(drawn), rounds);
    for (const surfel::Surfel& each : now.tree().surfels().items) {
        const double at = std::hypot(double(each.position.x) / wide, double(each.position.y) / 4);
        QVERIFY2(at > 0.7, qPrintable(QString("%1, %2").arg(each.position.x).arg(each.position.y)));
    }
}

static const test::Registered<StretchedRimsTest> registered;
#include "stretched_rims_test.moc"
