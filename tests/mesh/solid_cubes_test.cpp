// Marching cubes of closed surfaces: whatever the points, no boundary; the right topology where the points can tell it.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/check/check.h"
#include "core/mesh/check/self_intersections.h"
#include "core/mesh/marching/marching_cubes.h"
#include "mesh/solid_rows.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using base::Vec3d, mesh::Mesh, mesh::MarchingOptions, mesh::MarchingReport, mesh::Topology;

class SolidCubesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void solidsHaveNoBoundary_data();
    void solidsHaveNoBoundary();
    void normalsMayAllPointInwards();
    void partsThatLookInwardsEndNearBy();
    void partsThatRunIntoEachOtherBecomeOne();
    void gapsAreClosed();
    void threadsDoNotShow();
    void cancellingStops();
};

using solids::hows, solids::isClosed, solids::Row, solids::spacing, solids::topologyOf;

namespace {

std::vector<Row> rowsOf(base::Random& random) {
    std::vector<Row> out;
    out.push_back({"balls", solids::balls(random), true});
    out.push_back({"fins of 0.6", solids::comb(0.6 * spacing, 2 * spacing), false});
    out.push_back({"fins of 1.5", solids::comb(1.5 * spacing, 2 * spacing), false});
    out.push_back({"fins of 3", solids::comb(3 * spacing, 3 * spacing), true});
    out.push_back({"shell of 1", solids::shell(spacing), false});
    out.push_back({"shell of 3", solids::shell(3 * spacing), true});
    out.push_back({"slabs of 1", solids::crossedSlabs(spacing), false});
    out.push_back({"slabs of 3", solids::crossedSlabs(3 * spacing), true});
    out.push_back({"wedge of 20", {{solids::wedge(0.35, 0.8, 0.8)}, {}, 1, 0}, false});
    out.push_back({"wedge of 60", {{solids::wedge(1.05, 0.8, 0.8)}, {}, 1, 0}, true});
    out.push_back({"drilled", solids::drilled(0.15), true});
    out.push_back({"tori", solids::tori(), true});
    return out;
}

Mesh meshOf(const surface::Surface& surface, double cell, double adaptive = 0) {
    MarchingOptions options;
    options.cell = cell;
    options.adaptive = adaptive;
    MarchingReport report;
    return mesh::marchingCubes(surface, options, report);
}

} // namespace

void SolidCubesTest::solidsHaveNoBoundary_data() {
    base::Random random(test::seed());
    solids::addRows(rowsOf(random),
                    [](std::size_t i, std::size_t k) { return test::effort(5) == 5 || k == i % std::size(hows); });
}

/// At cells of 0.5, 1 and 2 spacings, of one size and of several, with the second pass for near sheets and without.
void SolidCubesTest::solidsHaveNoBoundary() {
    QFETCH(int, row);
    QFETCH(int, how);
    base::Random random(test::seed());
    const Row made = rowsOf(random)[std::size_t(row)];
    const surfel::SurfelList list = solids::sampled(made.solid, hows[how].sampling, random);
    struct Way {
        bool oneSheet;
        double cell, adaptive;
    };
    std::vector<Way> ways{{true, 1, 0.1}, {false, 1, 0}, {true, 2, 0}};
    if (!test::sanitized)
        ways.insert(ways.end(), {{true, 0.5, 0}, {false, 0.5, 0.1}});
    for (const auto& [oneSheet, cell, adaptive] : ways) {
        const surface::Surface surface = solids::surfaceOf(list, oneSheet);
        const auto where = "seed " + QByteArray::number(test::seed()) + (oneSheet ? " one sheet" : "") + " cell " +
                           QByteArray::number(cell) + " adaptive " + QByteArray::number(adaptive);
        Mesh m;
        try {
            m = meshOf(surface, cell * spacing, adaptive * spacing);
        } catch (const base::Error&) { // what is thinner than a cell may lie between its nodes
            QVERIFY2(!made.resolved && cell >= 1, where);
            continue;
        }
        const Topology t = topologyOf(m);
        QVERIFY2(isClosed(t), where);
        if (!made.resolved || !hows[how].kind)
            continue;
        QVERIFY2(t.components == made.solid.pieces, where + " " + QByteArray::number(t.components));
        QVERIFY2(t.genus() == made.solid.genus, where);
        QVERIFY2(adaptive > 0 || mesh::selfIntersections(m).empty(), where);
    }
}

void SolidCubesTest::normalsMayAllPointInwards() {
    surfel::SurfelList list = shapes::torus(1, 0.4, spacing, 3.5 * spacing);
    for (surfel::Surfel& s : list.items)
        s.normal = -s.normal;
    const Mesh m = meshOf(shapes::surfaceOf(list), spacing);
    QVERIFY(isClosed(topologyOf(m)));
    QCOMPARE(topologyOf(m).components, std::size_t(1));
    QCOMPARE(topologyOf(m).genus(), std::optional<long long>(1));
}

