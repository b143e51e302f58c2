// What a stroke leaves in a sheet that contradicts it goes; sides, rims, tips and corners of what is thin stay.
#include "core/base/random.h"
#include "core/process/resampling/resample.h"
#include "core/sculpt/crumbs.h"
#include "sculpt/random_plate.h"
#include "support/registry.h"

#include <cmath>

#include <QTest>

using base::Random;
using base::Vec3d;

using namespace sculpt;

namespace {

/// Of each surfel, as if it had not moved: the spacing its support is made for.
SourceOf standing(const surface::Surface& of) {
    return [definition = of.definition()](const surfel::SurfelBlock& block, int slot) {
        const float s = process::spacingOf(definition, block.support(slot));
        return CrumbSource{block.position(slot), s, s};
    };
}

std::size_t dropped(const surface::Surface& now, const tree::SurfelTree& first) {
    const tree::Edit edit = dropCrumbs(now.tree(), first, process::selectAll(now.tree()), standing(now));
    return now.tree().size() - now.tree().apply(edit).size();
}

surface::Surface prepared(const std::vector<surfel::Surfel>& points) {
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    for (const surfel::Surfel& each : points)
        out.append(each, {});
    return process::prepare(out, {});
}

surfel::Surfel pointAt(const Vec3d& p, const Vec3d& n) {
    surfel::Surfel out;
    out.position = base::cast<float>(p), out.normal = base::cast<float>(normalized(n));
    return out;
}

/// Waves of random heights, folds where they are steep, jittered, twice as fine on one side.
std::vector<surfel::Surfel> wavySheet(Random& random) {
    const double along = random.uniform(2, 6), across = random.uniform(1, 4), high = random.uniform(0.02, 0.12);
    std::vector<surfel::Surfel> out;
    for (double y = -1; y < 1;) {
        const double s = 0.03 * (1.5 + 0.5 * y);
        for (double x = -1; x < 1; x += s) {
            const double u = x + random.uniform(-0.2, 0.2) * s, v = y + random.uniform(-0.2, 0.2) * s;
            const double z = high * std::sin(along * u) * std::cos(across * v);
            out.push_back(pointAt({u, v, z}, {-high * along * std::cos(along * u) * std::cos(across * v),
                                              high * across * std::sin(along * u) * std::sin(across * v), 1}));
        }
        y += s;
    }
    return out;
}

/// A cone upside up, open below, its tip included.
std::vector<surfel::Surfel> needle(Random& random, double halfAngle) {
    constexpr double s = 0.03, length = 1.2;
    std::vector<surfel::Surfel> out{pointAt({}, {0, 0, 1})};
    for (double t = s; t < length; t += s * random.uniform(0.8, 1.2)) {
        const double radius = t * std::sin(halfAngle);
        const int count = std::max(3, int(2 * M_PI * radius / s));
        const double turn = random.uniform(0, 6.3);
        for (int k = 0; k < count; ++k) {
            const double a = turn + 2 * M_PI * k / count;
            const Vec3d out1{std::cos(a), std::sin(a), 0};
            out.push_back(pointAt(out1 * radius - Vec3d{0, 0, t * std::cos(halfAngle)},
                                  out1 * std::cos(halfAngle) + Vec3d{0, 0, std::sin(halfAngle)}));
        }
    }
    return out;
}

} // namespace

class FoldStraysTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatContradictsTheSheetItLiesInGoes();
    void whatWasAStrayStays();
    void thinThingsKeepEverySurfel();
};

void FoldStraysTest::whatContradictsTheSheetItLiesInGoes() {
    for (int run = 0; run < test::effort(10); ++run) {
        Random random(test::seed() + std::uint64_t(run));
        std::vector<surfel::Surfel> points = wavySheet(random);
        const surface::Surface first = prepared(points);
        const std::size_t sheet = points.size();
        int strays = 0;
        for (std::size_t k = 200 + random.below(200); k < sheet; k += 200 + random.below(200)) { // each alone
            const Vec3d p = base::cast<double>(points[k].position), n = base::cast<double>(points[k].normal);
            const Vec3d aside = normalized(cross(n, random.unitVector()));
            const double turn = random.uniform(2.0, 3.1);
            if (std::max(std::abs(p.x), std::abs(p.y)) > 0.85)
                continue;
            points.push_back(pointAt(p + aside * 0.015 + n * random.uniform(-0.006, 0.006),
                                     n * std::cos(turn) + aside * std::sin(turn)));
            ++strays;
        }
        const std::size_t gone = dropped(prepared(points), first.tree());
        QVERIFY2(strays > 0 && gone == std::size_t(strays),
                 qPrintable(QString("%1 of %2, seed %3").arg(gone).arg(strays).arg(test::seed() + unsigned(run))));
    }
}

void FoldStraysTest::whatWasAStrayStays() {
    Random random(test::seed());
    std::vector<surfel::Surfel> points = wavySheet(random);
    for (std::size_t k = 150; k < 3000 && k < points.size(); k += 300)
        points.push_back(pointAt(base::cast<double>(points[k].position) + Vec3d{0.012, 0.01, 0},
                                 base::cast<double>(points[k].normal) * -1.0));
    const surface::Surface noisy = prepared(points);
    QCOMPARE(dropped(noisy, noisy.tree()), 0u);
}

/// As if all had come of a sheet.
void FoldStraysTest::thinThingsKeepEverySurfel() {
    for (int run = 0; run < test::effort(8); ++run) {
        Random random(test::seed() + std::uint64_t(run));
        const surface::Surface sheet = prepared(wavySheet(random));
        constexpr double s = 0.03;
        const auto lost = [&](const surface::Surface& thin) { return dropped(thin, sheet.tree()); };
        const auto told = [&](const char* what, std::size_t count) {
            return QString("%1 loses %2, seed %3").arg(what).arg(count).arg(test::seed() + unsigned(run));
        };
        const double thickness = s * random.uniform(0.2, 3);
        const std::size_t ofPlate = lost(test::randomPlate(random, {thickness, 1.2, 0.9}, s));
        QVERIFY2(ofPlate == 0, qPrintable(told("plate", ofPlate)));
        const std::size_t ofNeedle = lost(prepared(needle(random, random.uniform(0.06, 0.8))));
        QVERIFY2(ofNeedle == 0, qPrintable(told("needle", ofNeedle)));
        // one side several times as fine as the other
        std::vector<surfel::Surfel> lopsided;
        const double ratio = random.uniform(1, 4), gap = s * random.uniform(0.1, 2);
        for (const double side : {0.0, 1.0})
            for (double x = -0.6, step = side > 0 ? s : s * ratio; x < 0.6; x += step)
                for (double y = -0.6; y < 0.6; y += step)
                    lopsided.push_back(pointAt(
                        {x + random.uniform(-0.2, 0.2) * step, y + random.uniform(-0.2, 0.2) * step, side * gap},
                        {0, 0, 2 * side - 1}));
        const surface::Surface now = prepared(lopsided);
        const auto ofSide = [&](const surfel::SurfelBlock& block, int slot) {
            const float own = float(block.position(slot).z > float(gap) / 2 ? s : s * ratio);
            return CrumbSource{block.position(slot), own, own};
        };
        const std::size_t ofLopsided =
            now.tree().size() -
            now.tree().apply(dropCrumbs(now.tree(), sheet.tree(), process::selectAll(now.tree()), ofSide)).size();
        QVERIFY2(ofLopsided == 0, qPrintable(told("lopsided plate", ofLopsided)));
    }
}

static const test::Registered<FoldStraysTest> registered;
#include "fold_strays_test.moc"
