#include "core/process/estimation/prepare.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/process/estimation/normals.h"
#include "core/process/estimation/spacing.h"
#include "core/process/samples/samples.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/thread_counts.h"

#include <array>
#include <fstream>
#include <QTest>
#include <sstream>

using namespace process;
using surface::Boundary;
using surface::Frame;
using surface::SurfaceDefinition;

class PrepareTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everySampleBecomesASurface_data();
    void everySampleBecomesASurface();
    void whatCameWithThePointsIsKept();
    void missingNormalsTakeTheSideOfTheirNeighbours();
    void closedCloudsThatLookInwardsAreTurned();
    void nonFinitePointsAreDroppedWithTheirAttributes();
    void fewerThanFourDistinctPointsAreRefused();
    void coincidentPointsAreFine();
    void closedModelsHaveNoBoundaryLimit_data();
    void closedModelsHaveNoBoundaryLimit();
    void openModelsHaveALimitWithinItsRange_data();
    void openModelsHaveALimitWithinItsRange();
    void limitOfDefinitionIsKept();
    void decidedLimitIsNotDecidedAgain();
    void redefineIsPrepareUnderTheOtherDefinition();
    void redefineSharesWhatDoesNotChange();
    void sameHashAtAnyThreadCount();
    void theOrderOfTheFileDoesNotMatter();
    void progressRisesAndCancelStops();
    void scansAgreeWithTheirMeshes_data();
    void scansAgreeWithTheirMeshes();
};

static surfel::SurfelList withoutNormals(surfel::SurfelList list) {
    for (auto& s : list.items)
        s.normal = {};
    list.layout = surfel::AttributeLayout::none();
    return list;
}

static surfel::SurfelList halfSphere(double noise) {
    auto list = sample("sphere").make(16000, 1);
    base::Random random(test::seed());
    std::erase_if(list.items, [](const surfel::Surfel& s) { return s.position.y < 0; });
    for (auto& s : list.items)
        s.position += base::cast<float>(random.unitVector() * noise);
    return list;
}

void PrepareTest::everySampleBecomesASurface_data() {
    QTest::addColumn<QString>("id");
    for (const SampleRow& row : sampleTable())
        if (row.manifold == surface::Manifold::Surface)
            QTest::newRow(row.id) << row.id;
}

void PrepareTest::everySampleBecomesASurface() {
    QFETCH(QString, id);
    const auto list = sample(id.toStdString()).make(5000, 1);
    const surface::Surface s = prepare(list, {});
    QCOMPARE(s.tree().size(), list.size());
    QVERIFY(s.tree().layout()->normals);
    QCOMPARE(s.tree().layout()->oriented, id != "moebius");
    std::size_t ok = 0;
    for (const auto& surfel : list.items) {
        const auto e = s.evaluate(surfel.position);
        ok += e.ok() && std::abs(e.value) < 0.05f && e.samples > 10;
    }
    QVERIFY2(ok > list.size() * 98 / 100, qPrintable(QString::number(ok)));
}

void PrepareTest::whatCameWithThePointsIsKept() {
    auto list = sample("torus").make(3000, 1);
    base::Random random(test::seed());
    for (auto& s : list.items) {
        s.normal = base::cast<float>(random.unitVector()); // nonsense, but brought along
        s.support = static_cast<float>(random.uniform(0.1, 0.2));
        s.colour = static_cast<surfel::Colour>(random.next());
        s.mask = static_cast<float>(random.uniform());
    }
    const auto kept = prepare(list, {});
    // The order-free hash compares all channels at once.
    QCOMPARE(kept.tree().contentHash().text(), tree::SurfelTree::build(list).contentHash().text());
    PrepareOptions anew;
    anew.keepSupports = false;
    QVERIFY(prepare(list, anew).tree().contentHash() != kept.tree().contentHash());
}

void PrepareTest::missingNormalsTakeTheSideOfTheirNeighbours() {
    auto list = sample("sphere").make(5000, 1);
    for (std::size_t i = 0; i < list.size(); ++i) {
        list.items[i].normal = -list.items[i].normal; // inward, which no estimate would choose
        if (i % 10 == 0)
            list.items[i].normal = {};
    }
    for (const auto& s : prepare(list, {}).tree().surfels().items)
        QVERIFY(dot(s.normal, s.position) < -0.99f);
}

