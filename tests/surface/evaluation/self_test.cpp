// Evaluation at a surface's own surfels, against the reference and against single evaluations.
#include "core/base/parallel.h"
#include "core/surface/definition_text.h"
#include "core/surface/evaluation/self.h"
#include "support/registry.h"
#include "support/threads.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;
using shapes::sameBits;

class SelfTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void valuesAndGradientsFollowTheReference_data();
    void valuesAndGradientsFollowTheReference();
    void nearSheetsKeepToTheirOwn();
    void otherFramesGiveTheBitsOfSingles_data();
    void otherFramesGiveTheBitsOfSingles();
    void rimsAreBeyondTheBoundary();
    void loneSurfelsSaySo();
    void supportScaleIsKept();
    void anyPartGivesTheSameBits();
    void threadsDoNotChangeBits();
};

namespace {

/// The evaluations of all surfels in tree order, each alone.
struct At {
    Vec3f place, own; ///< position and own normal of the surfel
    float value, weight, unit, offCentre, agreement;
    Vec3f centroid, normal, gradient;
    Status status;
};

std::vector<At> everywhere(const Surface& surface, Need need) {
    std::vector<std::vector<At>> found(surface.tree().blockCount());
    evaluateSelf(
        surface, need, [&](std::uint32_t number, const surfel::SurfelBlock& block, std::span<const SelfLanes> at) {
            for (int slot = 0; slot < block.size(); ++slot) {
                const SelfLanes& s = at[std::size_t(slot / surfel::clusterSize)];
                const int i = slot % surfel::clusterSize;
                found[number].push_back({block.position(slot), block.normal(slot), s.value[i], s.weight[i], s.unit[i],
                                         s.offCentre[i], s.agreement[i], s.centroidAt(i), s.normalAt(i),
                                         need == Need::Gradient ? s.gradientAt(i) : Vec3f{}, s.status[i]});
            }
        });
    std::vector<At> out;
    for (const auto& block : found)
        out.insert(out.end(), block.begin(), block.end());
    return out;
}

/// What differs between `a` and the reference, in units of h, or nothing.
QString difference(const At& a, const Evaluationd& b, bool gradient) {
    const double h = b.unit;
    const auto away = [](const Vec3f& x, const Vec3d& y) { return distance(base::cast<double>(x), y); };
    if (a.status != b.status)
        return QString("status %1, not %2").arg(statusName(a.status), statusName(b.status));
    if (std::abs(static_cast<double>(a.value) - b.value) > 2e-6 * h)
        return QString("value %1 h").arg((static_cast<double>(a.value) - b.value) / h);
    if (std::abs(static_cast<double>(a.weight) - b.weight) > 1e-5 * b.weight ||
        std::abs(static_cast<double>(a.unit) - h) > 1e-5 * h)
        return "weight or unit";
    if (away(a.centroid, b.centroid) > 5e-6 * h || std::abs(static_cast<double>(a.offCentre) - b.offCentre) > 5e-6 * h)
        return "centroid";
    if (away(a.normal, b.normal) > 5e-6 || std::abs(static_cast<double>(a.agreement) - b.agreement) > 5e-6)
        return "normal";
    if (gradient && away(a.gradient, b.gradient) > 2e-5)
        return QString("gradient %1").arg(away(a.gradient, b.gradient));
    return {};
}

void compareWithReference(const Surface& surface, Need need) {
    const std::vector<At> all = everywhere(surface, need);
    QCOMPARE(all.size(), surface.tree().size());
    for (std::size_t i = 0; i < all.size(); i += 3) {
        const Evaluationd expected = surface.evaluateReference(base::cast<double>(all[i].place), need, {all[i].own});
        const QString found = difference(all[i], expected, need == Need::Gradient);
        QVERIFY2(found.isEmpty(), qPrintable(QString("%1: %2").arg(i).arg(found)));
    }
}

} // namespace

void SelfTest::valuesAndGradientsFollowTheReference_data() {
    QTest::addColumn<int>("weight");
    QTest::addColumn<bool>("shrinkFree");
    QTest::addColumn<bool>("gradient");
    for (const auto& weight : weightNames())
        for (const bool shrinkFree : {true, false})
            for (const bool gradient : {true, false})
                QTest::addRow("%s mu=%d %s", weight.name, shrinkFree, gradient ? "gradient" : "value")
                    << static_cast<int>(weight.value) << shrinkFree << gradient;
}

void SelfTest::valuesAndGradientsFollowTheReference() {
    QFETCH(int, weight);
    QFETCH(bool, shrinkFree);
    QFETCH(bool, gradient);
    const Weight kind = static_cast<Weight>(weight);
    const double support = kind == Weight::Gaussian ? 0.35 : 0.21;
    surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.06, support), 0.01, test::seed());
    base::Random random(test::seed());
    for (surfel::Surfel& s : list.items)
        s.support *= static_cast<float>(random.uniform(0.9, 1.1));
    compareWithReference(shapes::surfaceOf(list, shapes::definitionOf(Frame::Normals, shrinkFree, kind)),
                         gradient ? Need::Gradient : Need::Value);
}

void SelfTest::nearSheetsKeepToTheirOwn() {
    const double spacing = 0.1;
    const Surface surface = shapes::surfaceOf(shapes::plates(12, spacing, 0.35, spacing));
    compareWithReference(surface, Need::Gradient);
    int inside = 0;
    for (const At& at : everywhere(surface, Need::Value)) {
        if (std::abs(at.place.x) > 0.8f || std::abs(at.place.y) > 0.8f)
            continue;
        ++inside;
        QVERIFY(std::abs(at.value) < 1e-6f); // plates are flat
        QVERIFY(dot(at.normal, at.own) > 0.999999f);
    }
    QVERIFY(inside > 400);
}

