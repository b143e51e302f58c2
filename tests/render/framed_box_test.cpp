// What a view frames: the model, not what stands far away from it.
#include "core/render/framed_box.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

class FramedBoxTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void evenModelsAreFramedWhole();
    void farOutliersAreLeftOut();
    void whatStandsNearBelongsToTheModel();
    void patchesFarAwayAreLeftOut();
    void aDotIsNoPicture();
    void thinPartsAreFramedWhole();
    void nothingIsFramedOfNothing();
};

/// Points of a unit ball, some surfels elsewhere.
static tree::SurfelTree ballAnd(std::size_t count, std::initializer_list<base::Vec3f> others) {
    base::Random random(test::seed());
    surfel::SurfelList list;
    surfel::Surfel s;
    s.support = 0.1f;
    for (std::size_t i = 0; i < count; ++i) {
        s.position = base::cast<float>(random.unitVector() * std::cbrt(random.uniform(0, 1)));
        list.items.push_back(s);
    }
    for (const base::Vec3f& p : others) {
        s.position = p;
        list.items.push_back(s);
    }
    return tree::SurfelTree::build(list);
}

void FramedBoxTest::evenModelsAreFramedWhole() {
    for (const std::size_t count : {1ul, 5ul, 300ul, 20000ul, 100000ul}) {
        const tree::SurfelTree tree = ballAnd(count, {});
        QVERIFY2(render::framedBox(tree) == tree.bounds(),
                 qPrintable(QString("%1, seed %2").arg(count).arg(test::seed())));
    }
}

void FramedBoxTest::farOutliersAreLeftOut() {
    for (const std::size_t count : {1000ul, 100000ul}) {
        const base::Box3f model = ballAnd(count, {}).bounds();
        QVERIFY(render::framedBox(ballAnd(count, {{100, 0, 0}})) == model);
        QVERIFY(render::framedBox(ballAnd(count, {{100, 0, 0}, {-3000, 20, 1}})) == model);
    }
}

void FramedBoxTest::whatStandsNearBelongsToTheModel() {
    const tree::SurfelTree tree = ballAnd(10000, {{1.12f, 0, 0}, {500, 0, 0}});
    QCOMPARE(render::framedBox(tree).hi.x, 1.12f);
}

/// Photographs give patches of false matches beside the scene, too near to be called far and too far to belong to it.
void FramedBoxTest::patchesFarAwayAreLeftOut() {
    for (const std::size_t count : {5000ul, 70000ul}) {
        const base::Box3f model = ballAnd(count, {}).bounds();
        base::Random random(test::seed() + 1);
        surfel::SurfelList list = ballAnd(count, {}).surfels();
        for (int patch = 0; patch < 4; ++patch) {
            const base::Vec3d centre = random.unitVector() * random.uniform(2.2, 6);
            for (std::size_t i = 0; i < count / 1200; ++i) {
                surfel::Surfel s;
                s.support = 0.1f;
                s.position = base::cast<float>(centre + random.unitVector() * 0.05);
                list.append(s, {});
            }
        }
        QVERIFY2(render::framedBox(tree::SurfelTree::build(list)) == model,
                 qPrintable(QString("%1, seed %2").arg(count).arg(test::seed())));
    }
}

/// Patches of false matches so far away that the rest would be a dot count up to three percent of the surfels; nearer
/// ones are part of what there is to see.
void FramedBoxTest::aDotIsNoPicture() {
    constexpr std::size_t count = 6000, patches = 5;
    for (const double away : {4.0, 15.0, 100.0}) {
        base::Random random(test::seed() + 2);
        surfel::SurfelList list = ballAnd(count, {}).surfels();
        const base::Box3f model = ballAnd(count, {}).bounds();
        for (std::size_t patch = 0; patch < patches; ++patch) {
            const base::Vec3d centre = random.unitVector() * random.uniform(0.8 * away, 1.5 * away);
            for (std::size_t i = 0; i < count / 200; ++i) { // of half a percent
                surfel::Surfel s;
                s.support = 0.1f;
                s.position = base::cast<float>(centre + random.unitVector() * 0.02 * away);
                list.append(s, {});
            }
        }
        const auto tree = tree::SurfelTree::build(list);
        QVERIFY2(render::framedBox(tree) == (away > 10 ? model : tree.bounds()),
                 qPrintable(QString("%1 away, seed %2").arg(away).arg(test::seed())));
    }
}

/// A mast of 40 surfels of 50,000: few, but they hang together with the rest.
void FramedBoxTest::thinPartsAreFramedWhole() {
    surfel::SurfelList list = ballAnd(50000, {}).surfels();
    for (int i = 0; i < 40; ++i) {
        surfel::Surfel s;
        s.support = 0.1f;
        s.position = {0, 1 + 0.1f * static_cast<float>(i + 1), 0};
        list.append(s, {});
    }
    QCOMPARE(render::framedBox(tree::SurfelTree::build(list)).hi.y, 5.0f);
}

void FramedBoxTest::nothingIsFramedOfNothing() {
    QVERIFY(render::framedBox({}).empty());
}

static const test::Registered<FramedBoxTest> registered;
#include "framed_box_test.moc"
