// Strokes against the deformation that they mean (sculpt/README 7): how far off the result lies, how even its
// sampling is, how much one resampling changes, and that nothing else changes.
#include "sculpt/ideal_dabs.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using base::Vec3f;

class IdealStrokeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void strokesGoWhereTheyMeanTo_data();
    void strokesGoWhereTheyMeanTo();
};

namespace {

constexpr std::size_t count = 12000;
/// Radius of the brushes, in spacings.
constexpr float brush = 10;

float radius() {
    return brush * float(test::sphereSpacing(count));
}

Vec3f towards(double angle, double across) {
    return base::cast<float>(
        Vec3d{std::sin(angle) * std::cos(across), std::sin(across), std::cos(angle) * std::cos(across)});
}

/// A horn, pulled out along z in steps of a twentieth of the radius.
void hook(test::IdealStroke& stroke, float radii) {
    const Vec3f step{0, 0, 0.05f * radius()};
    Vec3f centre{0, 0, 1};
    for (int k = 0; k < int(20 * radii + 0.5f); ++k, centre += step)
        stroke.pull("snake-hook", centre, step, radius(), 0.5f);
}

/// To and fro, four times.
void ridge(test::IdealStroke& stroke) {
    for (int pass = 0; pass < 4; ++pass)
        for (int k = 0; k <= 24; ++k)
            stroke.draw(towards((pass % 2 ? 1 : -1) * (0.48 - 0.04 * k), 0), radius(), 1);
}

/// Pulls out and in by half a spacing to a spacing, anywhere.
void scatter(test::IdealStroke& stroke) {
    base::Random random(test::seed());
    for (int k = 0; k < 300; ++k) {
        const Vec3f to = base::cast<float>(random.unitVector());
        const auto at = sculpt::contact(stroke.surface(), {to * 4.0f, -to});
        const float way = float(random.uniform(0.5, 1)) * stroke.spacing() * (random.uniform() < 0.5 ? -1.0f : 1.0f);
        if (at)
            stroke.pull("grab", at->position, at->normal * way, radius(), 0.25f);
    }
}

struct Found {
    double rms = 0, worst = 0;
    std::size_t least = 1000, holes = 0, asked = 0;
};

/// Random points of the surface within the brushes: off the ideal, surfels in support, holes.
Found look(const test::IdealStroke& stroke, int points) {
    base::Random random(test::seed() + 7);
    const auto items = stroke.surface().tree().surfels().items;
    Found out;
    double sum = 0;
    while (int(out.asked) < points) {
        const surfel::Surfel& near = items[random.below(items.size())];
        if (!stroke.touched(near.position, 0))
            continue;
        const Vec3d aside = random.unitVector() * (0.7 * double(stroke.spacing()));
        const auto foot = surface::project(stroke.surface(), near.position + base::cast<float>(aside), {});
        ++out.asked;
        if (!foot.ok()) {
            ++out.holes;
            continue;
        }
        out.least = std::min(out.least, std::size_t(foot.at.samples));
        const double off = std::abs(stroke.off(foot.foot));
        sum += off * off, out.worst = std::max(out.worst, off);
    }
    out.rms = std::sqrt(sum / double(out.asked - out.holes));
    return out;
}

} // namespace

void IdealStrokeTest::strokesGoWhereTheyMeanTo_data() {
    QTest::addColumn<QString>("kind");
    for (const char* kind : {"hook 5 R", "hook 10 R", "ridge", "scatter"})
        QTest::newRow(kind) << kind;
}

void IdealStrokeTest::strokesGoWhereTheyMeanTo() {
    QFETCH(QString, kind);
    test::IdealStroke stroke(count, {0, 0, 1});
    if (kind.startsWith("hook"))
        hook(stroke, kind.endsWith("10 R") ? 10 : 5);
    else if (kind == "ridge")
        ridge(stroke);
    else
        scatter(stroke);
    stroke.finish();
    stroke.surface().tree().validate();

    const Found found = look(stroke, 600);
    const process::Summary spacing = test::spacingOfSheets(stroke.surface(), double(stroke.spacing()));
    const QString told = QString("%1: off %2 rms, %3 at most; spacing %4 to %5; %6 surfels in support at least; "
                                 "resampled %7 times, pop %8; %9 -> %10 surfels; seed %11")
                             .arg(kind)
                             .arg(found.rms)
                             .arg(found.worst)
                             .arg(spacing.min)
                             .arg(spacing.max)
                             .arg(found.least)
                             .arg(stroke.resamplings())
                             .arg(stroke.pop())
                             .arg(stroke.start().tree().size())
                             .arg(stroke.surface().tree().size())
                             .arg(test::seed());
    qInfo("%s", qPrintable(told));
    QVERIFY2(found.rms < 0.06, qPrintable(told));
    QVERIFY2(found.holes == 0 && found.least >= 6, qPrintable(told));
    QVERIFY2(spacing.min >= 0.6f && spacing.max <= 1.6f, qPrintable(told));
    QVERIFY2(stroke.pop() < 0.06, qPrintable(told));
    QVERIFY2(stroke.resamplings() >= 1, qPrintable(told));
    // What no brush reached has its bits.
    for (const surfel::Surfel& gone : test::without(stroke.start(), stroke.surface()))
        QVERIFY2(stroke.touched(gone.position, 1e-5), qPrintable(told));
}

static const test::Registered<IdealStrokeTest> registered;
#include "ideal_stroke_test.moc"
