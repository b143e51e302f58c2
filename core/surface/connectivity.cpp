#include "core/surface/connectivity.h"

#include "core/base/error.h"

#include <map>
#include <string>

namespace surface {

[[noreturn]] static void refuse(std::size_t cell, const std::string& what) {
    throw base::Error("cell " + std::to_string(cell) + " of the complex " + what, {},
                      "correct the file's element complex_cell");
}

/// Curves about a patch form closed loops: at every point that they end in, an even number of ends.
static void requireLoops(const Connectivity& connectivity, std::size_t patch) {
    std::map<std::uint32_t, int> ends;
    for (const std::uint32_t curve : connectivity.cells[patch].boundary)
        for (const std::uint32_t end : connectivity.cells[curve].boundary)
            ++ends[end];
    for (const auto& [end, count] : ends)
        if (count % 2 != 0)
            refuse(patch, "is bounded by curves that do not close at cell " + std::to_string(end));
}

void requireSound(const Connectivity& connectivity) {
    const std::vector<ComplexCell>& cells = connectivity.cells;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const ComplexCell& cell = cells[i];
        if (cell.dimension < 0 || cell.dimension > 2)
            refuse(i, "is neither a point nor a curve nor a patch: its dimension is " + std::to_string(cell.dimension));
        for (const std::uint32_t other : cell.boundary)
            if (other >= cells.size() || cells[other].dimension != cell.dimension - 1)
                refuse(i, "names cell " + std::to_string(other) + " as boundary, which is none of one dimension less");
        if (cell.dimension == 1 && cell.boundary.size() != 0 && cell.boundary.size() != 2)
            refuse(i, "is a curve with " + std::to_string(cell.boundary.size()) + " ends instead of none or two");
    }
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (cells[i].dimension == 2)
            requireLoops(connectivity, i);
    for (const PrescribedTangent& tangent : connectivity.tangents) {
        if (tangent.at >= cells.size() || cells[tangent.at].dimension > 1)
            throw base::Error("a tangent of the complex stands at cell " + std::to_string(tangent.at) +
                                  ", which is neither a curve nor a point",
                              {}, "correct the file's element complex_tangent");
        for (const std::uint32_t cell : tangent.cells)
            if (cell >= cells.size() || cells[cell].dimension <= cells[tangent.at].dimension)
                throw base::Error("a tangent of the complex binds cell " + std::to_string(cell) +
                                      ", which is not of a higher dimension than where it stands",
                                  {}, "correct the file's element complex_tangent");
    }
}

} // namespace surface
