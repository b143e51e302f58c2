// Complexes in a session: made, opened, saved, moved, undone and recovered with every cell; what would break one is
// refused.
#include "core/complexes/complex_projection.h"
#include "journals.h"
#include "support/registry.h"
#include "workbench.h"

#include <QTest>

using nlohmann::json;
using test::Workbench;

class ComplexSessionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void savedComplexesOpenAsTheyWere();
    void journalsBringThemBack();
    void filesWithoutWhatCellsNeedAreRefused();
    void whatIsPrescribedMovesAlong();
    void whatWouldBreakThemIsRefused();
    void theSamePointsMayBeOneSurface();
};

static bool tells(const std::string& refusal, const char* word) {
    return refusal.find(word) != std::string::npos;
}

static json newComplex(const char* sample) {
    return {{"op", "new"}, {"sample", sample}, {"count", 1200}};
}

void ComplexSessionTest::savedComplexesOpenAsTheyWere() {
    for (const char* sample : {"octant", "cone"}) {
        Workbench bench, again;
        bench.run(newComplex(sample));
        bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
        again.run({{"op", "open"}, {"path", bench.path("a.ply").string()}});
        QCOMPARE(again.hash(), bench.hash());
        const auto &was = bench.document.surface().definition(), &is = again.document.surface().definition();
        QVERIFY(is.manifold == surface::Manifold::Complex);
        QVERIFY(*is.connectivity == *was.connectivity);
        QVERIFY(complexes::Complex::of(again.document.surface()));
    }
}

void ComplexSessionTest::journalsBringThemBack() {
    Workbench bench;
    session::Journal journal(bench.path("journal.jsonl"));
    bench.context.journal = &journal;
    bench.run(newComplex("cone"));
    bench.run({{"op", "transform"}, {"axis", {1, 2, 3}}, {"angle", 30}, {"move", {1, 0, 0}}});
    Workbench back;
    session::recover(bench.path("journal.jsonl"), back.context);
    QCOMPARE(back.hash(), bench.hash());
    QVERIFY(*back.document.surface().definition().connectivity == *bench.document.surface().definition().connectivity);
}

void ComplexSessionTest::filesWithoutWhatCellsNeedAreRefused() {
    Workbench bench;
    const std::string text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                             "property float z\nproperty int complex_cell\nelement complex_cell 3\n"
                             "property int dimension\nproperty list uchar int boundary\nend_header\n";
    const std::string points = "0 0 0 0\n1 0 0 1\n0.3 0 0 2\n0.6 0 0 2\n", cells = "0 0\n0 0\n1 2 0 1\n";
    bench.run({{"op", "open"}, {"path", test::write(bench.path("sound.ply"), text + points + cells).string()}});
    for (const char* wrong : {"0 0 0 0\n1 0 0 1\n0.3 0 0 1\n0.6 0 0 2\n", "0 0 0 0\n1 0 0 1\n0.3 0 0 2\n0.6 0 0 5\n"})
        QVERIFY(
            !bench.refusal({{"op", "open"}, {"path", test::write(bench.path("a.ply"), text + wrong + cells).string()}})
                 .empty());
}

void ComplexSessionTest::whatIsPrescribedMovesAlong() {
    Workbench bench;
    bench.run(newComplex("rounded"));
    const std::string before = bench.hash();
    bench.run({{"op", "transform"}, {"axis", {1, 2, 3}}, {"angle", 50}, {"scale", 2}});
    const auto complex = complexes::Complex::of(bench.document.surface());
    for (const surface::PrescribedTangent& each : complex->tangents()) {
        QVERIFY(std::abs(length(each.position) - 2) < 1e-5f);
        QVERIFY(base::distance(normalized(each.position), each.direction) < 1e-5f);
    }
    bench.document.undo();
    QCOMPARE(bench.hash(), before);
    QVERIFY(std::abs(length(complexes::Complex::of(bench.document.surface())->tangents()[0].position) - 1) < 1e-5f);
}

void ComplexSessionTest::whatWouldBreakThemIsRefused() {
    Workbench bench;
    bench.run(newComplex("octant"));
    const std::string before = bench.hash();
    const json ball{{"op", "select"}, {"by", "ball"}, {"at", {0, 0, 0}}, {"radius", 0.3}};
    for (const json& command : std::initializer_list<json>{test::strokeAt(0),
                                                           {{"op", "resample"}, {"spacing", 0.05}},
                                                           {{"op", "fill"}},
                                                           {{"op", "reduce"}, {"count", 200}}})
        QVERIFY2(tells(bench.refusal(command), "complex"), command.dump().c_str());
    bench.run(ball);
    const std::string selected = bench.hash();
    QVERIFY(tells(bench.refusal({{"op", "delete"}}), "complex")); // a corner would be gone
    QVERIFY(tells(bench.refusal({{"op", "transform"}, {"move", {1, 0, 0}}, {"of", "selection"}}), "complex"));
    QCOMPARE(bench.hash(), selected);
    QVERIFY(!before.empty());
}

void ComplexSessionTest::theSamePointsMayBeOneSurface() {
    Workbench bench;
    bench.run(newComplex("octant"));
    bench.run({{"op", "surface"}, {"manifold", "surface"}});
    QVERIFY(!complexes::Complex::of(bench.document.surface()));
    bench.run({{"op", "surface"}, {"manifold", "complex"}});
    QVERIFY(complexes::Complex::of(bench.document.surface()));
    Workbench other;
    other.run(test::newSphere(500));
    QVERIFY(tells(other.refusal({{"op", "surface"}, {"manifold", "complex"}}), "complex"));
}

static const test::Registered<ComplexSessionTest> registered;
#include "complex_session_test.moc"
