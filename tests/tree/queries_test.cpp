// Every query against a plain loop over all blocks, on fresh and on much edited trees.
#include "support/registry.h"
#include "tree/random_edits.h"

#include <QTest>

using namespace tree;
using surfel::SurfelBlock;

class QueriesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void initTestCase();
    void supportQueryFindsTheClustersOfBruteForce();
    void supportQueryCoversEverySurfelWithWeight();
    void boxQueryCoversEveryPositionInTheBox();
    void reachMultipliesSupports();
    void ballQueryFindsTheBlocksOfBruteForce();
    void rayVisitsEveryClusterThatItMeetsInOrder();
    void rayAlongAnAxisMeetsBordersItRunsIn();
    void rayStopsWhenToldTo();
    void nearestFirstMissesNothingThatIsWanted();
    void rayThroughManyBoundsOutgrowsTheInlineQueue();
    void emptyTreeAnswersNothing();

  private:
    std::vector<base::Vec3f> positions(std::size_t count);
    std::vector<SurfelTree> m_trees; ///< fresh, edited, of one block
    base::Random m_random{test::seed()};
};

using Cluster = std::pair<const SurfelBlock*, int>;

static const char* seedText() {
    static const std::string text = "seed " + std::to_string(test::seed());
    return text.c_str();
}

void QueriesTest::initTestCase() {
    m_trees.push_back(SurfelTree::build(test::bumpySphere(20000, m_random)));
    m_trees.push_back(SurfelTree::build(test::bumpySphere(60, m_random)));
    test::EditedModel model(8000, test::seed());
    for (int round = 0; round < 200 || model.tree().size() < 4000; ++round)
        model.apply(model.randomEdit());
    m_trees.push_back(model.tree());
}

/// Near the surface, at samples, on the borders of boxes and of supports, and far outside.
std::vector<base::Vec3f> QueriesTest::positions(std::size_t count) {
    std::vector<base::Vec3f> out;
    for (std::size_t i = 0; i < count; ++i) {
        const SurfelTree& tree = m_trees[i % m_trees.size()];
        const auto number = static_cast<std::uint32_t>(m_random.below(tree.blockCount()));
        const surfel::BlockPtr block = tree.block(number);
        const int slot = static_cast<int>(m_random.below(static_cast<std::size_t>(block->size())));
        const surfel::ClusterBounds bounds = block->bounds(slot / surfel::clusterSize);
        switch (m_random.below(6)) {
        case 0:
            out.push_back(block->position(slot));
            break;
        case 1:
            out.push_back({bounds.box.lo.x, block->position(slot).y, bounds.box.hi.z});
            break;
        case 2:
            out.push_back(bounds.box.hi + base::Vec3f{bounds.maxSupport, 0, 0});
            break;
        case 3:
            out.push_back(block->position(slot) + base::Vec3f{0, block->support(slot), 0});
            break;
        case 4:
            out.push_back(base::cast<float>(m_random.unitVector() * m_random.uniform(0.8, 1.2)));
            break;
        default:
            out.push_back(base::cast<float>(m_random.unitVector() * std::pow(10.0, m_random.uniform(0, 6))));
        }
    }
    return out;
}

void QueriesTest::supportQueryFindsTheClustersOfBruteForce() {
    for (const SurfelTree& tree : m_trees)
        for (const base::Vec3f& x : positions(600)) {
            std::vector<Cluster> expected, found;
            tree.forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
                for (int cluster = 0; cluster < block.clusterCount(); ++cluster)
                    if (block.bounds(cluster).supports(x))
                        expected.emplace_back(&block, cluster);
            });
            tree.forClustersInSupport(x, [&](const SurfelBlock& b, int cluster) { found.emplace_back(&b, cluster); });
            QVERIFY2(found == expected, seedText());
        }
}

void QueriesTest::supportQueryCoversEverySurfelWithWeight() {
    for (const SurfelTree& tree : m_trees)
        for (const base::Vec3f& x : positions(300)) {
            std::size_t expected = 0, found = 0;
            const auto count = [&](const SurfelBlock& block, int begin, int end, std::size_t& sum) {
                for (int slot = begin; slot < std::min(end, block.size()); ++slot) {
                    const double h = block.support(slot);
                    sum += base::distanceSq(base::cast<double>(block.position(slot)), base::cast<double>(x)) <
                           h * h * (1 - 1e-6);
                }
            };
            tree.forEachBlock(
                [&](std::uint32_t, const SurfelBlock& block) { count(block, 0, block.size(), expected); });
            tree.forClustersInSupport(x, [&](const SurfelBlock& block, int cluster) {
                const int first = cluster * surfel::clusterSize;
                count(block, first, first + surfel::clusterSize, found);
            });
            QVERIFY2(found == expected, seedText());
        }
}

