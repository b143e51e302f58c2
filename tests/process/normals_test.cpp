#include "core/process/estimation/normals.h"

#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/samples/samples.h"
#include "support/registry.h"

#include <QTest>

using namespace process;

class NormalsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void planesAreExact();
    void spheresAndToriAreWithinAHundredthOfARadian();
    void noiseTurnsThemLittle();
    void duplicatesDoNotMatter();
    void orientationOfEvenSamplesIsPerfect_data();
    void orientationOfEvenSamplesIsPerfect();
    void orientationCrossesSharpEdges();
    void everyComponentLooksOutward();
    void sheetsLookUpOrAtTheViewer_data();
    void sheetsLookUpOrAtTheViewer();
    void patchesLookAwayFromTheRest();
    void simulatedScanAgreesWithItsNeighbours();
    void surfacesWithoutTwoSidesStayUnoriented();
    void signsAreThoseOfKruskalOverAllEdges();
    void flagsSayWhatIsKnown();
    void sameBitsAtAnyThreadCount();
    void degenerateInputGivesUnitNormals();
    void cancelStops();
};

static surfel::SurfelList withoutNormals(surfel::SurfelList list) {
    for (auto& s : list.items)
        s.normal = {};
    list.layout = surfel::AttributeLayout::none();
    return list;
}

static surfel::SurfelList with(const std::vector<base::Vec3f>& positions) {
    surfel::SurfelList list;
    for (const auto& p : positions) {
        list.items.push_back({});
        list.items.back().position = p;
    }
    return list;
}

static float angle(const base::Vec3f& a, const base::Vec3f& b) {
    return std::atan2(length(cross(a, b)), std::abs(dot(a, b)));
}

void NormalsTest::planesAreExact() {
    base::Random random(test::seed());
    const base::Vec3f n = base::cast<float>(random.unitVector()), u = base::perpendicular(n), v = cross(n, u);
    std::vector<base::Vec3f> positions;
    for (int i = 0; i < 3000; ++i)
        positions.push_back(static_cast<float>(random.uniform(-1, 1)) * u +
                            static_cast<float>(random.uniform(-1, 1)) * v);
    auto list = with(positions);
    estimateNormals(list);
    for (const auto& s : list.items)
        QVERIFY2(angle(s.normal, n) < 1e-4f, qPrintable(QString("seed %1").arg(test::seed())));
}

void NormalsTest::spheresAndToriAreWithinAHundredthOfARadian() {
    for (const char* id : {"sphere", "torus"}) {
        const auto exact = sample(id).make(10000, 1);
        auto list = withoutNormals(exact);
        estimateNormals(list);
        float worst = 0;
        for (std::size_t i = 0; i < list.size(); ++i)
            worst = std::max(worst, angle(list.items[i].normal, exact.items[i].normal));
        QVERIFY2(worst < 0.01f, qPrintable(QString("%1 %2").arg(id).arg(worst)));
    }
}

void NormalsTest::noiseTurnsThemLittle() {
    const auto exact = sample("sphere").make(10000, 1); // spacing 0.035
    auto list = withoutNormals(exact);
    base::Random random(test::seed());
    for (auto& s : list.items)
        s.position += base::cast<float>(random.unitVector() * 0.005);
    estimateNormals(list);
    double sum = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
        sum += static_cast<double>(angle(list.items[i].normal, exact.items[i].normal));
    QVERIFY2(sum / 10000 < 0.05, qPrintable(QString::number(sum / 10000)));
}

void NormalsTest::duplicatesDoNotMatter() {
    auto list = withoutNormals(sample("torus").make(4000, 1)), doubled = list;
    for (int copy = 0; copy < 20; ++copy)
        for (std::size_t i = 0; i < list.size(); i += 3)
            doubled.items.push_back(list.items[i]);
    estimateNormals(list);
    orientNormals(list);
    estimateNormals(doubled);
    orientNormals(doubled);
    for (std::size_t i = 0; i < list.size(); ++i)
        QCOMPARE(doubled.items[i].normal, list.items[i].normal);
}

