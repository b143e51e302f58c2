#include "core/mesh/cell_size.h"

#include "core/process/estimation/spacing.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/surface/definition.h"

#include <algorithm>
#include <cmath>

namespace mesh {

double usualCell(const tree::SurfelTree& tree) {
    constexpr double most = 25, least = 4, enough = 1.5e6; // squares to a surfel, and of all
    double area = 0;
    std::vector<float> spacings;
    for (const process::SpacingSample& sample : process::sampleSpacing(tree)) {
        spacings.push_back(sample.spacing);
        area += double(sample.spacing) * double(sample.spacing);
    }
    if (spacings.empty())
        return double(tree.maxSupport()) * surface::spacingOfUnit;
    const double mean = area / static_cast<double>(spacings.size());
    const double each = std::clamp(enough / std::max(1.0, static_cast<double>(tree.size())), least, most);
    return std::max(double(process::summarise(std::move(spacings)).median), std::sqrt(mean / each));
}

} // namespace mesh
