#include "core/sculpt/stroke/stroke_entrance.h"

namespace sculpt {

std::optional<Entrance> entranceAt(const Dabs& dabs, const StrokeSample& sample) {
    if (const auto touched = dabs.contact(sample.ray))
        return Entrance{sample, *touched};
    return {};
}

std::optional<Entrance> entranceBetween(const Dabs& dabs, const std::optional<StrokeSample>& from,
                                        const StrokeSample& to) {
    std::optional<Entrance> found = entranceAt(dabs, to);
    if (!found || !from)
        return found;
    constexpr int halvings = 16;
    float out = 0, in = 1;
    for (int k = 0; k < halvings; ++k) {
        const float middle = 0.5f * (out + in);
        const auto there = entranceAt(dabs, between(*from, to, middle));
        (there ? in : out) = middle;
        if (there)
            found = there;
    }
    return found;
}

} // namespace sculpt
