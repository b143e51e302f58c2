// Regions against a look at every surfel: random models, random balls, boxes, planes and lassos.
#include "clouds.h"
#include "core/selection/view_region.h"
#include "support/registry.h"

#include <QTest>

using namespace selection;
using base::Outline;
using base::Point2;
using base::Vec3d;

class RegionsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void regionsHoldWhatBruteForceFinds();
    void lassosHoldWhatBruteForceFinds_data();
    void lassosHoldWhatBruteForceFinds();
    void visibleIsWhatFacesTheEyeOfABall();
    void whatStandsBehindIsNotVisible();
};

template <class Region>
static void compare(const tree::SurfelTree& tree, const Region& region, const std::string& what) {
    const auto expected =
        test::those(tree, [&](const surfel::Surfel& s) { return region.holds(base::cast<double>(s.position)); });
    QVERIFY2(test::placesOf(within(tree, region)) == test::placesOf(expected), what.c_str());
}

static Vec3d around(base::Random& random, double size) {
    return random.unitVector() * (size * random.uniform());
}

void RegionsTest::regionsHoldWhatBruteForceFinds() {
    base::Random random(test::seed());
    for (const double offset : {0.0, 1000.0}) {
        const Vec3d centre{offset, -offset, 0.5 * offset};
        const surface::Surface ball = test::unevenBall(test::seed(), 3000, 0.05, centre);
        for (int round = 0; round < test::effort(20); ++round) {
            const Vec3d at = centre + around(random, 1.5), other = at + around(random, 2);
            base::Box3d box;
            box.extend(at), box.extend(other);
            const std::string what = test::seedText(test::seed()) + ", round " + std::to_string(round);
            compare(ball.tree(), BallRegion{at, 2 * random.uniform()}, what);
            compare(ball.tree(), BoxRegion{box}, what);
            const Vec3d n = random.unitVector();
            compare(ball.tree(), PlaneRegion{{n, dot(n, at)}}, what);
        }
    }
}

static std::vector<Point2> randomLasso(base::Random& random, std::size_t corners, bool crossing) {
    std::vector<Point2> out;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(corners);
        const double r = 40 + 160 * random.uniform();
        out.push_back(crossing ? Point2{400 * random.uniform(), 300 * random.uniform()}
                               : Point2{200 + r * std::cos(angle), 150 + r * std::sin(angle)});
    }
    return out;
}

void RegionsTest::lassosHoldWhatBruteForceFinds_data() {
    QTest::addColumn<bool>("parallel");
    QTest::addColumn<double>("distance"); // of the eye
    QTest::newRow("perspective") << false << 4.0;
    QTest::newRow("inside the model") << false << 0.4;
    QTest::newRow("parallel") << true << 4.0;
    QTest::newRow("parallel, eye inside") << true << 0.2;
}

void RegionsTest::lassosHoldWhatBruteForceFinds() {
    QFETCH(bool, parallel);
    QFETCH(double, distance);
    base::Random random(test::seed());
    const surface::Surface ball = test::unevenBall(test::seed(), 4000, 0.02);
    for (int round = 0; round < test::effort(15); ++round) {
        render::Camera camera;
        camera.width = 400, camera.height = 300;
        camera.eye = random.unitVector() * distance;
        camera.target = around(random, 0.1);
        camera.up = random.unitVector();
        camera.orthoHeight = parallel ? 2.5 : 0;
        const std::vector<Point2> corners = randomLasso(random, 3 + random.below(200), round % 3 == 0);
        const Outline lasso(corners);
        ViewRegion region(camera, lasso);
        if (round % 2)
            region.nearest = distance - 0.5, region.farthest = distance + 0.5 * random.uniform();
        const auto expected = test::those(ball.tree(), [&](const surfel::Surfel& s) {
            const Vec3d p = camera.project(base::cast<double>(s.position));
            return p.z > 0 && p.z >= region.nearest && p.z <= region.farthest && lasso.holds({p.x, p.y});
        });
        const std::string what = test::seedText(test::seed()) + ", round " + std::to_string(round);
        QVERIFY2(test::placesOf(within(ball.tree(), region)) == test::placesOf(expected), what.c_str());
    }
}

static render::Camera facingBall(double distance) {
    render::Camera camera;
    camera.eye = {0, 0, distance};
    camera.width = camera.height = 400;
    return camera;
}

static const std::vector<Point2> wholePicture{{-1e4, -1e4}, {1e4, -1e4}, {1e4, 1e4}, {-1e4, 1e4}};

void RegionsTest::visibleIsWhatFacesTheEyeOfABall() {
    for (const bool parallel : {false, true}) {
        render::Camera camera = facingBall(4);
        camera.orthoHeight = parallel ? 3 : 0;
        const surface::Surface ball = test::surfaceOf(test::spherePoints(2000));
        const auto through = within(ball.tree(), ViewRegion(camera, Outline(wholePicture)));
        QCOMPARE(tree::sizeOf(through), ball.tree().size());
        const auto seen = test::placesOf(visibleOf(ball, camera, through));
        test::forSurfels(ball.tree(), [&](const test::Place& at, const surfel::Surfel& s) {
            const Vec3d n = base::cast<double>(s.normal), p = base::cast<double>(s.position);
            const double cosine = parallel ? n.z : dot(n, normalized(camera.eye - p));
            if (std::abs(cosine) > 0.05) // the horizon itself is anybody's guess
                QCOMPARE(seen.contains(at), cosine > 0);
        });
    }
}

void RegionsTest::whatStandsBehindIsNotVisible() {
    surfel::SurfelList points = test::spherePoints(1500);
    for (const surfel::Surfel& s : test::spherePoints(1500).items) {
        surfel::Surfel behind = s;
        behind.position = behind.position * 0.7f + base::Vec3f{0, 0, -3};
        behind.support *= 0.7f;
        points.append(behind, {});
    }
    const surface::Surface both = test::surfaceOf(points);
    const render::Camera camera = facingBall(6);
    const auto seen = visibleOf(both, camera, within(both.tree(), ViewRegion(camera, Outline(wholePicture))));
    QVERIFY(tree::sizeOf(seen) > 400);
    for (const auto& [block, slot] : test::placesOf(seen))
        QVERIFY(both.tree().block(block)->position(slot).z > -1.1f);
}

static const test::Registered<RegionsTest> registered;
#include "regions_test.moc"
