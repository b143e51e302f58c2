// The naive dabs move surfels to where the tools move them.
#include "app/bench/naive/naive_brush.h"

#include "app/bench/plain_dab.h"
#include "app/bench/scene.h"
#include "support/registry.h"

#include <QTest>

using bench::Scene;

class NaiveBrushTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void drawingIsTheTools();
    void smoothingIsTheTools();
};

using Way = void (*)(const bench::NaiveSurface&, const bench::NaiveDab&, std::vector<surfel::Surfel>&);

/// Part of the surfels under a brush that both bring to the same place, with the same normal.
static double sameShare(Scene& scene, const char* tool, Way way) {
    const surfel::Surfel at = scene.places(1)[0];
    const float radius = 8 * at.support;
    const sculpt::ToolRow& row = sculpt::tool(tool);
    const sculpt::Dab dab = bench::plainDab(row, at, radius);
    const tree::Edit edit = row.apply(scene.surface(), dab);
    const tree::SurfelTree ours = scene.surface().tree().apply(edit);
    std::vector<surfel::Surfel> moved;
    way(scene.naive(), {dab.centre, dab.areaNormal, dab.radius, dab.strength}, moved);
    std::vector<tree::Neighbour> found;
    std::size_t same = 0;
    for (const surfel::Surfel& s : moved) {
        ours.nearest(s.position, 1, found);
        const bool there = found[0].distanceSq < 1e-6f * s.support * s.support;
        same += there && length(found[0].block->normal(found[0].slot) - s.normal) < 1e-3f ? 1 : 0;
    }
    return moved.size() < 100 || edit.empty() ? 0 : static_cast<double>(same) / static_cast<double>(moved.size());
}

void NaiveBrushTest::drawingIsTheTools() {
    Scene scene({20000, 0.02});
    const double share = sameShare(scene, "draw", bench::naiveDraw);
    QVERIFY2(share == 1, qPrintable(QString::number(share)));
}

void NaiveBrushTest::smoothingIsTheTools() {
    Scene scene({20000, 0.02});
    const double share = sameShare(scene, "smooth", bench::naiveSmooth);
    QVERIFY2(share > 0.99, qPrintable(QString::number(share)));
}

static const test::Registered<NaiveBrushTest> registered;
#include "naive_brush_test.moc"