void QueriesTest::boxQueryCoversEveryPositionInTheBox() {
    for (const SurfelTree& tree : m_trees)
        for (const base::Vec3f& centre : positions(100)) {
            base::Box3f box;
            box.extend(centre);
            const auto size = static_cast<float>(std::pow(10.0, m_random.uniform(-3, 0)));
            box.extend(centre + base::Vec3f{size, 0.5f * size, 0});
            std::vector<Cluster> inBox;
            tree.forClustersInSupport(box, [&](const SurfelBlock& b, int cluster) { inBox.emplace_back(&b, cluster); });
            std::sort(inBox.begin(), inBox.end());
            for (int k = 0; k < 10; ++k) {
                base::Vec3f x;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    x[axis] = std::clamp(static_cast<float>(m_random.uniform(box.lo[axis], box.hi[axis])), box.lo[axis],
                                         box.hi[axis]);
                bool covered = true;
                tree.forClustersInSupport(x, [&](const SurfelBlock& b, int cluster) {
                    covered &= std::binary_search(inBox.begin(), inBox.end(), Cluster(&b, cluster));
                });
                QVERIFY2(covered, seedText());
            }
            std::vector<Cluster> atPoint, atDegenerateBox;
            tree.forClustersInSupport(centre, [&](const SurfelBlock& b, int c) { atPoint.emplace_back(&b, c); });
            tree.forClustersInSupport(base::Box3f{centre, centre},
                                      [&](const SurfelBlock& b, int c) { atDegenerateBox.emplace_back(&b, c); });
            QVERIFY2(atPoint == atDegenerateBox, seedText());
        }
}

void QueriesTest::reachMultipliesSupports() {
    for (const SurfelTree& tree : m_trees)
        for (const base::Vec3f& x : positions(100)) {
            const float reach = static_cast<float>(m_random.uniform(1, 3));
            const base::Box3f box = base::Box3f{x, x}.inflated(static_cast<float>(m_random.uniform(0, 0.1)));
            std::vector<Cluster> expected, found, inBox;
            std::vector<std::uint32_t> blocks, blocksInBox;
            tree.forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
                for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
                    const float far = reach * block.bounds(cluster).maxSupport;
                    if (block.bounds(cluster).box.distanceSq(x) < far * far)
                        expected.emplace_back(&block, cluster);
                }
            });
            tree.forClustersInSupport(
                x, [&](const SurfelBlock& b, int cluster) { found.emplace_back(&b, cluster); }, reach);
            QVERIFY2(found == expected, seedText());
            // the box around x holds at least as much, and its blocks are those that may
            tree.forClustersInSupport(
                box, [&](const SurfelBlock& b, int cluster) { inBox.emplace_back(&b, cluster); }, reach);
            for (const Cluster& each : found)
                QVERIFY2(std::find(inBox.begin(), inBox.end(), each) != inBox.end(), seedText());
            tree.forEachBlock([&](std::uint32_t number, const SurfelBlock& block) {
                if (block.boundsLanes().supporting(box, reach) != 0)
                    blocks.push_back(number);
            });
            tree.forBlocksInSupport(
                box, [&](std::uint32_t number, const SurfelBlock&) { blocksInBox.push_back(number); }, reach);
            QVERIFY2(std::includes(blocksInBox.begin(), blocksInBox.end(), blocks.begin(), blocks.end()), seedText());
        }
}

void QueriesTest::ballQueryFindsTheBlocksOfBruteForce() {
    for (const SurfelTree& tree : m_trees)
        for (const base::Vec3f& x : positions(300)) {
            const auto radius = static_cast<float>(std::pow(10.0, m_random.uniform(-3, 1)));
            std::vector<std::uint32_t> expected, found;
            tree.forEachBlock([&](std::uint32_t number, const SurfelBlock& block) {
                if (block.box().distanceSq(x) <= radius * radius)
                    expected.push_back(number);
            });
            tree.forBlocksInBall(x, radius, [&](std::uint32_t number, const SurfelBlock& block) {
                QVERIFY(tree.block(number).get() == &block);
                found.push_back(number);
            });
            QVERIFY2(found == expected, seedText());
        }
}

struct Visit {
    Cluster cluster;
    float enter, leave;
};

static std::vector<Visit> visitsOf(const SurfelTree& tree, const base::Rayf& ray) {
    std::vector<Visit> out;
    tree.alongRay(ray, [&](const SurfelBlock& block, int cluster, float enter, float leave) {
        out.push_back({{&block, cluster}, enter, leave});
        return true;
    });
    return out;
}

