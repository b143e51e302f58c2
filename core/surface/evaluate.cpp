#include "core/surface/evaluate.h"

#include "core/surface/assemble.h"

namespace surface {

Evaluationf evaluateIn(const Surface& surface, ClusterSpan clusters, const base::Vec3f& x, Need need,
                       const Hint& hint) {
    if (need == Need::Value)
        return Assembler<float, 0>(surface, clusters, x, hint).run();
    return Assembler<float, 1>(surface, clusters, x, hint).run();
}

Evaluationd evaluateIn(const Surface& surface, ClusterSpan clusters, const base::Vec3d& x, Need need,
                       const Hint& hint) {
    switch (need) {
    case Need::Value:
        return Assembler<double, 0>(surface, clusters, x, hint).run();
    case Need::Gradient:
        return Assembler<double, 1>(surface, clusters, x, hint).run();
    case Need::Hessian:
        break;
    }
    return Assembler<double, 2>(surface, clusters, x, hint).run();
}

} // namespace surface