void PrepareTest::closedCloudsThatLookInwardsAreTurned() {
    for (const char* shape : {"sphere", "torus", "knot"}) {
        surfel::SurfelList given = sample(shape).make(6000, 1), inwards = given;
        for (auto& s : inwards.items)
            s.normal = -s.normal;
        PrepareOptions options;
        bool turned = false;
        options.turned = &turned;
        const auto expected = prepare(given, options).tree();
        QVERIFY2(!turned, shape);
        QVERIFY2(prepare(inwards, options).tree().contentHash() == expected.contentHash(), shape);
        QVERIFY2(turned, shape);
        options.turned = nullptr; // nobody asks
        QVERIFY2(prepare(inwards, options).tree().contentHash() != expected.contentHash(), shape);
    }
    surfel::SurfelList bowl = halfSphere(0); // what is open may be seen from either side
    for (auto& s : bowl.items)
        s.normal = -s.normal;
    PrepareOptions options;
    bool turned = false;
    options.turned = &turned;
    const auto hash = prepare(bowl, {}).tree().contentHash();
    QVERIFY(prepare(bowl, options).tree().contentHash() == hash && !turned);
}

void PrepareTest::nonFinitePointsAreDroppedWithTheirAttributes() {
    surfel::SurfelList list;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->add("number", surfel::ScalarType::UInt32);
    list.layout = layout;
    const auto ball = sample("sphere").make(200, 1);
    const float bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
    for (std::uint32_t i = 0; i < 200; ++i) {
        surfel::Surfel s = ball.items[i];
        if (i % 3 == 0)
            s.position[i % 2] = bad[i % 2];
        s.colour = i;
        list.append(s, std::array{i});
    }
    const auto out = prepare(list, {}).tree().surfels();
    QCOMPARE(out.size(), std::size_t{133});
    for (std::size_t i = 0; i < out.size(); ++i) {
        QVERIFY(base::isFinite(out.items[i].position));
        QCOMPARE(out.extraOf(i)[0], out.items[i].colour);
    }
}

void PrepareTest::fewerThanFourDistinctPointsAreRefused() {
    surfel::SurfelList list;
    for (int n = 0; n < 40; ++n) {
        QVERIFY_EXCEPTION_THROWN(prepare(list, {}), base::Error);
        list.items.push_back({});
        list.items.back().position = {static_cast<float>(n % 3), 0, 0};
    }
    list.items.back().position = {0, 1, 0};
    const auto s = prepare(list, {});
    QCOMPARE(s.tree().size(), std::size_t{40});
}

void PrepareTest::coincidentPointsAreFine() {
    auto list = withoutNormals(sample("torus").make(4000, 1));
    const auto once = list.items;
    for (int copy = 0; copy < 3; ++copy)
        list.items.insert(list.items.end(), once.begin(), once.begin() + 2000);
    const auto all = prepare(list, {}).tree().surfels();
    for (const auto& s : all.items) {
        QVERIFY(std::isfinite(s.support) && s.support > 0.02f && s.support < 1);
        const base::Vec3f ring = base::normalized(base::Vec3f{s.position.x, 0, s.position.z}) * 0.7f;
        QVERIFY(dot(s.normal, s.position - ring) > 0.29f);
    }
}

void PrepareTest::closedModelsHaveNoBoundaryLimit_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<double>("noise");
    for (const char* id : {"sphere", "torus", "knot", "clay"})
        for (const double noise : {0.0, 0.004})
            QTest::addRow("%s %g", id, noise) << QString(id) << noise;
}

void PrepareTest::closedModelsHaveNoBoundaryLimit() {
    QFETCH(QString, id);
    QFETCH(double, noise);
    auto list = sample(id.toStdString()).make(8000, 1);
    base::Random random(test::seed());
    for (auto& s : list.items)
        s.position += base::cast<float>(random.unitVector() * noise);
    QVERIFY(std::isinf(prepare(list, {}).definition().boundaryLimit));
}

