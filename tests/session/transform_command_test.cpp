// Commands that move and scale models or what is selected of them: exact in numbers, normals by the exact Jacobian, at
// any distance from zero, and refused where sides would meet.
#include "far_ball.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using test::openBall, test::parsed, test::Workbench;

class TransformCommandTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void mapsAreExact();
    void softMovesTurnNormalsWithTheSurface();
    void modelsStandOnTheGroundAlongTheAxes();
    void modelsThatLieFarComeToZeroAndBack();
    void oneRadiusForAllIsScaledAlong();
    void sidesOfWhatIsThinDoNotMeet();
    void unitsAreSetByADistance();
};

/// One surfel to look at: the nearest to a place.
static surfel::Surfel at(const Workbench& bench, const Vec3d& x) {
    std::vector<tree::Neighbour> near;
    bench.document.surface().tree().nearest(base::cast<float>(x - bench.document.provenance().origin), 1, near);
    return near[0].block->surfel(near[0].slot);
}

void TransformCommandTest::mapsAreExact() {
    Workbench bench;
    bench.run(test::newSphere());
    const surfel::SurfelList before = bench.document.surface().tree().surfels();
    // An ellipsoid: normals are x / a^2.
    bench.run(parsed(R"({"op":"transform","stretch":[3,1,0.5],"about":[0,0,0],"of":"all"})"));
    const surfel::SurfelList after = bench.document.surface().tree().surfels();
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Vec3d p = base::cast<double>(before.items[i].position), n = base::cast<double>(before.items[i].normal);
        const Vec3d q{3 * p.x, p.y, 0.5 * p.z}, m = normalized(Vec3d{n.x / 3, n.y, n.z * 2});
        QVERIFY(distance(base::cast<double>(after.items[i].position), q) < 1e-6);
        QVERIFY(distance(base::cast<double>(after.items[i].normal), m) < 1e-6);
    }
    bench.run({{"op", "undo"}});
    // Four quarter turns and two mirrors are nothing.
    for (int k = 0; k < 4; ++k)
        bench.run(parsed(R"({"op":"transform","axis":[0,0,2],"angle":90,"about":[0.5,1,0]})"));
    for (int k = 0; k < 2; ++k)
        bench.run(parsed(R"({"op":"transform","mirror":[1,2,3,0.7]})"));
    const surfel::SurfelList back = bench.document.surface().tree().surfels();
    for (std::size_t i = 0; i < before.size(); ++i) {
        QVERIFY(distance(back.items[i].position, before.items[i].position) < 2e-6f);
        QVERIFY(distance(back.items[i].normal, before.items[i].normal) < 2e-6f);
        QCOMPARE(back.items[i].support, before.items[i].support);
    }
    // A mirrored ball is not turned inside out.
    bench.run(parsed(R"({"op":"transform","stretch":[-1,1,1],"about":[0,0,0]})"));
    for (const surfel::Surfel& s : bench.document.surface().tree().surfels().items)
        QVERIFY(dot(s.position, s.normal) > 0.99f);
    // The same numbers as a matrix of the file's coordinates.
    Workbench far, matrix;
    for (Workbench* each : {&far, &matrix})
        each->run(openBall(*each, 1e7));
    far.run(parsed(R"({"op":"transform","scale":2,"about":[1e7,-1e7,0],"move":[1,2,3]})"));
    matrix.run(parsed(R"({"op":"transform","matrix":[2,0,0,-9999999,0,2,0,10000002,0,0,2,3,0,0,0,1]})"));
    QVERIFY(distance(at(far, {1e7 + 1, -1e7 + 2, 5}).position, at(matrix, {1e7 + 1, -1e7 + 2, 5}).position) < 1e-5f);
    QVERIFY(distance(base::cast<double>(at(far, {1e7 + 1, -1e7 + 2, 5}).position) + far.document.provenance().origin,
                     Vec3d{1e7 + 1, -1e7 + 2, 5}) < 0.1);
}

void TransformCommandTest::softMovesTurnNormalsWithTheSurface() {
    // A plane lifted by a soft bump z = w(x, y): its normals are those of the graph.
    Workbench bench;
    std::ostringstream out;
    out << "ply\nformat ascii 1.0\nelement vertex 3600\nproperty float x\nproperty float y\nproperty float z\n"
           "property float nx\nproperty float ny\nproperty float nz\nproperty float selection\nend_header\n";
    const auto weight = [](double x, double y) { return std::exp(-(x * x + y * y)); };
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 60; ++j) {
            const double x = 0.1 * i - 3, y = 0.1 * j - 3;
            out << x << ' ' << y << " 0 0 0 1 " << weight(x, y) << '\n';
        }
    bench.run({{"op", "open"}, {"path", test::write(bench.path("plane.ply"), out.str()).string()}});
    bench.run(parsed(R"({"op":"transform","move":[0,0,0.8],"of":"selection"})"));
    for (const surfel::Surfel& s : bench.document.surface().tree().surfels().items) {
        const double x = double(s.position.x), y = double(s.position.y), w = weight(x, y);
        QVERIFY(std::abs(double(s.position.z) - 0.8 * w) < 1e-5);
        if (std::max(std::abs(x), std::abs(y)) < 2.4)
            QVERIFY(dot(base::cast<double>(s.normal), normalized(Vec3d{1.6 * x * w, 1.6 * y * w, 1})) > 0.998);
    }
}

