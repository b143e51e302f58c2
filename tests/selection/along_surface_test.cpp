// What goes along the surface, against brute force over all pairs: pieces, growing and shrinking, borders, rims.
#include "clouds.h"
#include "core/base/parallel.h"
#include "core/selection/flood.h"
#include "core/selection/links.h"
#include "core/selection/rims.h"
#include "core/selection/spread.h"
#include "support/registry.h"

#include <QTest>

using namespace selection;
using base::Vec3d;
using test::Place;

class AlongSurfaceTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void linksAreThoseOfAllPairs();
    void piecesAreWhatLinksReach();
    void thinWallsAreNotCrossed();
    void piecesEndAtCreases();
    void piecesEndAtCurvature();
    void growingIsTheShortestWay();
    void shrinkingIsGrowingOfTheRest();
    void theGrownCapOfABallIsACap();
    void bordersLieBesideWhatIsNotSelected();
    void rimsAreFoundAndToldApart();
    void threadsDoNotShow();
};

namespace {

struct Pairs {
    explicit Pairs(const surface::Surface& surface) {
        test::forSurfels(surface.tree(), [&](const Place& at, const surfel::Surfel& s) {
            index[at] = items.size();
            items.push_back(s), places.push_back(at);
        });
        const Links links(surface);
        for (std::size_t i = 0; i < items.size(); ++i)
            for (std::size_t j = 0; j < items.size(); ++j) {
                const float reach = links.lengthAt(std::max(items[i].support, items[j].support));
                const float sq = distanceSq(items[i].position, items[j].position);
                if (i != j && sq < reach * reach && dot(items[i].normal, items[j].normal) > -0.5f)
                    linked[i].push_back({j, std::sqrt(sq)});
            }
    }
    std::vector<surfel::Surfel> items;
    std::vector<Place> places;
    std::map<Place, std::size_t> index;
    std::map<std::size_t, std::vector<std::pair<std::size_t, float>>> linked;
};

/// A ball and a smaller one beside it.
surface::Surface twoBalls(std::uint64_t seed, int count) {
    base::Random random(seed);
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    for (int k = 0; k < count; ++k)
        for (const double size : {1.0, 0.4}) {
            const Vec3d u = random.unitVector();
            points.append(test::surfelAt(u * size + Vec3d{size < 1 ? 2.0 : 0.0, 0, 0}, u, 0.1), {});
        }
    return process::prepare(points, {});
}

/// The faces of a cube of side 2 in rows, exact normals.
surface::Surface cube(int rows) {
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            for (int i = 0; i < rows; ++i)
                for (int j = 0; j < rows; ++j) {
                    Vec3d p, n;
                    p[axis] = n[axis] = side;
                    p[(axis + 1) % 3] = -1 + (2 * i + 1.0) / rows;
                    p[(axis + 2) % 3] = -1 + (2 * j + 1.0) / rows;
                    points.append(test::surfelAt(p, n, 2.0 / rows), {});
                }
    return test::surfaceOf(points);
}

} // namespace

void AlongSurfaceTest::linksAreThoseOfAllPairs() {
    const surface::Surface ball = test::unevenBall(test::seed(), 400, 0.02);
    const Pairs pairs(ball);
    const Links links(ball);
    for (std::size_t i = 0; i < pairs.items.size(); ++i) {
        std::set<std::size_t> found, expected;
        const auto block = ball.tree().block(pairs.places[i].first);
        links.forEach(*block, pairs.places[i].second, [&](std::uint32_t number, const auto&, int slot, float) {
            found.insert(pairs.index.at({number, slot}));
        });
        if (pairs.linked.contains(i))
            for (const auto& [j, d] : pairs.linked.at(i))
                expected.insert(j);
        QVERIFY2(found == expected, test::seedText(test::seed()).c_str());
    }
}

void AlongSurfaceTest::piecesAreWhatLinksReach() {
    const surface::Surface balls = twoBalls(test::seed(), 600);
    const Pairs pairs(balls);
    const auto found = test::placesOf(flooded(balls, nearestTo(balls.tree(), {2.5, 0, 0})));
    std::set<std::size_t> reached;
    std::vector<std::size_t> next{pairs.index.at(*test::placesOf(nearestTo(balls.tree(), {2.5, 0, 0})).begin())};
    while (!next.empty()) {
        const std::size_t i = next.back();
        next.pop_back();
        if (!reached.insert(i).second || !pairs.linked.contains(i))
            continue;
        for (const auto& [j, d] : pairs.linked.at(i))
            next.push_back(j);
    }
    std::set<Place> expected;
    for (const std::size_t i : reached)
        expected.insert(pairs.places[i]);
    QVERIFY2(found == expected, test::seedText(test::seed()).c_str());
    QVERIFY(found.size() > 560 && found.size() <= 600); // the small ball, but for a random point far from all others
    const std::size_t large = tree::sizeOf(flooded(balls, nearestTo(balls.tree(), {-1, 0, 0})));
    QVERIFY(large > 560 && large <= 600);
    // From a sparse ball to what is twenty times as fine there is no gap.
    const surface::Surface uneven = test::unevenBall(test::seed(), 2000);
    QVERIFY(tree::sizeOf(flooded(uneven, nearestTo(uneven.tree(), {-1, 0, 0}))) > uneven.tree().size() * 97 / 100);
}