void NormalsTest::orientationOfEvenSamplesIsPerfect_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<int>("count");
    for (const char* id : {"sphere", "torus", "knot", "clay"})
        for (const int count : {2000, 40000})
            QTest::addRow("%s %d", id, count) << QString(id) << count;
}

void NormalsTest::orientationOfEvenSamplesIsPerfect() {
    QFETCH(QString, id);
    QFETCH(int, count);
    const auto exact = sample(id.toStdString()).make(static_cast<std::size_t>(count), 1);
    auto list = withoutNormals(exact);
    estimateNormals(list);
    base::Random random(test::seed());
    for (auto& s : list.items)
        s.normal = random.uniform() < 0.5 ? -s.normal : s.normal;
    orientNormals(list);
    for (std::size_t i = 0; i < list.size(); ++i)
        QVERIFY2(dot(list.items[i].normal, exact.items[i].normal) > 0, qPrintable(QString::number(i)));
}

void NormalsTest::orientationCrossesSharpEdges() {
    std::vector<base::Vec3f> positions, exact; // a cube, no point on its edges
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < 30; ++i)
            for (int j = 0; j < 30; ++j) {
                const float side = face % 2 ? 1.0f : -1.0f;
                const std::size_t axis = static_cast<std::size_t>(face / 2);
                base::Vec3f p, n;
                p[axis] = n[axis] = side;
                p[(axis + 1) % 3] = (static_cast<float>(i) - 14.5f) / 15;
                p[(axis + 2) % 3] = (static_cast<float>(j) - 14.5f) / 15;
                positions.push_back(p), exact.push_back(n);
            }
    auto list = with(positions);
    for (std::size_t i = 0; i < list.size(); ++i)
        list.items[i].normal = i % 3 ? exact[i] : -exact[i]; // exact but for the sign: n_a . n_b is 0 across edges
    orientNormals(list);
    for (std::size_t i = 0; i < list.size(); ++i)
        QVERIFY(dot(list.items[i].normal, exact[i]) > 0);
}

void NormalsTest::everyComponentLooksOutward() {
    const auto ball = sample("sphere").make(500, 1);
    surfel::SurfelList list;
    std::vector<base::Vec3f> exact;
    for (int k = 0; k < 27; ++k)
        for (surfel::Surfel s : ball.items) {
            exact.push_back(s.normal);
            s.position +=
                base::Vec3f{static_cast<float>(k % 3), static_cast<float>(k / 3 % 3), static_cast<float>(k / 9)} * 5.0f;
            list.items.push_back(s);
        }
    estimateNormals(list);
    orientNormals(list);
    for (std::size_t i = 0; i < list.size(); ++i)
        QVERIFY(dot(list.items[i].normal, exact[i]) > 0);
}

void NormalsTest::sheetsLookUpOrAtTheViewer_data() {
    QTest::addColumn<int>("axis");
    QTest::addColumn<double>("bend");
    for (const int axis : {0, 1, 2})
        for (const double bend : {-0.15, 0.0, 0.15})
            QTest::addRow("axis %d, bent by %g", axis, bend) << axis << bend;
}

/// Waves on a plain, a hill or a crater, far from the origin as terrains are.
void NormalsTest::sheetsLookUpOrAtTheViewer() {
    QFETCH(int, axis);
    QFETCH(double, bend);
    base::Random random(test::seed());
    const double phase = random.uniform(0, 6);
    std::vector<base::Vec3f> positions;
    for (int i = 0; i < 4000; ++i) {
        const double u = random.uniform(-1, 1), v = random.uniform(-1, 1);
        const auto k = static_cast<std::size_t>(axis);
        base::Vec3d p;
        p[k] = 0.05 * std::sin(5 * u + phase) * std::cos(4 * v) - bend * (u * u + v * v);
        p[(k + 1) % 3] = u, p[(k + 2) % 3] = v;
        positions.push_back(base::cast<float>(p + base::Vec3d{30, 40, -20}));
    }
    auto list = with(positions);
    estimateNormals(list);
    orientNormals(list);
    for (const auto& s : list.items)
        QVERIFY2(s.normal[static_cast<std::size_t>(axis)] > 0, qPrintable(QString("seed %1").arg(test::seed())));
}

