#include "core/process/samples/even_rows.h"

#include "core/base/parallel.h"

#include <numbers>

namespace process {

surfel::SurfelList sampleRows(const RowMaker& make, double area, std::size_t count) {
    // Hexagonal: area per point a^2 sqrt(3) / 2, rows a sqrt(3) / 2 apart.
    const double apart = std::sqrt(area / static_cast<double>(std::max<std::size_t>(count, 1)) * std::sqrt(3.0) / 2);
    const std::vector<Row> rows = make(apart);
    double total = 0;
    for (const Row& row : rows)
        total += row.length;

    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = std::move(layout);
    out.items.resize(count);
    std::vector<std::size_t> first(rows.size() + 1); // rounding what has accumulated keeps the sum exact
    double length = 0;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        length += rows[r].length;
        first[r + 1] = static_cast<std::size_t>(std::llround(static_cast<double>(count) * length / total));
    }
    base::parallelFor(rows.size(), 4, [&](std::size_t r) {
        const std::size_t n = first[r + 1] - first[r];
        const double step = rows[r].length / static_cast<double>(n), shift = r % 2 ? 0.75 : 0.25;
        for (std::size_t i = 0; i < n; ++i) {
            const RowPoint p = rows[r].at((static_cast<double>(i) + shift) * step);
            surfel::Surfel& s = out.items[first[r] + i];
            s.position = base::cast<float>(p.position);
            s.normal = base::cast<float>(p.normal);
        }
    });
    return out;
}

} // namespace process