void AlongSurfaceTest::thinWallsAreNotCrossed() {
    surfel::SurfelList points = test::planePoints(30, 0.1);
    for (const surfel::Surfel& s : test::planePoints(30, 0.1).items)
        points.append(test::surfelAt(base::cast<double>(s.position) - Vec3d{0, 0, 0.03}, {0, 0, -1}, 0.1), {});
    const surface::Surface wall = test::surfaceOf(points);
    const auto piece = flooded(wall, nearestTo(wall.tree(), {0, 0, 1}));
    QCOMPARE(tree::sizeOf(piece), std::size_t(900));
    for (const auto& [block, slot] : test::placesOf(piece))
        QVERIFY(wall.tree().block(block)->normal(slot).z > 0);
}

void AlongSurfaceTest::piecesEndAtCreases() {
    const surface::Surface box = cube(20);
    QCOMPARE(tree::sizeOf(flooded(box, nearestTo(box.tree(), {0, 0, 1}))), std::size_t(2400));
    FloodLimits limits;
    limits.angleRad = 0.5;
    QCOMPARE(tree::sizeOf(flooded(box, nearestTo(box.tree(), {0, 0, 1}), limits)), std::size_t(400));
}

void AlongSurfaceTest::piecesEndAtCurvature() {
    // A ball of radius 0.4 grows out of a plane; only the plane is flat.
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    for (const surfel::Surfel& s : test::planePoints(60, 0.05).items)
        if (length(s.position) > 0.4f)
            points.append(s, {});
    for (const surfel::Surfel& s : test::spherePoints(800).items)
        if (s.position.z > 0)
            points.append(test::surfelAt(base::cast<double>(s.position) * 0.4, base::cast<double>(s.normal), 0.05), {});
    const surface::Surface bump = test::surfaceOf(points);
    FloodLimits limits;
    limits.curvature = 1;
    for (const auto& [block, slot] : test::placesOf(flooded(bump, nearestTo(bump.tree(), {-1.2, 0, 0}), limits)))
        QVERIFY(bump.tree().block(block)->position(slot).z < 0.1f);
    QCOMPARE(tree::sizeOf(flooded(bump, nearestTo(bump.tree(), {-1.2, 0, 0}))), bump.tree().size());
}

void AlongSurfaceTest::growingIsTheShortestWay() {
    for (const bool soft : {false, true}) {
        const surface::Surface ball = test::unevenBall(test::seed(), 300, 0.01);
        const surface::Surface start = test::withField(ball, [&](const surfel::Surfel& s) {
            return soft ? std::clamp(double(s.position.z), 0.0, 1.0) * (s.colour % 3) / 2 : s.position.z > 0.6f ? 1 : 0;
        });
        const float length = 0.35f;
        const Pairs pairs(start);
        std::vector<float> values, expected;
        for (const Place& at : pairs.places)
            values.push_back(test::selectionAt(start.tree(), at));
        expected = values;
        for (std::size_t i = 0; i < pairs.items.size(); ++i) { // distances from i by relaxing until nothing changes
            if (!(values[i] > 0))
                continue;
            std::vector<float> d(pairs.items.size(), std::numeric_limits<float>::infinity());
            d[i] = 0;
            for (std::set<std::size_t> open{i}; !open.empty();) {
                const std::size_t at = *open.begin();
                open.erase(open.begin());
                if (pairs.linked.contains(at))
                    for (const auto& [j, step] : pairs.linked.at(at))
                        if (d[at] + step < d[j] && d[at] + step <= length)
                            d[j] = d[at] + step, open.insert(j);
            }
            for (std::size_t j = 0; j < d.size(); ++j)
                if (d[j] <= length)
                    expected[j] = std::max(expected[j], values[i]);
        }
        const tree::SurfelTree found = grown(start, Field::Selection, double(length));
        for (std::size_t j = 0; j < expected.size(); ++j)
            QVERIFY2(test::selectionAt(found, pairs.places[j]) == expected[j], test::seedText(test::seed()).c_str());
    }
}

