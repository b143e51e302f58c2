#include "core/mesh/cell_size.h"

#include "core/process/estimation/spacing_sample.h"

#include <algorithm>
#include <cmath>

namespace mesh {

double usualCell(const tree::SurfelTree& tree) {
    constexpr double most = 25; // squares to a surfel
    double area = 0;
    const std::vector<process::SpacingSample> samples = process::sampleSpacing(tree);
    for (const process::SpacingSample& each : samples)
        area += double(each.spacing) * double(each.spacing);
    const double mean = samples.empty() ? 0 : area / static_cast<double>(samples.size());
    return std::max(double(process::typicalSpacing(tree)), std::sqrt(mean / most));
}

} // namespace mesh
