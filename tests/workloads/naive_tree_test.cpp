// The naive index has every surfel, and the same edit leaves the same points.
#include "app/bench/naive/naive_tree.h"

#include "support/registry.h"

#include <QTest>

using bench::BrushEdit;
using bench::Scene;

class NaiveTreeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everySurfelIsIndexed();
    void editsLeaveTheSamePoints();
};

void NaiveTreeTest::everySurfelIsIndexed() {
    Scene scene({3000, 0.02});
    QCOMPARE(bench::naiveBuild(scene.unsorted().items), scene.size());
    QCOMPARE(tree::SurfelTree::build(scene.unsorted()).size(), scene.size());
}

void NaiveTreeTest::editsLeaveTheSamePoints() {
    Scene scene({5000, 0.02});
    std::vector<BrushEdit> edits;
    const std::vector<surfel::Surfel> places = scene.places(3);
    for (const surfel::Surfel& place : places)
        edits.push_back(bench::brushEdit(scene.surface().tree(), place, edits.size()));
    bench::NaiveEdits naive(scene.unsorted().items, std::span(edits).first(1));
    naive.next();
    const tree::SurfelTree ours = scene.surface().tree().apply(edits[0].edit);
    std::vector<tree::Neighbour> found;
    for (const surfel::Surfel& place : places) {
        const std::vector<float> distances = naive.nearest(place.position, 300);
        ours.nearest(place.position, 300, found);
        QCOMPARE(distances.size(), found.size());
        for (std::size_t i = 0; i < found.size(); ++i)
            QVERIFY(std::abs(distances[i] - found[i].distanceSq) <= 1e-5f * found[i].distanceSq + 1e-12f);
    }
    QVERIFY(naive.nearest(places[0].position, 300) !=
            bench::NaiveEdits(scene.unsorted().items, edits).nearest(places[0].position, 300));
}

static const test::Registered<NaiveTreeTest> registered;
#include "naive_tree_test.moc"