void AlongSurfaceTest::shrinkingIsGrowingOfTheRest() {
    const surface::Surface ball = test::unevenBall(test::seed(), 1000, 0.01);
    const surface::Surface start = test::withField(ball, [](const surfel::Surfel& s) { return s.position.z > 0.2f; });
    const surface::Surface rest = test::withField(ball, [](const surfel::Surfel& s) { return !(s.position.z > 0.2f); });
    const tree::SurfelTree less = shrunk(start, Field::Selection, 0.3), more = grown(rest, Field::Selection, 0.3);
    QVERIFY(!selectedIn(less).empty());
    test::forSurfels(less, [&](const Place& at, const surfel::Surfel&) {
        QCOMPARE(test::selectionAt(less, at), 1 - test::selectionAt(more, at));
    });
}

void AlongSurfaceTest::theGrownCapOfABallIsACap() {
    const surface::Surface ball = test::surfaceOf(test::spherePoints(8000));
    const surface::Surface start = test::withField(ball, [](const surfel::Surfel& s) { return s.position.z > 0.9f; });
    const tree::SurfelTree found = grown(start, Field::Selection, 0.5);
    const double from = std::acos(0.9);
    test::forSurfels(found, [&](const Place& at, const surfel::Surfel& s) {
        const double along = std::acos(std::clamp(double(s.position.z), -1.0, 1.0)) - from;
        if (along < 0.44) // ways over links are a few percent longer than the surface's own
            QCOMPARE(test::selectionAt(found, at), 1.0f);
        if (along > 0.52)
            QCOMPARE(test::selectionAt(found, at), 0.0f);
    });
}

void AlongSurfaceTest::bordersLieBesideWhatIsNotSelected() {
    const surface::Surface ball = test::unevenBall(test::seed(), 400);
    const surface::Surface start = test::withField(ball, [](const surfel::Surfel& s) { return s.position.y > 0; });
    const Pairs pairs(start);
    std::set<Place> expected;
    for (const auto& [i, all] : pairs.linked)
        for (const auto& [j, d] : all)
            if (pairs.items[i].position.y > 0 && !(pairs.items[j].position.y > 0))
                expected.insert(pairs.places[i]);
    QVERIFY2(test::placesOf(borderOf(start)) == expected, test::seedText(test::seed()).c_str());
}

void AlongSurfaceTest::rimsAreFoundAndToldApart() {
    surfel::SurfelList points; // a ball without its caps: two loops of different lengths
    points.layout = test::orientedLayout();
    for (const surfel::Surfel& s : test::spherePoints(8000).items)
        if (s.position.z < 0.5f && s.position.z > -0.8f)
            points.append(s, {});
    surface::SurfaceDefinition definition;
    definition.boundary = surface::Boundary::Limit;
    definition.boundaryLimit = 0.25f;
    const surface::Surface band(tree::SurfelTree::build(points), definition);
    const auto reach = 2.3 * test::sphereSpacing(8000);
    const auto check = [&](const RimQuestion& question, bool upper, bool lower) {
        int found[2] = {0, 0};
        for (const auto& [block, slot] : test::placesOf(alongRims(band, question))) {
            const double z = double(band.tree().block(block)->position(slot).z);
            ++found[z > 0];
            QVERIFY(z > 0.5 - 2 * reach || z < -0.8 + 2 * reach);
        }
        QCOMPARE(found[1] > 50, upper);
        QCOMPARE(found[0] > 30, lower);
    };
    RimQuestion question;
    check(question, true, true);
    question.at = Vec3d{0, 0, -2};
    check(question, false, true);
    question.at = {};
    question.longest = 4.5; // the upper one is 5.4 long, the lower 3.8
    check(question, false, true);
    QVERIFY(alongRims(test::surfaceOf(test::spherePoints(500)), {}).empty());
}

void AlongSurfaceTest::threadsDoNotShow() {
    const surface::Surface ball = test::unevenBall(test::seed(), 2000);
    const surface::Surface start = test::withField(ball, [](const surfel::Surfel& s) { return s.position.z > 0; });
    std::string hashes[2];
    for (const int threads : {1, 2}) {
        base::setThreadCount(threads);
        hashes[threads - 1] = grown(start, Field::Selection, 0.2).contentHash().text() +
                              shrunk(start, Field::Selection, 0.2).contentHash().text() +
                              combined(start.tree(), flooded(ball, nearestTo(ball.tree(), {0, 0, 2})), Mode::Subtract)
                                  .contentHash()
                                  .text();
    }
    base::setThreadCount(0);
    QCOMPARE(hashes[0], hashes[1]);
}

static const test::Registered<AlongSurfaceTest> registered;
#include "along_surface_test.moc"