/// Six plates where the sides of a cube are: seen alone none has an outside.
void NormalsTest::patchesLookAwayFromTheRest() {
    base::Random random(test::seed());
    std::vector<base::Vec3f> positions, exact;
    for (std::size_t k = 0; k < 3; ++k)
        for (const float side : {-1.0f, 1.0f})
            for (int i = 0; i < 900; ++i) {
                base::Vec3f p, n;
                p[k] = 2 * side, n[k] = side;
                p[(k + 1) % 3] = static_cast<float>(random.uniform(-1, 1));
                p[(k + 2) % 3] = static_cast<float>(random.uniform(-1, 1));
                positions.push_back(p), exact.push_back(n);
            }
    auto list = with(positions);
    estimateNormals(list);
    orientNormals(list);
    for (std::size_t i = 0; i < list.size(); ++i)
        QVERIFY2(dot(list.items[i].normal, exact[i]) > 0, qPrintable(QString("seed %1").arg(test::seed())));
}

void NormalsTest::simulatedScanAgreesWithItsNeighbours() {
    auto list = sample("scan").make(30000, 1);
    estimateNormals(list);
    orientNormals(list);
    // Outward at the top of every direction, and the flux of a constant field small against the area.
    base::Random random(test::seed());
    for (int k = 0; k < 50; ++k) {
        const base::Vec3f d = base::cast<float>(random.unitVector());
        if (d.y < -0.2f)
            continue; // unseen from below
        const auto top = std::max_element(list.items.begin(), list.items.end(), [&](const auto& a, const auto& b) {
            return dot(a.position, d) < dot(b.position, d);
        });
        QVERIFY2(dot(top->normal, d) > 0, qPrintable(QString("seed %1").arg(test::seed())));
    }
}

/// At any sampling, and with the strip's normals as they came; a strip cut across is a band with two sides.
void NormalsTest::surfacesWithoutTwoSidesStayUnoriented() {
    for (const std::size_t count : {300, 3000, 30000}) {
        auto strip = sample("moebius").make(count, 1);
        estimateNormals(strip);
        const auto before = strip.items;
        QVERIFY(!orientNormals(strip));
        QVERIFY(strip.layout->normals && !strip.layout->oriented);
        QVERIFY(strip.items == before);
        std::erase_if(strip.items,
                      [](const surfel::Surfel& s) { return s.position.x > 0 && std::abs(s.position.z) < 0.15f; });
        QVERIFY(orientNormals(strip));
        QVERIFY(strip.layout->oriented);
    }
}

/// Of an edge, as process/README 2.2 has it: its class and whether it flips.
static std::pair<int, bool> comparedAlong(const base::Vec3f& a, const base::Vec3f& na, const base::Vec3f& b,
                                          const base::Vec3f& nb) {
    const base::Vec3f e = base::normalized(b - a);
    const float alongA = dot(na, e), alongB = dot(nb, e), arc = dot(na, nb) - 2 * alongA * alongB;
    const float steep = std::max(alongA * alongA, alongB * alongB);
    return {static_cast<int>(std::clamp(1 - std::abs(arc) * (1 - steep), 0.0f, 1.0f) * 16383), arc < 0};
}

/// How far a neighbour stands above or below the sheet, as part of its distance: nothing along an arc.
static float stepTo(const base::Vec3f& a, const base::Vec3f& na, const base::Vec3f& b, const base::Vec3f& nb) {
    const base::Vec3f e = base::normalized(b - a);
    return (dot(na, e) + (dot(na, nb) < 0 ? -dot(nb, e) : dot(nb, e))) / 2;
}

