// Sculpting on a surface without two sides: no seam, nothing inside out.
#include "core/base/random.h"
#include "core/session/commands/commands.h"
#include "core/session/document.h"
#include "core/surface/projection/project.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <QFloat16>
#include <QTest>

using nlohmann::json;

class MoebiusStrokeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void strokesAllTheWayRoundLeaveNoSeam_data();
    void strokesAllTheWayRoundLeaveNoSeam();
};

/// Rays from above along the strip, to which it shows itself for most of the way round.
static json round() {
    json out = json::array();
    for (int k = 0; k <= 120; ++k) {
        const double angle = 2 * std::numbers::pi * (k / 120.0 - 0.5) * 0.85;
        const base::Vec3d eye{0, 3.5, 0}, at{0.85 * std::cos(angle), 0, 0.85 * std::sin(angle)};
        const base::Vec3d d = base::normalized(at - eye);
        out.push_back({eye.x, eye.y, eye.z, d.x, d.y, d.z, 1, 0.01 * k});
    }
    return out;
}

void MoebiusStrokeTest::strokesAllTheWayRoundLeaveNoSeam_data() {
    QTest::addColumn<QString>("tool");
    for (const char* tool : {"draw", "grab"})
        QTest::newRow(tool) << tool;
    if (!test::sanitized)
        for (const char* tool : {"smooth", "inflate", "flatten", "clay"})
            QTest::newRow(tool) << tool;
}

void MoebiusStrokeTest::strokesAllTheWayRoundLeaveNoSeam() {
    QFETCH(QString, tool);
    session::Document document;
    session::Context context{document, {}, {}, {}, 0, {}, nullptr};
    session::run(context, {{"op", "new"}, {"sample", "moebius"}, {"count", 12000}});
    QVERIFY(!document.surface().tree().layout()->oriented);
    const base::Hash128 before = document.hash();
    json samples = round();
    if (tool == "grab")
        samples.erase(samples.begin() + 12, samples.end()); // a pull, not a tour
    session::run(context, {{"op", "stroke"}, {"tool", tool.toStdString()}, {"radius", 0.15}, {"samples", samples}});
    const surface::Surface after = document.surface();
    QVERIFY(!after.tree().layout()->oriented);
    QVERIFY(!(document.hash() == before));

    base::Random random(test::seed());
    const auto items = after.tree().surfels().items;
    int turned = 0;
    for (int k = 0; k < 4000; ++k) {
        const surfel::Surfel& near = items[random.below(items.size())];
        const base::Vec3d aside = random.unitVector() * (0.25 * double(near.support) * random.uniform());
        const auto foot = surface::project(after, near.position + base::cast<float>(aside), {});
        if (foot.status == surface::Status::BeyondBoundary)
            continue;
        QVERIFY2(foot.ok() && foot.at.samples >= 6, surface::statusName(foot.status));
        turned += std::abs(dot(foot.at.normal, near.normal)) < 0.7f;
    }
    QVERIFY2(turned <= 4, qPrintable(QString("%1 of 4000").arg(turned)));
    session::run(context, {{"op", "undo"}});
    QVERIFY(document.hash() == before);
}

static const test::Registered<MoebiusStrokeTest> registered;
#include "moebius_stroke_test.moc"
