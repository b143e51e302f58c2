#include "core/surface/evaluation/free_space.h"

#include "core/base/random.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <hwy/targets.h>
#include <QTest>

using namespace surface;
using base::Vec3f;

class FreeSpaceTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void restlessAreThoseThatAreCrowdedOrHaveFreeSpace();
    void lengthsBeyondFloatsMeetNoEmptyCluster();
    void avx2AndAvx512AgreeAboutIt();
};

using Slots = std::bitset<surfel::blockCapacity>;

static Surface shaken() {
    return shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.4, 0.06, 0.2), 0.02, test::seed()));
}

static FreeSpaceQuery queryOf(FreeSpaceQuery::Sheets sheets) {
    return {0.042f, 0.063f, 0.0405f, sheets, 0.17f};
}

static std::vector<Slots> answers(const Surface& surface, const FreeSpaceQuery& query) {
    std::vector<Slots> out;
    FreeSpaceFinder finder(surface.tree(), query);
    surface.tree().forEachBlock(
        [&](std::uint32_t, const surfel::SurfelBlock& block) { out.push_back(finder.restless(block, Slots().set())); });
    return out;
}

/// By how much a surfel is beyond the nearest of the limits: above 0 it is crowded or has free space.
static float beyond(const std::vector<surfel::Surfel>& all, const surfel::Surfel& at, const FreeSpaceQuery& q) {
    const Vec3f u = perpendicular(at.normal), v = cross(at.normal, u);
    float nearest[8], crowded = -1;
    std::fill(std::begin(nearest), std::end(nearest), 1.0f);
    for (const surfel::Surfel& other : all) {
        if (distance(other.position, at.position) > 2 * (q.ring + q.clear + q.close))
            continue; // has no say
        const float cosine = dot(at.normal, other.normal);
        const bool counts = q.sheets == FreeSpaceQuery::Sheets::All ||
                            (q.sheets == FreeSpaceQuery::Sheets::Signed ? cosine : std::abs(cosine)) > q.leastCosine;
        if (!counts || other.position == at.position)
            continue;
        crowded = std::max(crowded, q.close - distance(other.position, at.position));
        for (int k = 0; k < 8; ++k) {
            const float a = float(k) * 0.785398163f;
            const Vec3f place = at.position + (u * std::cos(a) + v * std::sin(a)) * q.ring;
            nearest[k] = std::min(nearest[k], distance(other.position, place));
        }
    }
    return std::max(crowded, *std::max_element(std::begin(nearest), std::end(nearest)) - q.clear);
}

void FreeSpaceTest::restlessAreThoseThatAreCrowdedOrHaveFreeSpace() {
    const Surface surface = shaken();
    const auto all = surface.tree().surfels().items;
    using Sheets = FreeSpaceQuery::Sheets;
    for (const Sheets sheets : {Sheets::All, Sheets::Unsigned, Sheets::Signed}) {
        const FreeSpaceQuery query = queryOf(sheets);
        const std::vector<Slots> found = answers(surface, query);
        std::size_t index = 0, restless = 0;
        for (std::uint32_t b = 0; b < surface.tree().blockCount(); ++b)
            for (int slot = 0; slot < surface.tree().block(b)->size(); ++slot, ++index) {
                const float by = beyond(all, all[index], query);
                if (std::abs(by) < 1e-6f)
                    continue;
                QVERIFY2(found[b][std::size_t(slot)] == (by > 0),
                         qPrintable(QString("surfel %1: %2, seed %3").arg(index).arg(by).arg(test::seed())));
                restless += by > 0;
            }
        QVERIFY(restless > index / 20 && restless < index - index / 20);
    }
}

/// The square of a reach may be infinite, and so is the way to lanes that hold no cluster: reading those is beyond the
/// block's memory, which sanitizers see. What is answered there is of no use, but the same again.
void FreeSpaceTest::lengthsBeyondFloatsMeetNoEmptyCluster() {
    const Surface surface = shapes::surfaceOf(shapes::torus(1, 0.4, 0.3, 0.2)); // blocks with clusters to spare
    bool spare = false;
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        spare |= block.clusterCount() < surfel::blockCapacity / surfel::clusterSize;
    });
    QVERIFY(spare);
    FreeSpaceQuery query = queryOf(FreeSpaceQuery::Sheets::Signed);
    query.ring = 1e30f;
    QVERIFY(answers(surface, query) == answers(surface, query));
}

void FreeSpaceTest::avx2AndAvx512AgreeAboutIt() {
    if ((hwy::SupportedTargets() & HWY_AVX3) == 0)
        QSKIP("this machine has no AVX-512");
    const Surface surface = shaken();
    const std::vector<Slots> wide = answers(surface, queryOf(FreeSpaceQuery::Sheets::Signed));
    hwy::DisableTargets(HWY_AVX3 | HWY_AVX3_DL);
    hwy::GetChosenTarget().DeInit();
    const std::vector<Slots> narrow = answers(surface, queryOf(FreeSpaceQuery::Sheets::Signed));
    hwy::DisableTargets(0);
    hwy::GetChosenTarget().DeInit();
    QVERIFY(wide == narrow);
}

static const test::Registered<FreeSpaceTest> registered;
#include "free_space_test.moc"
