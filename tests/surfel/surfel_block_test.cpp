#include "core/surfel/surfel_block.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <cstring>
#include <limits>
#include <QTest>

using namespace surfel;

class SurfelBlockTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void surfelsComeBackBitForBit();
    void sealedBoundsAreTight();
    void paddingIsFarAndFinite();
    void everyArrayIsAligned();
    void cloneIsEqualAndIndependent();
    void hashIgnoresOrderAndSignOfZero();
    void hashSeesEveryChannel();
    void ownersAreCounted();
    void bytesFollowTheClusters();
};

static Surfel randomSurfel(base::Random& random) {
    Surfel s;
    s.position = base::cast<float>(random.unitVector() * random.uniform(0, 10));
    s.normal = base::cast<float>(random.unitVector());
    s.support = static_cast<float>(random.uniform(0.1, 2));
    s.colour = static_cast<Colour>(random.next());
    s.mask = static_cast<float>(random.uniform());
    return s;
}

struct Filled {
    MutableBlockPtr block;
    std::vector<Surfel> surfels;
    std::vector<std::vector<std::uint32_t>> extra;
};

static Filled filled(int size, std::size_t words, base::Random& random) {
    Filled out{SurfelBlock::create(size, words), {}, {}};
    for (int slot = 0; slot < size; ++slot) {
        out.surfels.push_back(randomSurfel(random));
        std::vector<std::uint32_t> extra(words);
        for (std::uint32_t& word : extra)
            word = static_cast<std::uint32_t>(random.next()); // any bits, signalling NaN among them
        out.extra.push_back(extra);
        out.block->set(slot, out.surfels.back());
        out.block->setExtra(slot, extra);
    }
    out.block->seal();
    return out;
}

void SurfelBlockTest::surfelsComeBackBitForBit() {
    base::Random random(test::seed());
    for (const int size : {1, 15, 16, 17, 100, 127, 128})
        for (const std::size_t words : {0, 1, 5}) {
            const Filled f = filled(size, words, random);
            QCOMPARE(f.block->size(), size);
            QCOMPARE(f.block->extraWords(), words);
            std::vector<std::uint32_t> extra(words);
            for (int slot = 0; slot < size; ++slot) {
                const Surfel& s = f.surfels[static_cast<std::size_t>(slot)];
                QVERIFY(f.block->surfel(slot) == s);
                QVERIFY(f.block->position(slot) == s.position);
                QVERIFY(f.block->normal(slot) == s.normal);
                QCOMPARE(f.block->support(slot), s.support);
                QCOMPARE(f.block->mask(slot), s.mask);
                f.block->extra(slot, extra);
                QVERIFY(extra == f.extra[static_cast<std::size_t>(slot)]);
            }
        }
}

void SurfelBlockTest::sealedBoundsAreTight() {
    base::Random random(test::seed());
    for (const int size : {1, 16, 33, 128}) {
        const Filled f = filled(size, 2, random);
        base::Box3f all;
        float allSupport = 0;
        for (int cluster = 0; cluster < f.block->clusterCount(); ++cluster) {
            ClusterBounds expected;
            for (int slot = cluster * clusterSize; slot < std::min(size, (cluster + 1) * clusterSize); ++slot) {
                expected.box.extend(f.surfels[static_cast<std::size_t>(slot)].position);
                expected.maxSupport = std::max(expected.maxSupport, f.surfels[static_cast<std::size_t>(slot)].support);
            }
            QVERIFY(f.block->bounds(cluster).box == expected.box);
            QCOMPARE(f.block->bounds(cluster).maxSupport, expected.maxSupport);
            all.extend(expected.box);
            allSupport = std::max(allSupport, expected.maxSupport);
        }
        QVERIFY(f.block->box() == all);
        QCOMPARE(f.block->maxSupport(), allSupport);
        QCOMPARE(f.block->clusterMask(), (1u << f.block->clusterCount()) - 1);
    }
}

void SurfelBlockTest::paddingIsFarAndFinite() {
    base::Random random(test::seed());
    const Filled f = filled(37, 3, random);
    const int last = f.block->clusterCount() - 1;
    for (int lane = 37 - last * clusterSize; lane < clusterSize; ++lane) {
        const base::Vec3f p{f.block->channel(last, X)[lane], f.block->channel(last, Y)[lane],
                            f.block->channel(last, Z)[lane]};
        QVERIFY(base::isFinite(p) && std::isfinite(base::lengthSq(p)));
        QVERIFY(base::lengthSq(p) > 1e29f);
        QCOMPARE(f.block->channel(last, Support)[lane], 1.0f);
        for (int c = NormalX; c < Extra + 3; ++c)
            QVERIFY(c == Support || f.block->channel(last, c)[lane] == 0.0f);
    }
}

