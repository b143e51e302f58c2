// Bridges between boundary loops as commands: one step, replayed to the same bits, refused in a sentence.
#include "core/base/random.h"
#include "core/mesh/extent/extent.h"
#include "support/registry.h"
#include "support/threads.h"
#include "workbench.h"

#include <numbers>
#include <QTest>

using test::json;
using test::Workbench;

class BridgeCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aBridgeIsAStepThatUndoAndReplayBringBack();
    void whatIsDeletedOfClosedMeshesLeavesRims();
    void wrongLoopsAreRefused();
};

namespace {

/// A torus without two pieces: two tubes with four loops.
void openTorus(Workbench& bench) {
    bench.run({{"op", "new"}, {"sample", "torus"}, {"count", 5000}});
    bench.run({{"op", "select"}, {"by", "box"}, {"least", {0, -9, -0.25}}, {"most", {9, 9, 0.25}}});
    bench.run({{"op", "delete"}});
}

} // namespace

void BridgeCommandTest::aBridgeIsAStepThatUndoAndReplayBringBack() {
    const auto made = [](Workbench& bench) {
        session::Journal journal(bench.path("j.jsonl"));
        bench.context.journal = &journal;
        openTorus(bench);
        const std::string before = bench.hash();
        bench.run({{"op", "bridge"}});
        bench.document.surface().tree().validate();
        const std::string after = bench.hash();
        bench.run({{"op", "undo"}});
        const bool back = bench.hash() == before;
        bench.run({{"op", "redo"}});
        bench.context.journal = nullptr;
        return back && bench.hash() == after ? after : std::string();
    };
    Workbench one, two, again;
    const std::string hash = test::onThreads(1, [&] { return made(one); });
    QVERIFY(!hash.empty());
    QCOMPARE(test::onThreads(2, [&] { return made(two); }), hash);
    session::recover(one.path("j.jsonl"), again.context);
    QCOMPARE(again.hash(), hash);
    Workbench whole;
    whole.run({{"op", "new"}, {"sample", "torus"}, {"count", 5000}});
    const mesh::Extent is = mesh::extentOf(one.document.surface()), was = mesh::extentOf(whole.document.surface());
    QVERIFY(is.closed);
    QVERIFY2(std::abs(is.volume / was.volume - 1) < 0.005, QByteArray::number(is.volume / was.volume));
}

void BridgeCommandTest::whatIsDeletedOfClosedMeshesLeavesRims() {
    Workbench bench;
    bench.run(test::newSphere(3000));
    bench.run({{"op", "surface"}, {"boundary", "none"}}); // as closed meshes have it
    bench.run({{"op", "select"}, {"by", "plane"}, {"plane", {0, 0, 1, 0.5}}});
    bench.run({{"op", "delete"}});
    QVERIFY(std::isfinite(bench.document.surface().definition().boundaryLimit));
    QVERIFY(!mesh::extentOf(bench.document.surface()).closed);
}

void BridgeCommandTest::wrongLoopsAreRefused() {
    Workbench bench;
    QVERIFY(bench.refusal({{"op", "bridge"}}).find("no model") != std::string::npos);
    bench.run(test::newSphere(2000));
    QVERIFY(bench.refusal({{"op", "bridge"}}).find("no boundary") != std::string::npos);
    openTorus(bench);
    QVERIFY(bench.refusal({{"op", "bridge"}, {"loops", "0,5"}}).find("number 5") != std::string::npos);
    QVERIFY(bench.refusal({{"op", "bridge"}, {"loops", "0,0.5"}}).find("no numbers of") != std::string::npos);
    QVERIFY(bench.refusal({{"op", "bridge"}, {"loops", "0"}}).find("loops") != std::string::npos);
}

static const test::Registered<BridgeCommandTest> registered;
#include "bridge_command_test.moc"