void SelfTest::otherFramesGiveTheBitsOfSingles_data() {
    QTest::addColumn<int>("frame");
    QTest::addColumn<bool>("oriented");
    QTest::addColumn<bool>("interpolating");
    for (const auto& frame : frameNames())
        for (const bool oriented : {true, false})
            for (const bool interpolating : {true, false})
                if (frame.value != Frame::Normals || !oriented || interpolating)
                    QTest::addRow("%s%s%s", frame.name, oriented ? "" : " unoriented",
                                  interpolating ? " interpolating" : "")
                        << static_cast<int>(frame.value) << oriented << interpolating;
}

void SelfTest::otherFramesGiveTheBitsOfSingles() {
    QFETCH(int, frame);
    QFETCH(bool, oriented);
    QFETCH(bool, interpolating);
    surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.1, 0.35), 0.01, test::seed());
    list.layout = shapes::layout(true, oriented);
    SurfaceDefinition definition = shapes::definitionOf(static_cast<Frame>(frame), true);
    definition.interpolating = interpolating;
    const Surface surface = shapes::surfaceOf(list, definition);
    const std::vector<At> all = everywhere(surface, Need::Gradient);
    for (std::size_t i = 0; i < all.size(); i += 5) {
        const Evaluationf one = surface.evaluate(all[i].place, Need::Gradient, {all[i].own});
        QVERIFY(all[i].status == one.status && sameBits(all[i].value, one.value) &&
                sameBits(all[i].normal, one.normal) && sameBits(all[i].gradient, one.gradient));
    }
}

void SelfTest::rimsAreBeyondTheBoundary() {
    SurfaceDefinition definition;
    definition.boundary = Boundary::Limit;
    definition.boundaryLimit = 0.1f;
    const Surface surface = shapes::surfaceOf(shapes::plane(15, 0.1, 0.35), definition);
    compareWithReference(surface, Need::Value);
    int beyond = 0;
    for (const At& at : everywhere(surface, Need::Value))
        beyond += at.status == Status::BeyondBoundary;
    QVERIFY(beyond >= 4 * 30 && beyond < 31 * 31 / 2);
}

void SelfTest::loneSurfelsSaySo() {
    for (const int count : {1, 2, 3, 4}) {
        surfel::SurfelList list;
        list.layout = shapes::layout(true, true);
        for (int i = 0; i < count; ++i)
            list.items.push_back(shapes::surfelAt({0.1 * i, 0.05 * (i % 2), 0}, {0, 0, 1}, 1));
        const Surface surface = shapes::surfaceOf(list);
        const std::vector<At> all = everywhere(surface, Need::Value);
        QCOMPARE(all.size(), std::size_t(count));
        for (const At& at : all)
            QCOMPARE(at.status, surface.evaluateReference(base::cast<double>(at.place), Need::Value).status);
        QCOMPARE(all[0].status, count < 3 ? Status::Degenerate : Status::Ok);
    }
    const Surface none = shapes::surfaceOf({});
    QVERIFY(everywhere(none, Need::Value).empty());
}

void SelfTest::supportScaleIsKept() {
    const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.06, 0.15), 0.01, test::seed());
    compareWithReference(shapes::surfaceOf(list).withSupportScale(1.5f), Need::Gradient);
}

void SelfTest::anyPartGivesTheSameBits() {
    const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.4, 0.04, 0.14), 0.005, test::seed()));
    const std::vector<At> all = everywhere(surface, Need::Value);
    std::size_t first = 0;
    SelfEvaluator self(surface);
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        const int cluster = block.clusterCount() / 2;
        SelfLanes at[surfel::clustersPerBlock];
        self.evaluate(block, 1u << cluster, Need::Value, at);
        for (int slot = cluster * surfel::clusterSize; slot < std::min(block.size(), (cluster + 1) * 16); ++slot) {
            const At& expected = all[first + std::size_t(slot)];
            QVERIFY(sameBits(at[cluster].value[slot % 16], expected.value));
            QVERIFY(sameBits(at[cluster].normalAt(slot % 16), expected.normal));
        }
        first += std::size_t(block.size());
    });
    QCOMPARE(first, all.size());

    const std::vector<std::uint32_t> numbers{1, 3, 4};
    std::vector<std::uint32_t> called;
    base::setThreadCount(1);
    evaluateSelf(surface, numbers, Need::Value,
                 [&](std::uint32_t number, const surfel::SurfelBlock&, std::span<const SelfLanes>) {
                     called.push_back(number);
                 });
    base::setThreadCount(0);
    QCOMPARE(called, numbers);
}

void SelfTest::threadsDoNotChangeBits() {
    const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.4, 0.03, 0.1), 0.005, test::seed()));
    const auto work = [&] { return everywhere(surface, Need::Gradient); };
    const std::vector<At> one = test::onThreads(1, work), two = test::onThreads(2, work);
    QCOMPARE(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i)
        QVERIFY(one[i].status == two[i].status && sameBits(one[i].value, two[i].value) &&
                sameBits(one[i].gradient, two[i].gradient) && sameBits(one[i].centroid, two[i].centroid));
}

static const test::Registered<SelfTest> registered;
#include "self_test.moc"
