// Cuts of one mesh again and again, with other vertices held each time: what is remembered of them does not show.
#include "core/mesh/finish/mesh_attributes.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/mesh/seams/crease_cut.h"

#include "cells/solids.h"
#include "support/registry.h"

#include <QTest>

class CreaseMemoryTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void cutsAreAsWithout();
};

void CreaseMemoryTest::cutsAreAsWithout() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(3); ++round) {
        const double spacing = random.uniform(0.12, 0.25);
        const auto solid = round % 2 == 0 ? plane_solids::lBlock(0.9) : plane_solids::polyhedron(random);
        const auto sampled = plane_solids::sampled(solid, 2.4, spacing, random);
        const surface::Surface surface = plane_solids::surfaceOf(sampled.surfels);
        const auto cells = cells::CellSurface::of(surface);
        QVERIFY(cells);
        mesh::MarchingOptions plain;
        plain.cell = random.uniform(0.7, 1.5) * spacing;
        plain.creases = false;
        mesh::MarchingReport report;
        const mesh::Mesh smooth = mesh::marchingCubes(surface, plain, report);
        std::vector<mesh::CreaseVertex> vertices = mesh::ontoFaces(*cells, smooth);
        std::vector<std::size_t> near; // creases
        for (std::size_t v = 0; v < vertices.size(); ++v)
            if (vertices[v].mixed)
                near.push_back(v);
        mesh::CreaseMemory memory;
        for (int cut = 0; cut < 3; ++cut) {
            mesh::CreaseMemory fresh;
            const mesh::CutMesh a = mesh::cutAtCreases(*cells, smooth, vertices, memory, {});
            const mesh::CutMesh b = mesh::cutAtCreases(*cells, smooth, vertices, fresh, {});
            const QString where = QString("seed %1, round %2, cut %3").arg(test::seed()).arg(round).arg(cut);
            QVERIFY2(a.mesh.positions == b.mesh.positions && a.mesh.triangles == b.mesh.triangles &&
                         a.cells == b.cells && a.between == b.between,
                     where.toUtf8());
            QVERIFY2(a.mesh.positions.size() > smooth.positions.size(), where.toUtf8());
            for (int k = 0; k < 20; ++k) {
                const std::size_t v = near[random.below(near.size())];
                vertices[v] = {{}, vertices[v].own, smooth.positions[v], smooth.normals[v], false};
            }
        }
    }
}

static const test::Registered<CreaseMemoryTest> registered;
#include "crease_memory_test.moc"
