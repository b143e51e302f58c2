#include "core/render/splats/complex_cuts.h"

#include "core/complexes/cell_frame.h"

#include <algorithm>

namespace render {

using base::Vec3d, base::Vec3f;

std::optional<ComplexCuts> ComplexCuts::of(const tree::SurfelTree& model, const surface::SurfaceDefinition& definition,
                                           float radiusOfSupport) {
    const auto complex = complexes::Complex::of({model, definition});
    if (!complex)
        return std::nullopt;
    ComplexCuts out(*complex, radiusOfSupport);
    out.m_word = model.layout()->find(surface::cellOfComplex)->firstWord;
    return out;
}

bool ComplexCuts::cut(const surfel::SurfelBlock& block, CutCodes& codes) const {
    bool any = false;
    for (int slot = 0; slot < block.size(); ++slot) {
        CutCode& code = codes[static_cast<std::size_t>(slot)];
        code = cutOf(block, slot);
        any |= code != wholeDisc;
    }
    return any;
}

CutCode ComplexCuts::cutOf(const surfel::SurfelBlock& block, int slot) const {
    constexpr int lanes = surfel::clusterSize;
    const std::uint32_t cell = block.words(slot / lanes, surfel::Extra + static_cast<int>(m_word))[slot % lanes];
    if (m_complex[cell].dimension < 2)
        return noDisc;
    const Vec3d p = base::cast<double>(block.position(slot));
    const Vec3f n = block.normal(slot);
    const double radius = static_cast<double>(m_radius) * static_cast<double>(block.support(slot));
    const complexes::CellFrame frame = frameOf(m_complex, cell, p, base::cast<double>(n));
    if (frame.attached.empty() || frame.attached.front().distance >= radius || lengthSq(n) < 0.25f)
        return wholeDisc;
    const auto tangential = [&](const Vec3d& to) {
        const Vec3f d = base::cast<float>(to - p);
        return normalized(d - n * dot(d, n));
    };
    const Vec3f direction = tangential(frame.attached.front().foot);
    if (direction == Vec3f{})
        return wholeDisc;
    // another curve that is near elsewhere leaves a small disc
    Beside beside = Beside::Edge;
    for (std::size_t k = 1; k < frame.attached.size(); ++k)
        if (const complexes::Attached& other = frame.attached[k];
            other.distance < static_cast<double>(cutRadius) * radius && dot(tangential(other.foot), direction) < 0.9f)
            beside = other.distance < 0.45 * radius ? Beside::Tip : Beside::Corner;
    return cutCode(n, direction, static_cast<float>(frame.attached.front().distance / radius), beside);
}

} // namespace render
