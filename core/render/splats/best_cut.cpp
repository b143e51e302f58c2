#include "core/render/splats/best_cut.h"

#include <algorithm>

namespace render {

using base::Vec3f;

namespace {

/// How much worse than a gap what is drawn beyond an edge is, for each radius that it is beyond.
constexpr float fringe = 100;
/// A cut is rounded to 32nds of a radius: by half of one it leaves no crack.
constexpr float slack = 0.5f / 32;

/// Places of a disc of radius 1, evenly over what is left of it beside an edge: where is which cut right?
std::vector<std::array<float, 2>> evenPlaces() {
    constexpr int count = 128;
    std::vector<std::array<float, 2>> out;
    for (int i = 0; i < count; ++i) { // golden-angle spiral
        const float r = cutRadius * std::sqrt((static_cast<float>(i) + 0.5f) / count);
        const float angle = 2.3999632f * static_cast<float>(i);
        out.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return out;
}

/// What a cut of a disc leaves out of its patch, and what it shows beyond the patch, which counts more: at an outline
/// that is a fringe, while others may cover what one disc leaves out.
float faultOf(const Vec3f& normal, float support, std::span<const CutLine> lines, CutCode code) {
    static const std::vector<std::array<float, 2>> places = evenPlaces();
    const DiscCut cut = discCut(normal, support, code);
    const Vec3f u = base::perpendicular(normal), v = cross(normal, u);
    float fault = 0;
    for (const auto& [x, y] : places) {
        const Vec3f at = u * x + v * y;
        const bool drawn = x * x + y * y <= cut.radius * cut.radius && dot(at, cut.direction) <= cut.part &&
                           (cut.second.part == 0 || dot(at, cut.second.direction) <= cut.second.part);
        float over = 0;
        for (const CutLine& line : lines)
            over = std::max(over, dot(at, line.direction) - line.part);
        if (over <= 0)
            fault += drawn ? 0.0f : 1.0f;
        else if (drawn && over > 2 * slack)
            fault += fringe * over * over;
    }
    return fault;
}

CutLine slackened(const CutLine& line) {
    return {line.direction, line.part + slack};
}

} // namespace

CutCode oneCut(const Vec3f& normal, const CutLine& at, Beside beside) {
    return cutCode(normal, at.direction, slackened(at).part, beside);
}

CutCode bestCut(const Vec3f& normal, float support, std::span<const CutLine> lines) {
    CutCode best = oneCut(normal, lines.front(), Beside::Tip);
    float least = faultOf(normal, support, lines, best);
    const auto consider = [&](CutCode other) {
        if (const float fault = faultOf(normal, support, lines, other); fault < least)
            least = fault, best = other;
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const Beside beside : {Beside::Edge, Beside::Corner, Beside::Tip})
            if (const CutCode one = oneCut(normal, lines[i], beside); one != wholeDisc)
                consider(one);
        for (std::size_t j = i + 1; j < lines.size(); ++j)
            consider(twoCutsCode(normal, support, slackened(lines[i]), slackened(lines[j])));
    }
    return best;
}

} // namespace render
