#include "core/sculpt/sampling.h"

#include "core/process/resampling/resample.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace sculpt {

/// Where resampling is due somewhere, blocks beyond these are done with it.
constexpr StretchRange doneBeyond{0.75f, 1.2f};
/// Two even the sampling nearly as well as three.
constexpr int sweeps = 2;
/// Balls are united while that makes none larger than this.
constexpr float unitedGrowth = 1.25f;

void Sampling::start(const surface::Surface& surface, const base::Vec3f& contact, bool graded) {
    m_graded = graded && surface.definition().support <= 0;
    m_spacing = process::localSpacing(surface, contact);
}

bool restructures(const tree::Edit& edit) {
    return !edit.inserted.items.empty() ||
           std::any_of(edit.blocks.begin(), edit.blocks.end(), [](const auto& each) { return each.removed.any(); });
}

void Sampling::note(const tree::SurfelTree& before, const tree::Edit& edit, const Dab& dab) {
    if (edit.empty() || !started())
        return;
    const float move = m_stretches.note(before, edit, m_spacing);
    if (move == 0 && !restructures(edit))
        return; // colours and masks ask for no other sampling
    m_range = m_stretches.range();
    add({dab.centre + dab.move * 0.5f, dab.radius + move});
}

void Sampling::add(Ball ball) {
    if (!m_balls.empty()) {
        Ball& last = m_balls.back();
        const base::Vec3f apart = ball.centre - last.centre;
        const float gap = length(apart), united = 0.5f * (gap + ball.radius + last.radius);
        if (gap + ball.radius <= last.radius)
            return;
        if (gap + last.radius <= ball.radius) {
            last = ball;
            return;
        }
        if (united <= unitedGrowth * ball.radius) {
            last = {last.centre + apart * ((united - last.radius) / gap), united};
            return;
        }
    }
    m_balls.push_back(ball);
}

tree::Selection Sampling::touched(const tree::SurfelTree& tree) const {
    std::map<std::uint32_t, std::bitset<surfel::blockCapacity>> all;
    for (const Ball& ball : m_balls)
        tree.forBlocksInBall(ball.centre, ball.radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
            auto& slots = all[number];
            if (slots.count() == static_cast<std::size_t>(block.size()))
                return;
            for (int slot = 0; slot < block.size(); ++slot)
                if (distanceSq(block.position(slot), ball.centre) < ball.radius * ball.radius)
                    slots.set(static_cast<std::size_t>(slot));
        });
    tree::Selection out;
    for (const auto& [number, slots] : all)
        if (slots.any())
            out.push_back({number, slots});
    return out;
}

surface::Surface Sampling::resampled(const surface::Surface& surface, const tree::Selection& touched) const {
    process::ResampleOptions options;
    options.spacing = m_spacing;
    options.sweeps = sweeps;
    if (m_graded) {
        options.field =
            std::make_shared<process::SpacingField>(surface.tree(), process::spacingOf(surface.definition(), 1.0f));
        options.spacing = options.field->coarsest();
    }
    return {surface.tree().apply(process::resample(surface, touched, options)), surface.definition()};
}

surface::Surface Sampling::resampleDue(const surface::Surface& surface) {
    const tree::Selection where = m_stretches.take(surface.tree(), doneBeyond);
    m_range = m_stretches.range();
    return resampled(surface, where);
}

surface::Surface Sampling::resample(const surface::Surface& surface) {
    const surface::Surface out = resampled(surface, touched(surface.tree()));
    m_stretches.clear();
    m_range = {};
    m_balls.clear();
    return out;
}

} // namespace sculpt