void SurfelBlockTest::everyArrayIsAligned() {
    for (const std::size_t words : {0, 1, 3}) {
        const MutableBlockPtr block = SurfelBlock::create(128, words);
        for (int cluster = 0; cluster < 8; ++cluster)
            for (int c = 0; c < Extra + static_cast<int>(words); ++c) {
                QCOMPARE(reinterpret_cast<std::uintptr_t>(block->channel(cluster, c)) % 64, std::uintptr_t(0));
                QVERIFY(static_cast<const void*>(block->channel(cluster, c)) == block->words(cluster, c));
            }
    }
}

void SurfelBlockTest::cloneIsEqualAndIndependent() {
    base::Random random(test::seed());
    const Filled f = filled(90, 2, random);
    const MutableBlockPtr copy = f.block->clone();
    QVERIFY(copy->contentHash() == f.block->contentHash());
    QVERIFY(copy->box() == f.block->box());
    QVERIFY(copy->bounds(2).box == f.block->bounds(2).box);
    QCOMPARE(copy->maxSupport(), f.block->maxSupport());
    copy->setPosition(5, {100, 100, 100});
    copy->setNormal(5, {0, 0, 1});
    copy->seal();
    QVERIFY(copy->box().hi == (base::Vec3f{100, 100, 100}));
    QVERIFY(copy->normal(5) == (base::Vec3f{0, 0, 1}));
    QVERIFY(f.block->surfel(5) == f.surfels[5]);
}

void SurfelBlockTest::hashIgnoresOrderAndSignOfZero() {
    base::Random random(test::seed());
    const Filled f = filled(50, 1, random);
    const MutableBlockPtr reversed = SurfelBlock::create(50, 1);
    for (int slot = 0; slot < 50; ++slot) {
        reversed->set(49 - slot, f.surfels[static_cast<std::size_t>(slot)]);
        reversed->setExtra(49 - slot, f.extra[static_cast<std::size_t>(slot)]);
    }
    QVERIFY(reversed->contentHash() == f.block->contentHash());
    f.block->setPosition(3, {0, 1, 2});
    const base::Hash128 plus = f.block->contentHash();
    f.block->setPosition(3, {-0.0f, 1, 2});
    QVERIFY(f.block->contentHash() == plus);
}

void SurfelBlockTest::hashSeesEveryChannel() {
    base::Random random(test::seed());
    const Filled f = filled(20, 2, random);
    const base::Hash128 before = f.block->contentHash();
    for (int c = 0; c < Extra + 2; ++c) {
        const MutableBlockPtr other = f.block->clone();
        other->words(1, c)[2] ^= 1;
        QVERIFY(!(other->contentHash() == before));
    }
    // Same multiset of words, other owners: two surfels exchange one channel.
    const MutableBlockPtr swapped = f.block->clone();
    std::swap(swapped->channel(0, Support)[0], swapped->channel(0, Support)[1]);
    QVERIFY(!(swapped->contentHash() == before));
}

void SurfelBlockTest::ownersAreCounted() {
    BlockPtr a(SurfelBlock::create(3, 0));
    QCOMPARE(a->owners(), 1u);
    {
        const BlockPtr b = a;
        QCOMPARE(a->owners(), 2u);
        QVERIFY(a == b);
    }
    QCOMPARE(a->owners(), 1u);
    BlockPtr moved = std::move(a);
    QCOMPARE(moved->owners(), 1u);
    QVERIFY(!a);
}

void SurfelBlockTest::bytesFollowTheClusters() {
    const std::size_t one = SurfelBlock::create(1, 0)->bytes(), full = SurfelBlock::create(16, 0)->bytes();
    QCOMPARE(one, full);
    QCOMPARE(SurfelBlock::create(17, 0)->bytes() - full, std::size_t(16 * 36));
    QCOMPARE(SurfelBlock::create(16, 2)->bytes() - full, std::size_t(16 * 8));
    QVERIFY(SurfelBlock::create(112, 0)->bytes() <= 112 * 40);
}

static const test::Registered<SurfelBlockTest> registered;
#include "surfel_block_test.moc"