/// A ball that is inside out beside one that is not, as noise leaves some clouds: all space nearer to it was inside.
void SolidCubesTest::partsThatLookInwardsEndNearBy() {
    const double s = shapes::sphereSpacing(3000, 1);
    surfel::SurfelList list = shapes::sphere(3000, 1, 3.5 * s);
    for (surfel::Surfel each : shapes::sphere(750, 0.5, 3.5 * s).items) {
        each.position.x += static_cast<float>(1.5 + s);
        each.normal = -each.normal;
        list.items.push_back(each);
    }
    const Mesh m = meshOf(shapes::surfaceOf(list), s);
    QVERIFY(isClosed(topologyOf(m)));
    for (const Vec3d& p : m.positions)
        QVERIFY(std::min(length(p) - 1, length(p - Vec3d{1.5 + s, 0, 0}) - 0.5) < 4 * s);
}

/// Each with all its points, also those inside of the other; crumbs where they cross.
void SolidCubesTest::partsThatRunIntoEachOtherBecomeOne() {
    surfel::SurfelList list = shapes::sphere(3000, 1, 3.5 * shapes::sphereSpacing(3000, 1));
    for (std::size_t k = 0, n = list.size(); k < n; ++k) {
        surfel::Surfel other = list.items[k];
        other.position.x += 1.1f;
        list.items.push_back(other);
    }
    MarchingOptions options;
    options.finishing.dropSmall = true;
    MarchingReport report;
    const Mesh m = mesh::marchingCubes(shapes::surfaceOf(list), options, report);
    QVERIFY(isClosed(topologyOf(m)));
    QCOMPARE(topologyOf(m).components, std::size_t(1));
    QCOMPARE(topologyOf(m).genus(), std::optional<long long>(0));
    for (const Vec3d& p : m.positions)
        QVERIFY(std::min(length(p), length(p - Vec3d{1.1, 0, 0})) > 0.9);
}

/// A sphere whose points leave out a cap, as wide as several supports: bridged by a dent, not by a bulge.
void SolidCubesTest::gapsAreClosed() {
    const surfel::SurfelList all = shapes::sphere(4000, 1, 3.5 * shapes::sphereSpacing(4000, 1));
    surfel::SurfelList some;
    some.layout = all.layout;
    for (const surfel::Surfel& s : all.items)
        if (s.position.z < 0.85f)
            some.items.push_back(s);
    const Mesh m = meshOf(shapes::surfaceOf(some), shapes::sphereSpacing(4000, 1));
    QVERIFY(isClosed(topologyOf(m)));
    QCOMPARE(topologyOf(m).components, std::size_t(1));
    QCOMPARE(topologyOf(m).genus(), std::optional<long long>(0));
    std::size_t bridges = 0;
    for (std::size_t v = 0; v < m.positions.size(); ++v) {
        bridges += m.kinds[v] == mesh::VertexKind::Bridge ? 1 : 0;
        QVERIFY(length(m.positions[v]) < 1.15 && length(m.positions[v]) > 0.7);
    }
    QVERIFY(bridges > 10 && bridges < m.positions.size() / 10);
}

void SolidCubesTest::threadsDoNotShow() {
    base::Random random(test::seed());
    const surface::Surface surface =
        solids::surfaceOf(solids::sampled(solids::comb(1.5 * spacing, 2 * spacing), {spacing, 1, 0.1, 5, {}}, random));
    const int threads = base::threadCount();
    std::vector<Mesh> made;
    for (const int count : {1, 2}) {
        base::setThreadCount(count);
        made.push_back(meshOf(surface, spacing));
    }
    base::setThreadCount(threads);
    QVERIFY(made[0].positions == made[1].positions);
    QVERIFY(made[0].triangles == made[1].triangles);
}

void SolidCubesTest::cancellingStops() {
    const surface::Surface surface = shapes::surfaceOf(shapes::torus(1, 0.4, spacing, 3.5 * spacing));
    int steps = 0;
    std::atomic<bool> cancel = false;
    MarchingReport report;
    mesh::marchingCubes(surface, {}, report, {[&](double, std::string_view) { ++steps; }, &cancel});
    for (const int at : {1, 2, steps / 2, steps - 1}) {
        int count = 0;
        cancel = false;
        const base::Progress progress{[&](double, std::string_view) { cancel = ++count >= at; }, &cancel};
        QVERIFY_EXCEPTION_THROWN(mesh::marchingCubes(surface, {}, report, progress), base::Cancelled);
    }
}

static const test::Registered<SolidCubesTest> registered;
#include "solid_cubes_test.moc"
