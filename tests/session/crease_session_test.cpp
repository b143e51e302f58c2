// A model with creases in a session: strokes over its edges, undo and redo, the journal, saving and opening keep every
// bit, labels and all.
#include "core/base/parallel.h"
#include "core/cells/labels.h"
#include "journals.h"
#include "layered.h"
#include "random_strokes.h"
#include "support/registry.h"
#include "workbench.h"

#include <QTest>

using nlohmann::json;
using test::recovered;
using test::Workbench;

class CreaseSessionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void undoAndRedoComeBack();
    void journalsBringCreasesBack();
    void savedModelsGoOnAsIfTheyHadStayedOpen();
    void strengthsOfLayersLeaveNoTraceOnCreases();
    void edgesOfALayerTurnOverWithIt();
    void cleanup() { base::setThreadCount(0); }
};

/// A box of 2 by 1 by 1.5 with a groove across its top, as faces.
static json grooved(Workbench& bench, int count) {
    const std::string faces = "v 0 0 0\nv 2 0 0\nv 2 0 1.5\nv 1.2 0 1.5\nv 1.2 0 1\nv 0.8 0 1\nv 0.8 0 1.5\nv 0 0 1.5\n"
                              "v 0 1 0\nv 2 1 0\nv 2 1 1.5\nv 1.2 1 1.5\nv 1.2 1 1\nv 0.8 1 1\nv 0.8 1 1.5\nv 0 1 1.5\n"
                              "f 1 2 5 6\nf 2 3 4 5\nf 1 6 7 8\nf 9 14 13 10\nf 10 13 12 11\nf 9 16 15 14\n"
                              "f 1 9 10 2\nf 2 10 11 3\nf 3 11 12 4\nf 4 12 13 5\nf 5 13 14 6\nf 6 14 15 7\n"
                              "f 7 15 16 8\nf 8 16 9 1\n";
    return {{"op", "open"},
            {"path", test::write(bench.path("box.obj"), faces).string()},
            {"faces", "sample"},
            {"sample_count", count},
            {"creases", true}};
}

static bool hasCells(const Workbench& bench) {
    return cells::LabelLayout::of(*bench.document.surface().tree().layout()).has_value();
}

/// What is refused is refused again.
static void strokesOn(Workbench& bench, int count, base::Random random) {
    test::RandomStrokes strokes(bench.document, random);
    for (int k = 0; k < count; ++k)
        static_cast<void>(bench.refusal(strokes.next()));
}

void CreaseSessionTest::undoAndRedoComeBack() {
    Workbench bench;
    bench.run(grooved(bench, test::effort(5000)));
    QVERIFY(hasCells(bench));
    std::vector<std::string> hashes{bench.hash()};
    base::Random random(test::seed());
    test::RandomStrokes strokes(bench.document, random);
    for (int k = 0; k < 6; ++k) {
        static_cast<void>(bench.refusal(strokes.next()));
        if (bench.hash() != hashes.back())
            hashes.push_back(bench.hash());
    }
    QVERIFY(hashes.size() > 2 && hasCells(bench));
    for (std::size_t k = hashes.size() - 1; k-- > 0;) {
        bench.run({{"op", "undo"}});
        QCOMPARE(bench.hash(), hashes[k]);
    }
    for (std::size_t k = 1; k < hashes.size(); ++k) {
        bench.run({{"op", "redo"}});
        QCOMPARE(bench.hash(), hashes[k]);
    }
}

void CreaseSessionTest::journalsBringCreasesBack() {
    Workbench bench;
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run(grooved(bench, test::effort(5000)));
    strokesOn(bench, 4, base::Random(test::seed() + 1));
    for (const int threads : {1, 2}) {
        base::setThreadCount(threads);
        QCOMPARE(recovered(journal.path()), bench.hash());
    }
}

void CreaseSessionTest::savedModelsGoOnAsIfTheyHadStayedOpen() {
    base::Random random(test::seed() + 2);
    Workbench stays;
    stays.run(grooved(stays, test::effort(5000)));
    strokesOn(stays, 4, base::Random(random.next()));
    const auto saved = stays.path("saved.ply");
    stays.run({{"op", "save"}, {"path", saved.string()}});
    const base::Random later(random.next());
    Workbench opens;
    opens.run({{"op", "open"}, {"path", saved.string()}});
    QVERIFY(hasCells(opens));
    QCOMPARE(opens.hash(), stays.hash());
    strokesOn(stays, 4, later);
    strokesOn(opens, 4, later);
    QVERIFY2(opens.hash() == stays.hash(), qPrintable(QString("seed %1").arg(test::seed())));
}

void CreaseSessionTest::strengthsOfLayersLeaveNoTraceOnCreases() {
    Workbench bench;
    bench.run(grooved(bench, test::effort(5000)));
    bench.run(test::layered::layer("add"));
    base::Random random(test::seed());
    strokesOn(bench, 4, random);
    const std::string before = bench.hash();
    for (const double strength : {0.0, random.uniform() * 2, 1.0})
        bench.run(test::layered::strength(strength));
    QVERIFY2(bench.hash() == before, qPrintable(QString("seed %1").arg(test::seed())));
}

/// How many surfels have a partner that they meet so.
static std::size_t meeting(const Workbench& bench, cells::Meeting how) {
    const auto labels = cells::LabelLayout::of(*bench.document.surface().tree().layout());
    std::size_t out = 0;
    bench.document.surface().tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            out += labels && labels->at(block, slot).meeting == how ? 1 : 0;
    });
    return out;
}

/// A ridge that a layer raises: flat without it, a furrow where it is shown the other way.
void CreaseSessionTest::edgesOfALayerTurnOverWithIt() {
    using cells::Meeting;
    Workbench bench;
    bench.run(test::newSphere(20000));
    bench.run(test::layered::layer("add"));
    for (int k = 0; k < 3; ++k)
        bench.run(test::strokeAt(0.05, "crease"));
    bench.run({{"op", "crease"}, {"detect", true}});
    const std::size_t concave = meeting(bench, Meeting::Concave), convex = meeting(bench, Meeting::Convex);
    QVERIFY(concave + convex > 50);
    for (const double strength : {0.0, -1.0, 1.0}) {
        bench.run(test::layered::strength(strength));
        const std::size_t now = meeting(bench, Meeting::Concave);
        QCOMPARE(now + meeting(bench, Meeting::Convex), concave + convex);
        QVERIFY2(strength > -1 || now > concave, qPrintable(QString::number(now)));
    }
}

static const test::Registered<CreaseSessionTest> registered;
#include "crease_session_test.moc"
