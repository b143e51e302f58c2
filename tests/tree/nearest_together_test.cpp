// Neighbours of many positions at once are those that the tree tells of each alone.
#include "core/tree/nearest_together.h"
#include "support/registry.h"
#include "tree/random_edits.h"

#include <QTest>

using namespace tree;

class NearestTogetherTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void answersAreThoseOfTheTreeClusterAfterCluster();
    void answersAreThoseOfTheTreeAfterAnyJump();
    void equalDistancesComeByBlockAndSlot();
    void pilesOutliersAndSuddenDensitiesChangeNoAnswer();
    void smallAndEmptyTreesAnswerWithWhatTheyHave();
};

static bool same(std::span<const Neighbour> a, std::span<const Neighbour> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Neighbour& x, const Neighbour& y) {
        return x.block == y.block && x.blockNumber == y.blockNumber && x.slot == y.slot && x.distanceSq == y.distanceSq;
    });
}

/// Asks for 1, 2, 3 ... 16, 1 ... places at once.
static bool agreeAt(const SurfelTree& tree, std::span<const base::Vec3f> places, std::size_t k) {
    NearestTogether around(tree, k);
    std::vector<Neighbour> expected;
    for (std::size_t count = 1; !places.empty(); count = count % NearestTogether::most + 1) {
        const auto some = places.first(std::min(count, places.size()));
        around.at(some);
        for (std::size_t i = 0; i < some.size(); ++i) {
            tree.nearest(some[i], k, expected);
            if (!same(around.of(i), expected))
                return false;
        }
        places = places.subspan(some.size());
    }
    return true;
}

static std::vector<base::Vec3f> positionsOf(const SurfelTree& tree) {
    std::vector<base::Vec3f> out;
    for (const surfel::Surfel& s : tree.surfels().items)
        out.push_back(s.position);
    return out;
}

static surfel::SurfelList listOf(std::span<const base::Vec3f> places) {
    surfel::SurfelList list;
    for (const base::Vec3f& p : places) {
        surfel::Surfel s;
        s.position = p;
        s.support = 1;
        list.items.push_back(s);
    }
    return list;
}

void NearestTogetherTest::answersAreThoseOfTheTreeClusterAfterCluster() {
    test::EditedModel model(4000, test::seed());
    for (int round = 0; round < 6; ++round) {
        for (const std::size_t k : {1, 7, 14, 32, 60})
            QVERIFY2(agreeAt(model.tree(), positionsOf(model.tree()), k),
                     qPrintable(QString("round %1, k %2, seed %3").arg(round).arg(k).arg(test::seed())));
        for (int edit = 0; edit < 20; ++edit)
            model.apply(model.randomEdit());
    }
}

void NearestTogetherTest::answersAreThoseOfTheTreeAfterAnyJump() {
    base::Random random(test::seed());
    const SurfelTree tree = SurfelTree::build(test::bumpySphere(6000, random));
    std::vector<base::Vec3f> places;
    for (int i = 0; i < 4000; ++i) {
        const bool jumps = places.empty() || random.uniform(0, 1) < 0.1;
        const base::Vec3f from = jumps ? base::cast<float>(random.unitVector() * random.uniform(0, 2)) : places.back();
        const double step = std::pow(10.0, random.uniform(-6, 0));
        places.push_back(from + base::cast<float>(random.unitVector() * step));
    }
    for (const std::size_t k : {1, 14, 32})
        QVERIFY2(agreeAt(tree, places, k), qPrintable(QString("k %1, seed %2").arg(k).arg(test::seed())));
}

void NearestTogetherTest::equalDistancesComeByBlockAndSlot() {
    std::vector<base::Vec3f> lattice;
    for (int i = 0; i < 3000; ++i)
        lattice.push_back({static_cast<float>(i % 15), static_cast<float>(i / 15 % 20), static_cast<float>(i / 300)});
    const SurfelTree tree = SurfelTree::build(listOf(lattice));
    for (const std::size_t k : {1, 4, 7, 14, 27})
        QVERIFY(agreeAt(tree, positionsOf(tree), k));
}

void NearestTogetherTest::pilesOutliersAndSuddenDensitiesChangeNoAnswer() {
    base::Random random(test::seed());
    std::vector<base::Vec3f> places;
    const auto inBall = [&](const base::Vec3f& centre, double radius, int count) {
        for (int i = 0; i < count; ++i)
            places.push_back(centre + base::cast<float>(random.unitVector() * (radius * random.uniform(0, 1))));
    };
    inBall({0, 0, 0}, 1, 1500);
    inBall({0.3f, 0, 0}, 1e-3, 1500);  // a thousand times denser
    inBall({2, 0, 0}, 0, 200);         // one place
    inBall({-1, 0, 0}, 1e-20, 200);    // squares of distances vanish
    inBall({0, 0, 0}, 1e4, 30);        // far away, each alone
    inBall({1e18f, 1e18f, 0}, 1e5, 5); // squares of distances reach the end of floats
    const SurfelTree tree = SurfelTree::build(listOf(places));
    for (const std::size_t k : {1, 6, 14, 32})
        QVERIFY2(agreeAt(tree, positionsOf(tree), k), qPrintable(QString("k %1, seed %2").arg(k).arg(test::seed())));
}

void NearestTogetherTest::smallAndEmptyTreesAnswerWithWhatTheyHave() {
    base::Random random(test::seed());
    const std::vector<base::Vec3f> anywhere{{0, 0, 0}, {0.1f, 0, 0}, {5, 5, 5}, {5, 5, 5}};
    for (const std::size_t count : {0, 1, 3, 14, 40}) {
        const SurfelTree tree = count ? SurfelTree::build(test::bumpySphere(count, random)) : SurfelTree();
        for (const std::size_t k : {0, 1, 14, 50})
            QVERIFY(agreeAt(tree, anywhere, k));
    }
}

static const test::Registered<NearestTogetherTest> registered;
#include "nearest_together_test.moc"