void PrepareTest::openModelsHaveALimitWithinItsRange_data() {
    QTest::addColumn<double>("noise");
    QTest::newRow("clean") << 0.0;
    QTest::newRow("noisy") << 0.01;
}

void PrepareTest::openModelsHaveALimitWithinItsRange() {
    QFETCH(double, noise);
    const auto s = prepare(halfSphere(noise), {});
    const float limit = s.definition().boundaryLimit;
    QVERIFY2(limit >= 0.15f && limit <= 0.45f, qPrintable(QString::number(limit)));
    // The limit cuts off what runs on below the rim, and nothing of the inside.
    std::size_t inside = 0;
    base::Random random(test::seed());
    for (int k = 0; k < 2000; ++k) {
        base::Vec3f x = base::cast<float>(random.unitVector());
        x.y = std::abs(x.y);
        inside += x.y < 0.05f || s.evaluate(x).ok();
    }
    QVERIFY2(inside > 1990, qPrintable(QString::number(inside)));
    const float h = s.tree().maxSupport();
    QCOMPARE(static_cast<int>(s.evaluate({1, -0.5f * h, 0}).status), static_cast<int>(surface::Status::BeyondBoundary));
}

void PrepareTest::decidedLimitIsNotDecidedAgain() {
    PrepareOptions options;
    options.keepLimit = true;
    for (const float limit : {0.2f, 0.4f, std::numeric_limits<float>::infinity()}) {
        options.definition.boundaryLimit = limit;
        QCOMPARE(prepare(halfSphere(0), options).definition().boundaryLimit, limit);
        QCOMPARE(prepare(halfSphere(0), options).definition().boundary, Boundary::Auto);
    }
}

void PrepareTest::limitOfDefinitionIsKept() {
    PrepareOptions options;
    options.definition.boundary = Boundary::Limit;
    options.definition.boundaryLimit = 0.3f;
    QCOMPARE(prepare(halfSphere(0), options).definition().boundaryLimit, 0.3f);
    options.definition.boundary = Boundary::None;
    QVERIFY(std::isinf(prepare(halfSphere(0), options).definition().boundaryLimit));
}

void PrepareTest::redefineIsPrepareUnderTheOtherDefinition() {
    const auto list = halfSphere(0.003);
    PrepareOptions options;
    const auto first = prepare(list, options);
    options.definition.neighbours = 20;
    options.definition.weight = surface::Weight::Gaussian;
    const auto direct = prepare(list, options), redefined = redefine(first, options.definition);
    QCOMPARE(redefined.tree().contentHash().text(), direct.tree().contentHash().text());
    QCOMPARE(redefined.definition().boundaryLimit, direct.definition().boundaryLimit);
    QVERIFY(redefined.tree().contentHash() != first.tree().contentHash());
}

void PrepareTest::redefineSharesWhatDoesNotChange() {
    const auto first = prepare(halfSphere(0), {});
    SurfaceDefinition other = first.definition();
    other.frame = Frame::Hyperplanes;
    other.shrinkFree = false;
    const auto second = redefine(first, other);
    QVERIFY(second.tree() == first.tree());
    QVERIFY(second.definition().frame == Frame::Hyperplanes);
}

void PrepareTest::sameHashAtAnyThreadCount() {
    const auto list = sample("scan").make(20000, test::seed());
    SurfaceDefinition other;
    other.neighbours = 24;
    std::vector<surface::Surface> all, others;
    for (const int threads : test::comparedThreads({0})) {
        base::setThreadCount(threads);
        all.push_back(prepare(list, {}));
        others.push_back(redefine(all.back(), other));
    }
    base::setThreadCount(0);
    for (const auto& made : {all, others}) {
        QCOMPARE(made.front().tree().contentHash().text(), made.back().tree().contentHash().text());
        QVERIFY(made.front().definition() == made.back().definition());
    }
}

/// Slot by slot, under the definition that came out.
static bool sameBits(const surface::Surface& a, const surface::Surface& b) {
    return a.tree().surfels().items == b.tree().surfels().items && a.definition() == b.definition();
}