void NormalsTest::signsAreThoseOfKruskalOverAllEdges() {
    base::Random random(test::seed());
    surfel::SurfelList list = sample("torus").make(static_cast<std::size_t>(test::effort(40000)), 1);
    for (surfel::Surfel& s : list.items) // so noisy that signs depend on which edges are in the trees
        s.position += base::cast<float>(random.unitVector()) * 0.03f;
    const Cloud cloud(list.items);
    const std::size_t n = cloud.size();
    NeighbourTable links(n, 12);
    struct Edge {
        int unlike;
        std::uint32_t a, b;
        bool flip;
    };
    std::vector<Edge> edges;
    const std::vector<base::Vec3f> normals = normalsOf(cloud);
    std::vector<int> layered(n);
    Neighbours near;
    for (std::uint32_t i = 0; i < n; ++i) {
        cloud.nearest(i, 12, near);
        links.set(i, near.index);
        float sum = 0;
        for (const std::uint32_t j : near.index) {
            const float step = stepTo(cloud.positions()[i], normals[i], cloud.positions()[j], normals[j]);
            sum += step * step;
        }
        layered[i] = static_cast<int>(2 * sum / 12 * 16384);
        for (const std::uint32_t j : near.index) {
            const auto [unlike, flip] =
                comparedAlong(cloud.positions()[i], normals[i], cloud.positions()[j], normals[j]);
            edges.push_back({unlike, i, j, flip});
        }
    }
    for (Edge& edge : edges)
        edge.unlike = std::min((edge.unlike + std::max(layered[edge.a], layered[edge.b])) / 2, 16383);
    std::stable_sort(edges.begin(), edges.end(), [](const Edge& p, const Edge& q) { return p.unlike < q.unlike; });
    base::ParitySets trees(n);
    std::size_t against = 0;
    for (const Edge& edge : edges)
        against += trees.relate(edge.a, edge.b, edge.flip) ? 0 : 1;
    QVERIFY(against > n / 50); // else any tree would do
    for (const int threads : {1, 2}) {
        base::setThreadCount(threads);
        std::vector<base::Vec3f> oriented = normals;
        orient(cloud, links, oriented);
        for (std::uint32_t i = 0; i < n; ++i) {
            const auto [root, opposite] = trees.find(i);
            const bool turned = oriented[i] != normals[i], rootTurned = oriented[root] != normals[root];
            QVERIFY2((turned != rootTurned) == opposite,
                     qPrintable(QString("point %1, seed %2").arg(i).arg(test::seed())));
        }
    }
    base::setThreadCount(0);
}

void NormalsTest::flagsSayWhatIsKnown() {
    auto list = withoutNormals(sample("sphere").make(500, 1));
    estimateNormals(list);
    QVERIFY(list.layout->normals && !list.layout->oriented);
    orientNormals(list);
    QVERIFY(list.layout->normals && list.layout->oriented);
    QVERIFY(!surfel::AttributeLayout::none()->normals);
}

void NormalsTest::sameBitsAtAnyThreadCount() {
    auto one = sample("scan").make(20000, test::seed()), two = one;
    base::setThreadCount(1);
    estimateNormals(one);
    orientNormals(one);
    base::setThreadCount(0);
    estimateNormals(two);
    orientNormals(two);
    QVERIFY(one.items == two.items);
}

void NormalsTest::degenerateInputGivesUnitNormals() {
    std::vector<base::Vec3f> line;
    for (int i = 0; i < 100; ++i)
        line.push_back({static_cast<float>(i), 2, 3});
    for (auto list :
         {with({}), with({{1, 2, 3}}), with({{1, 2, 3}, {1, 2, 3}}), with({{0, 0, 0}, {1, 0, 0}}), with(line)}) {
        estimateNormals(list);
        orientNormals(list);
        for (const auto& s : list.items)
            QVERIFY(std::abs(length(s.normal) - 1) < 1e-5f);
    }
}

void NormalsTest::cancelStops() {
    auto list = sample("sphere").make(20000, 1);
    std::atomic<bool> cancel = false;
    base::Progress progress{{}, &cancel};
    progress.report = [&](double done, std::string_view) { cancel = done > 0.5; };
    QVERIFY_EXCEPTION_THROWN(estimateNormals(list, 18, progress), base::Cancelled);
}

static const test::Registered<NormalsTest> registered;
#include "normals_test.moc"
