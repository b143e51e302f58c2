#include "core/mesh/cell_size.h"

#include "core/process/estimation/spacing_sample.h"

#include <algorithm>
#include <cmath>

namespace mesh {

double usualCell(const tree::SurfelTree& tree) {
    constexpr double most = 25, least = 4, enough = 1.5e6; // squares to a surfel, and of all
    double area = 0;
    const std::vector<process::SpacingSample> samples = process::sampleSpacing(tree);
    for (const process::SpacingSample& sample : samples)
        area += double(sample.spacing) * double(sample.spacing);
    const double mean = samples.empty() ? 0 : area / static_cast<double>(samples.size());
    const double each = std::clamp(enough / std::max(1.0, static_cast<double>(tree.size())), least, most);
    return std::max(double(process::typicalSpacing(tree)), std::sqrt(mean / each));
}

} // namespace mesh
