#include "core/surface/points_by_cell.h"

#include "core/base/error.h"

#include <string>

namespace surface {

std::vector<std::vector<std::uint32_t>> pointsByCell(const surfel::SurfelList& points, std::size_t cells) {
    const surfel::Attribute* of = points.layout->find(cellOfComplex);
    if (!of)
        throw base::Error("the points do not tell which cells of the complex they belong to", {},
                          std::string("give each a number ") + cellOfComplex);
    std::vector<std::vector<std::uint32_t>> out(cells);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const double cell = surfel::read(*of, points.extraOf(i));
        if (!(cell >= 0 && cell < static_cast<double>(cells)))
            throw base::Error("a point belongs to no cell of the complex, which has " + std::to_string(cells), {},
                              std::string("correct its ") + cellOfComplex);
        out[static_cast<std::size_t>(cell)].push_back(i);
    }
    return out;
}

} // namespace surface