void TransformCommandTest::modelsStandOnTheGroundAlongTheAxes() {
    Workbench bench;
    bench.run(test::newSphere(4000));
    bench.run(parsed(R"({"op":"transform","stretch":[3,1,2]})"));
    const base::Box3f straight = bench.document.surface().tree().bounds();
    bench.run(parsed(R"({"op":"transform","axis":[1,2,0.5],"angle":25,"move":[4,5,6]})"));
    bench.run(parsed(R"({"op":"align","do":"axes"})"));
    const base::Box3f turned = bench.document.surface().tree().bounds();
    QVERIFY(length(turned.size() - straight.size()) < 0.06f); // as even as the sampling is
    bench.run(parsed(R"({"op":"align","do":"centre"})"));
    bench.run(parsed(R"({"op":"up","axis":"z"})"));
    bench.run(parsed(R"({"op":"align","do":"ground"})"));
    const base::Box3f box = bench.document.surface().tree().bounds();
    QVERIFY(std::abs(box.lo.z) < 1e-5f && std::abs(box.centre().x) < 1e-5f);
    bench.run(parsed(R"({"op":"up","axis":"-y"})"));
    bench.run(parsed(R"({"op":"align","do":"ground"})"));
    QVERIFY(std::abs(bench.document.surface().tree().bounds().hi.y) < 1e-5f);
}

void TransformCommandTest::modelsThatLieFarComeToZeroAndBack() {
    Workbench bench;
    bench.run(openBall(bench, 1e7));
    const std::string opened = bench.hash();
    const base::Box3f first = bench.document.surface().tree().bounds();
    const auto places = [&] {
        const base::Box3f box = bench.document.surface().tree().bounds();
        const Vec3d origin = bench.document.provenance().origin;
        return std::pair(base::cast<double>(box.lo) + origin, base::cast<double>(box.hi) + origin);
    };
    bench.run(parsed(R"({"op":"transform","move":[-1e7,1e7,0]})"));
    QCOMPARE(bench.document.provenance().origin, Vec3d());
    QVERIFY(length(places().first + Vec3d{1, 1, 1}) < 0.01 && length(places().second - Vec3d{1, 1, 1}) < 0.01);
    const std::string moved = bench.hash();
    bench.run({{"op", "save"}, {"path", bench.path("moved.ply").string()}});
    Workbench again;
    again.run({{"op", "open"}, {"path", bench.path("moved.ply").string()}});
    QCOMPARE(again.hash(), moved);
    // Not only there: as far on the other side, where float32 alone would tell no neighbours apart.
    bench.run(parsed(R"({"op":"transform","move":[3e7,0,-2e7]})"));
    QVERIFY(length(places().first - Vec3d{3e7 - 1, -1, -2e7 - 1}) < 0.01);
    QVERIFY(length(bench.document.surface().tree().bounds().size() - first.size()) < 1e-6f);
    bench.run(parsed(R"({"op":"align","do":"centre"})"));
    QVERIFY(std::abs(places().first.x + places().second.x) < 1e-5);
    QVERIFY(std::abs(places().first.z + places().second.z) < 1e-5);
    for (int k = 0; k < 3; ++k)
        bench.run({{"op", "undo"}});
    QCOMPARE(bench.hash(), opened);
    bench.run({{"op", "redo"}});
    QCOMPARE(bench.hash(), moved);
}

void TransformCommandTest::oneRadiusForAllIsScaledAlong() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run(parsed(R"({"op":"surface","support":0.25})"));
    bench.run(parsed(R"({"op":"transform","scale":2})"));
    QVERIFY(std::abs(bench.document.surface().definition().support - 0.5f) < 1e-6f);
    QVERIFY(std::abs(bench.document.surface().tree().surfels().items[5].support - 0.5f) < 1e-6f);
}

void TransformCommandTest::sidesOfWhatIsThinDoNotMeet() {
    Workbench bench;
    bench.run(test::newSphere(2000));
    bench.run(parsed(R"({"op":"transform","stretch":[1,1,0.3],"about":[0,0,0]})"));
    const std::string hash = bench.hash();
    const auto refusal = [&](double length) { return bench.refusal({{"op", "inflate"}, {"length", length}}); };
    for (const double length : {-0.31, -0.5, -3.0}) // 0.6 thick in the middle, so 0.3 from each side
        QVERIFY2(refusal(length).find("both sides would meet") != std::string::npos, refusal(length).c_str());
    QCOMPARE(bench.hash(), hash);
    QCOMPARE(refusal(-0.02), std::string());
    bench.run({{"op", "undo"}});
    // One side alone has all of the way.
    bench.run(parsed(R"({"op":"select","by":"normal","direction":[0,0,1],"angle":30})"));
    QCOMPARE(refusal(-0.4), std::string());
    bench.run({{"op", "undo"}});
    QVERIFY(!refusal(-0.7).empty());
}

void TransformCommandTest::unitsAreSetByADistance() {
    Workbench bench;
    bench.run(openBall(bench, 1e7));
    const float before = bench.document.surface().tree().bounds().size().z;
    const surfel::Surfel one = bench.document.surface().tree().surfels().items[7];
    bench.run(parsed(R"({"op":"unit","from":[1e7,-1e7,-1],"to":[1e7,-1e7,1],"length":5})"));
    QVERIFY(std::abs(bench.document.surface().tree().bounds().size().z - 2.5f * before) < 1e-5f);
    QVERIFY(std::abs(bench.document.surface().tree().surfels().items[7].support - 2.5f * one.support) < 1e-5f);
    QCOMPARE(bench.context.figures.at("scale"), 2.5);
}

static const test::Registered<TransformCommandTest> registered;
#include "transform_command_test.moc"
