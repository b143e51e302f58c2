#include "core/sculpt/sampling.h"

#include "core/base/parallel.h"
#include "core/process/resample.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

/// In spacings: between the 3 and 5 that RESAMPLING found equal.
constexpr float travelLimit = 4;
constexpr float stretchLimit = 1.5f;
/// Steepest slope of the falloffs that have one, in weights per radius; others count as this.
constexpr float steepest = 2;
/// Balls are united while that makes none larger than this.
constexpr float unitedGrowth = 1.25f;

void Sampling::start(const surface::Surface& surface, const base::Vec3f& contact) {
    m_spacing = process::localSpacing(surface, contact);
}

bool restructures(const tree::Edit& edit) {
    return !edit.inserted.items.empty() ||
           std::any_of(edit.blocks.begin(), edit.blocks.end(), [](const auto& each) { return each.removed.any(); });
}

static float largestMove(const tree::SurfelTree& before, const tree::Edit& edit) {
    std::vector<float> moves(edit.blocks.size(), 0.0f);
    base::parallelFor(moves.size(), 16, [&](std::size_t i) {
        if (!edit.blocks[i].changed)
            return;
        const surfel::BlockPtr old = before.block(edit.blocks[i].block);
        const surfel::SurfelBlock& now = *edit.blocks[i].changed;
        for (int slot = 0; slot < now.size(); ++slot)
            moves[i] = std::max(moves[i], distanceSq(old->position(slot), now.position(slot)));
    });
    return moves.empty() ? 0.0f : std::sqrt(*std::max_element(moves.begin(), moves.end()));
}

void Sampling::note(const tree::SurfelTree& before, const tree::Edit& edit, const Dab& dab) {
    if (edit.empty() || !started())
        return;
    const float move = largestMove(before, edit);
    if (move == 0 && !restructures(edit))
        return; // colours and masks ask for no other sampling
    m_travel += move;
    m_stretch *= 1 + move * steepest / dab.radius;
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

bool Sampling::due() const {
    return m_travel > travelLimit * m_spacing || m_stretch > stretchLimit;
}

tree::Selection Sampling::touched(const tree::SurfelTree& tree) const {
    tree::Selection all;
    for (const Ball& ball : m_balls)
        tree.forBlocksInBall(ball.centre, ball.radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
            tree::SelectedBlock selected{number, {}};
            for (int slot = 0; slot < block.size(); ++slot)
                if (distanceSq(block.position(slot), ball.centre) < ball.radius * ball.radius)
                    selected.slots.set(static_cast<std::size_t>(slot));
            if (selected.slots.any())
                all.push_back(selected);
        });
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.block < b.block; });
    tree::Selection united;
    for (const tree::SelectedBlock& each : all)
        if (!united.empty() && united.back().block == each.block)
            united.back().slots |= each.slots;
        else
            united.push_back(each);
    return united;
}

surface::Surface Sampling::resample(const surface::Surface& surface) {
    process::ResampleOptions options;
    options.spacing = m_spacing;
    const tree::Edit edit = process::resample(surface, touched(surface.tree()), options);
    m_travel = 0;
    m_stretch = 1;
    m_balls.clear();
    return {surface.tree().apply(edit), surface.definition()};
}

} // namespace sculpt