void PrepareTest::theOrderOfTheFileDoesNotMatter() {
    if (test::sanitized)
        QSKIP("seconds under a sanitizer");
    base::Random random(test::seed());
    for (const char* id : {"scan", "sphere"})
        for (const bool normals : {true, false}) {
            surfel::SurfelList list = sample(id).make(6000, test::seed());
            if (!normals)
                list = withoutNormals(list);
            PrepareOptions options;
            options.keepSupports = false;
            std::size_t merged = 0;
            options.merged = &merged;
            const surface::Surface expected = prepare(list, options);
            for (std::size_t i = list.size(); i > 1; --i)
                std::swap(list.items[i - 1], list.items[random.below(i)]);
            QVERIFY2(sameBits(expected, prepare(list, options)),
                     qPrintable(QString("%1, seed %2").arg(id).arg(test::seed())));
        }
}

void PrepareTest::progressRisesAndCancelStops() {
    const auto list = sample("scan").make(30000, 1);
    double last = 0;
    int calls = 0;
    base::Progress progress;
    progress.report = [&](double done, std::string_view what) {
        QVERIFY2(
            done >= last && done <= 1 && !what.empty(),
            qPrintable(QString("%1 after %2, %3").arg(done).arg(last).arg(QString::fromStdString(std::string(what)))));
        last = done;
        ++calls;
    };
    prepare(list, {}, progress);
    QVERIFY2(calls > 15, qPrintable(QString::number(calls)));
    for (const double when : {0.05, 0.3, 0.5, 0.75, 0.92}) {
        std::atomic<bool> cancel = false;
        base::Progress stopping{{}, &cancel};
        stopping.report = [&](double done, std::string_view) { cancel = done >= when; };
        QVERIFY_EXCEPTION_THROWN(prepare(list, {}, stopping), base::Cancelled);
    }
}

/// Positions with area-weighted face normals of an ascii PLY mesh whose vertex records begin with x y z.
static surfel::SurfelList readMesh(const std::string& path) {
    std::ifstream in(path);
    std::size_t vertices = 0, faces = 0;
    for (std::string line; std::getline(in, line) && !line.starts_with("end_header");) {
        std::istringstream words(line);
        std::string keyword, name;
        std::size_t n = 0;
        if (words >> keyword >> name >> n && keyword == "element")
            (name == "vertex" ? vertices : faces) = n;
    }
    surfel::SurfelList out;
    std::string line;
    for (std::size_t i = 0; i < vertices && std::getline(in, line); ++i) {
        out.items.push_back({});
        std::istringstream(line) >> out.items[i].position.x >> out.items[i].position.y >> out.items[i].position.z;
    }
    for (std::size_t f = 0; f < faces && std::getline(in, line); ++f) {
        std::size_t n = 0, a = 0, b = 0, c = 0;
        std::istringstream(line) >> n >> a >> b >> c;
        const auto& p = out.items[a].position;
        const base::Vec3f normal = cross(out.items[b].position - p, out.items[c].position - p);
        for (const std::size_t corner : {a, b, c})
            out.items[corner].normal += normal;
    }
    return out;
}

void PrepareTest::scansAgreeWithTheirMeshes_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("agreeing");
    QTest::newRow("bunny") << "bunny/bun_zipper.ply" << 0.9999;
    QTest::newRow("dragon") << "dragon_res2.ply" << 0.997;
}

void PrepareTest::scansAgreeWithTheirMeshes() {
    QFETCH(QString, file);
    QFETCH(double, agreeing);
    if (test::dataFolder().empty())
        QSKIP("POINTCLAY_DATA names no folder with real scans");
    const auto mesh = readMesh(test::dataFolder() + "/" + file.toStdString());
    QVERIFY(mesh.size() > 30000);
    auto list = withoutNormals(mesh);
    estimateNormals(list);
    orientNormals(list);
    double agree = 0, known = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        known += lengthSq(mesh.items[i].normal) > 0;
        agree += dot(list.items[i].normal, mesh.items[i].normal) > 0;
    }
    QVERIFY2(agree >= agreeing * known, qPrintable(QString("%1 %").arg(100 * agree / known)));
}

static const test::Registered<PrepareTest> registered;
#include "prepare_test.moc"
