// What tests of closed meshes have in common: solids as rows, the ways they are sampled, and what closed means.
#pragma once

#include "core/mesh/check/topology.h"
#include "mesh/solids.h"

#include <QTest>

namespace solids {

constexpr double spacing = 0.06;

struct Row {
    const char* name;
    Solid solid;
    bool resolved; ///< by the points, so that its topology comes out
};

struct How {
    const char* name;
    Sampling sampling;
    bool kind; ///< topology may be asked for
};

inline const How hows[] = {{"even", {spacing, 1, 0, 0, {}}, true},
                           {"noisy", {spacing, 1, 0.1, 0, {}}, true},
                           {"uneven", {0.5 * spacing, 4.47, 0, 0, {}}, false},
                           {"strays", {spacing, 1, 0, 5, {}}, false},
                           {"far", {spacing, 1, 0, 0, {2000, -1000, 500}}, true}};

/// A test row `row`, `how` for each solid and way of sampling whose numbers `chosen` takes.
template <class Chosen>
void addRows(const std::vector<Row>& rows, const Chosen& chosen) {
    QTest::addColumn<int>("row");
    QTest::addColumn<int>("how");
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < std::size(hows); ++k)
            if (chosen(i, k))
                QTest::addRow("%s, %s", rows[i].name, hows[k].name) << int(i) << int(k);
}

inline mesh::Topology topologyOf(const mesh::Mesh& m) {
    return mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
}

inline bool isClosed(const mesh::Topology& t) {
    return t.manifold() && t.boundaryEdges == 0 && t.opposedEdges == 0 && t.improper == 0;
}

} // namespace solids