static bool visitsAreThoseOfBruteForce(const SurfelTree& tree, const base::Rayf& ray) {
    const std::vector<Visit> visits = visitsOf(tree, ray);
    for (std::size_t i = 1; i < visits.size(); ++i)
        if (visits[i - 1].enter > visits[i].enter)
            return false;
    std::map<Cluster, std::pair<float, float>> expected, found;
    for (const Visit& visit : visits)
        found[visit.cluster] = {visit.enter, visit.leave};
    tree.forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
        for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
            const surfel::ClusterBounds bounds = block.bounds(cluster);
            const auto interval = clip(ray, bounds.box.inflated(surfel::surfaceReach * bounds.maxSupport));
            if (interval.first <= interval.second)
                expected[{&block, cluster}] = interval;
        }
    });
    return found.size() == visits.size() && found == expected;
}

void QueriesTest::rayVisitsEveryClusterThatItMeetsInOrder() {
    std::size_t visits = 0;
    for (const SurfelTree& tree : m_trees)
        for (const base::Vec3f& origin : positions(200)) {
            const base::Vec3d target = m_random.unitVector() * m_random.uniform();
            const base::Rayf ray{origin,
                                 base::cast<float>(base::normalized(target - base::cast<double>(origin), {0, 0, 1}))};
            QVERIFY2(visitsAreThoseOfBruteForce(tree, ray), seedText());
            visits += visitsOf(tree, ray).size();
        }
    QVERIFY(visits > 1000);
}

void QueriesTest::rayAlongAnAxisMeetsBordersItRunsIn() {
    const base::Vec3f axes[] = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    for (const SurfelTree& tree : m_trees)
        for (int k = 0; k < 60; ++k) {
            const surfel::BlockPtr block = tree.block(static_cast<std::uint32_t>(m_random.below(tree.blockCount())));
            const surfel::ClusterBounds bounds = block->bounds(0);
            const base::Box3f box = bounds.box.inflated(surfel::surfaceReach * bounds.maxSupport);
            for (const base::Vec3f& axis : axes) {
                QVERIFY2(visitsAreThoseOfBruteForce(tree, {box.lo - axis * 2.0f, axis}), seedText());
                QVERIFY2(visitsAreThoseOfBruteForce(tree, {box.hi, axis}), seedText());
            }
        }
}

void QueriesTest::rayStopsWhenToldTo() {
    const base::Rayf ray{{0, 0, 5}, {0, 0, -1}};
    const std::size_t all = visitsOf(m_trees[0], ray).size();
    QVERIFY(all > 3);
    std::size_t calls = 0;
    m_trees[0].alongRay(ray, [&](const SurfelBlock&, int, float, float) { return ++calls < 3; });
    QCOMPARE(calls, std::size_t(3));
}

void QueriesTest::nearestFirstMissesNothingThatIsWanted() {
    for (const SurfelTree& tree : m_trees)
        for (const base::Vec3f& origin : positions(60)) {
            const base::Rayf ray{origin, base::cast<float>(m_random.unitVector())};
            std::map<Cluster, std::pair<float, float>> visited;
            float most = std::numeric_limits<float>::infinity();
            tree.nearRay(ray, [&](const SurfelBlock& block, int cluster, float enter, float leave) {
                visited[{&block, cluster}] = {enter, leave};
                return most = std::min(most, enter + 0.2f); // of no more than what begins soon after the first
            });
            for (const Visit& visit : visitsOf(tree, ray))
                if (visit.enter <= most)
                    QVERIFY2(visited.contains(visit.cluster) &&
                                 visited[visit.cluster] == std::pair(visit.enter, visit.leave),
                             seedText());
        }
}

void QueriesTest::rayThroughManyBoundsOutgrowsTheInlineQueue() {
    surfel::SurfelList list = test::bumpySphere(20000, m_random);
    for (surfel::Surfel& s : list.items)
        s.support = 3;
    const SurfelTree tree = SurfelTree::build(list);
    const base::Rayf ray{{0, 0, 5}, {0, 0, -1}};
    QVERIFY(visitsOf(tree, ray).size() > 1000);
    QVERIFY(visitsAreThoseOfBruteForce(tree, ray));
}

void QueriesTest::emptyTreeAnswersNothing() {
    const SurfelTree none;
    std::size_t calls = 0;
    none.forClustersInSupport(base::Vec3f{}, [&](const SurfelBlock&, int) { ++calls; });
    none.forClustersInSupport(base::Box3f{{-1, -1, -1}, {1, 1, 1}}, [&](const SurfelBlock&, int) { ++calls; });
    none.forBlocksInBall({}, 10, [&](std::uint32_t, const SurfelBlock&) { ++calls; });
    none.alongRay({{}, {0, 0, 1}}, [&](const SurfelBlock&, int, float, float) { return ++calls > 0; });
    none.nearRay({{}, {0, 0, 1}}, [&](const SurfelBlock&, int, float, float) { return static_cast<float>(++calls); });
    m_trees[0].forClustersInSupport(base::Box3f{}, [&](const SurfelBlock&, int) { ++calls; });
    QCOMPARE(calls, std::size_t(0));
}

static const test::Registered<QueriesTest> registered;
#include "queries_test.moc"
