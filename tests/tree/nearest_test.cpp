#include "support/registry.h"
#include "tree/random_edits.h"

#include <QTest>

using namespace tree;

class NearestTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void distancesAreThoseOfBruteForce();
    void equalDistancesComeByBlockAndSlot();
    void nothingBeyondMaxDistance();
    void fewerThanAskedForWhenTheTreeHasFewer();
};

struct Plain {
    float distanceSq;
    std::uint32_t block;
    int slot;
    auto operator<=>(const Plain&) const = default;
};

static std::vector<Plain> bruteForce(const SurfelTree& tree, const base::Vec3f& x, std::size_t k, float maxDistance) {
    std::vector<Plain> out;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const float distanceSq = base::distanceSq(block.position(slot), x);
            if (distanceSq < maxDistance * maxDistance)
                out.push_back({distanceSq, number, slot});
        }
    });
    std::sort(out.begin(), out.end());
    out.resize(std::min(out.size(), k));
    return out;
}

static bool agrees(const SurfelTree& tree, const base::Vec3f& x, std::size_t k,
                   float maxDistance = std::numeric_limits<float>::infinity()) {
    std::vector<Neighbour> found{Neighbour{}}; // what stood there before must go
    tree.nearest(x, k, found, maxDistance);
    std::vector<Plain> plain;
    for (const Neighbour& n : found) {
        if (tree.block(n.blockNumber).get() != n.block)
            return false;
        plain.push_back({n.distanceSq, n.blockNumber, n.slot});
    }
    return plain == bruteForce(tree, x, k, maxDistance);
}

void NearestTest::distancesAreThoseOfBruteForce() {
    test::EditedModel model(6000, test::seed());
    for (int round = 0; round < 150; ++round) {
        const base::Vec3d u = model.random().unitVector();
        for (const double radius : {0.0, 0.5, 1.0, 1.3, 100.0})
            for (const std::size_t k : {1, 7, 60})
                QVERIFY2(agrees(model.tree(), base::cast<float>(u * radius), k),
                         qPrintable(QString("round %1, seed %2").arg(round).arg(test::seed())));
        model.apply(model.randomEdit());
    }
}

void NearestTest::equalDistancesComeByBlockAndSlot() {
    surfel::SurfelList list;
    for (int i = 0; i < 3000; ++i) {
        surfel::Surfel s;
        s.position = {static_cast<float>(i % 10), static_cast<float>(i / 10 % 10), static_cast<float>(i / 1000)};
        s.support = 1;
        list.items.push_back(s);
    }
    const SurfelTree tree = SurfelTree::build(list);
    for (const base::Vec3f& x : {base::Vec3f{5, 5, 1}, base::Vec3f{4.5f, 4.5f, 0.5f}, base::Vec3f{-1, 20, 0}})
        for (const std::size_t k : {1, 4, 33, 1000})
            QVERIFY(agrees(tree, x, k));
}

void NearestTest::nothingBeyondMaxDistance() {
    base::Random random(test::seed());
    const SurfelTree tree = SurfelTree::build(test::bumpySphere(3000, random));
    for (int round = 0; round < 200; ++round) {
        const base::Vec3f x = base::cast<float>(random.unitVector());
        QVERIFY(agrees(tree, x, 50, static_cast<float>(random.uniform(0, 0.1))));
    }
    // A surfel at exactly the distance is not closer.
    const surfel::BlockPtr block = tree.block(0);
    const base::Vec3f x = block->position(0);
    std::vector<Neighbour> found;
    tree.nearest(x, 1, found, 0.0f);
    QVERIFY(found.empty());
}

void NearestTest::fewerThanAskedForWhenTheTreeHasFewer() {
    base::Random random(test::seed());
    const SurfelTree tree = SurfelTree::build(test::bumpySphere(50, random));
    std::vector<Neighbour> found;
    tree.nearest({}, 80, found);
    QCOMPARE(found.size(), std::size_t(50));
    tree.nearest({}, 0, found);
    QVERIFY(found.empty());
    SurfelTree().nearest({}, 5, found);
    QVERIFY(found.empty());
}

static const test::Registered<NearestTest> registered;
#include "nearest_test.moc"
