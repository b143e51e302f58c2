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
    Workbench one;
    QVERIFY(!test::hashOfStep(one, openTorus, {{"op", "bridge"}}).empty());
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
