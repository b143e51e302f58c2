// The tool morph: a layer stores the shape, and strokes bring the surface back to it, whatever was done meanwhile.
#include "layered.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using base::Vec3d, base::Vec3f;
using test::Workbench, test::json;
using namespace test::layered;

class MorphTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theStoredShapeComesBackUnderTheBrush();
    void itComesBackAlsoWhereItWasResampled();
    void onlyTheActiveLayerGoesBack();
    void invertedItGoesOn();
    void masksProtectWhatIsThere();
    void itIsAStepThatUndoAndReplayBringBack();
    void filesKeepTheStoredShape();
    void withoutOneItIsRefused();
};

namespace {

/// Pressures are below 1, so that each dab leaves a little.
constexpr double near = 1e-5;

/// Wider than the strokes of `stroke`, and full.
json back(double y = 0, bool resample = false, bool invert = false) {
    json out = stroke("morph", y, resample, 0.6);
    out["strength"] = 1;
    out["falloff"] = "constant";
    out["invert"] = invert;
    return out;
}

void makeRidge(Workbench& bench, bool resample = false) {
    bench.run(test::newSphere());
    bench.run(layer("add"));
    for (const char* tool : {"draw", "clay"})
        bench.run(stroke(tool, 0, resample));
}

} // namespace

void MorphTest::theStoredShapeComesBackUnderTheBrush() {
    Workbench bench;
    makeRidge(bench);
    QVERIFY(offSphere(surfels(bench)) > 0.02);
    bench.run(back());
    QVERIFY(isWhole(bench));
    const surfel::SurfelList now = surfels(bench);
    QVERIFY2(offSphere(now) < near, QByteArray::number(offSphere(now)));
    for (const surfel::Surfel& each : now.items)
        QVERIFY(dot(each.normal, each.position) > 0.9999F);
    // in parts, and where the brush went alone
    Workbench other;
    makeRidge(other);
    const surfel::SurfelList ridge = surfels(other);
    json half = back();
    half["strength"] = 0.05, half["radius"] = 0.15;
    other.run(half);
    const double left = offSphere(surfels(other));
    QVERIFY2(left < offSphere(ridge) * 0.999 && left > 0.01, QByteArray::number(left));
    for (std::size_t i = 0; i < ridge.size(); ++i)
        QVERIFY(ridge.items[i].position.z > 0 || ridge.items[i] == surfels(other).items[i]);
}

/// To what the layer shows at strength 0: as near as what layers hold is carried.
void MorphTest::itComesBackAlsoWhereItWasResampled() {
    Workbench bench, other;
    for (Workbench* each : {&bench, &other}) {
        makeRidge(*each, true);
        each->run({{"op", "resample"}, {"count", 4000}});
    }
    bench.run(back());
    other.run(strength(0));
    QVERIFY2(farthest(surfels(bench), surfels(other)) < near,
             QByteArray::number(farthest(surfels(bench), surfels(other))));
    Workbench third;
    makeRidge(third, true);
    const double ridge = offSphere(surfels(third));
    third.run(back(0, true));
    QVERIFY(isWhole(third));
    const double left = offSphere(surfels(third));
    QVERIFY2(left < 0.2 * spacing(third) && left < 0.1 * ridge, QByteArray::number(left / spacing(third)));
}

void MorphTest::onlyTheActiveLayerGoesBack() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(layer("add", {{"name", "a"}}));
    bench.run(stroke("draw", 0, false));
    const surfel::SurfelList first = surfels(bench);
    bench.run(layer("add", {{"name", "b"}}));
    bench.run(stroke("inflate", 0.1, false));
    QVERIFY(farthest(first, surfels(bench)) > 0.01);
    bench.run(back());
    QVERIFY2(farthest(first, surfels(bench)) < near, QByteArray::number(farthest(first, surfels(bench))));
}

void MorphTest::invertedItGoesOn() {
    Workbench bench;
    makeRidge(bench);
    const double before = offSphere(surfels(bench));
    json away = back(0, false, true);
    away["strength"] = 0.2;
    bench.run(away);
    QVERIFY(offSphere(surfels(bench)) > 1.05 * before);
}

void MorphTest::masksProtectWhatIsThere() {
    Workbench bench;
    makeRidge(bench);
    bench.run({{"op", "mask"}, {"do", "invert"}});
    const std::string before = bench.hash();
    bench.run(back());
    QCOMPARE(bench.hash(), before);
}

void MorphTest::itIsAStepThatUndoAndReplayBringBack() {
    for (const bool resample : {false, true}) {
        Workbench one;
        QVERIFY(!test::hashOfStep(
                     one, [&](Workbench& bench) { makeRidge(bench, resample); }, back(0.1, resample))
                     .empty());
    }
}

void MorphTest::filesKeepTheStoredShape() {
    Workbench bench, other;
    makeRidge(bench, true);
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    other.run({{"op", "open"}, {"path", bench.path("a.ply").string()}});
    for (Workbench* each : {&bench, &other})
        each->run(back(0, true));
    QCOMPARE(other.hash(), bench.hash());
}

void MorphTest::withoutOneItIsRefused() {
    Workbench bench;
    bench.run(test::newSphere());
    QVERIFY(bench.refusal(back()).find("no stored shape") != std::string::npos);
    bench.run(layer("add"));
    bench.run(stroke("draw", 0, false));
    bench.run(layer("base"));
    QVERIFY(bench.refusal(back()).find("make the layer the active one") != std::string::npos);
}

static const test::Registered<MorphTest> registered;
#include "morph_test.moc"
