#include "core/sculpt/stroke/stroke.h"

#include "core/base/error.h"
#include "core/sculpt/seam_snap.h"
#include "core/sculpt/stroke/stroke_methods.h"
#include "core/sculpt/stroke/stroke_stabiliser.h"

#include <cmath>

namespace sculpt {

static StrokeSample checked(StrokeSample sample) {
    const float length = base::length(sample.ray.direction);
    if (!isFinite(sample.ray.origin) || !(length > 0) || !std::isfinite(length))
        throw base::Error("a sample's ray is not finite or has no direction", "stroke",
                          "give origin and direction of each sample");
    if (!(sample.pressure >= 0 && sample.pressure <= 1))
        throw base::Error("a sample's pressure is not between 0 and 1", "stroke");
    if (!std::isfinite(sample.seconds))
        throw base::Error("a sample's time is not finite", "stroke");
    if (!(sample.stride >= 1 && sample.stride <= StrokeSample::maxStride))
        throw base::Error("a sample's stride is not between 1 and 10", "stroke");
    if (!(sample.reach >= 0) || !std::isfinite(sample.reach))
        throw base::Error("a sample's reach is not a length", "stroke");
    sample.ray.direction = sample.ray.direction / length;
    return sample;
}

/// What depends on the first and the last sample alone must not depend on those between: no rope.
static float ropeOf(const StrokeSettings& settings) {
    return lastOnly(settings) ? 0.0f : settings.stabiliser * settings.radius;
}

struct Stroke::State {
    Dabs dabs;
    Stabiliser stabiliser;
    std::unique_ptr<Method> method;
    std::optional<SeamSnap> snap;          ///< from the first sample on, where asked for
    std::optional<surface::Surface> shown; ///< with what waits, once somebody asks

    State(surface::Surface start, const StrokeSettings& settings, const base::Vec3d& origin,
          std::shared_ptr<const BrushStamp> stamp, const std::atomic<bool>* cancel)
        : dabs(std::move(start), settings, origin, std::move(stamp), cancel), stabiliser(ropeOf(settings)),
          method(makeMethod(dabs, tool(settings.tool).motion)) {}
};

Stroke::Stroke(surface::Surface start, StrokeSettings settings, base::Vec3d origin,
               std::shared_ptr<const BrushStamp> stamp, const std::atomic<bool>* cancel) {
    check(settings);
    m_state = std::make_unique<State>(std::move(start), settings, origin, std::move(stamp), cancel);
}
Stroke::~Stroke() = default;
Stroke::Stroke(Stroke&&) noexcept = default;
Stroke& Stroke::operator=(Stroke&&) noexcept = default;

void Stroke::onLayers(std::shared_ptr<const layers::Stack> stack) {
    m_state->dabs.onLayers(std::move(stack));
}

bool Stroke::add(const StrokeSample& sample) {
    StrokeSample unit = checked(sample);
    if (const StrokeSettings& settings = m_state->dabs.settings(); settings.snap > 0) {
        if (!m_state->snap)
            m_state->snap.emplace(m_state->dabs.surface(), settings.snap * settings.radius);
        unit.ray = m_state->snap->snapped(unit.ray);
    }
    const tree::SurfelTree before = m_state->dabs.surface().tree();
    const int count = dabs();
    const bool waited = m_state->method->waits();
    m_state->shown.reset();
    const std::vector<Stabiliser::Step> steps = m_state->stabiliser.followAll(unit, m_state->dabs.depth());
    if (m_state->dabs.settings().method != StrokeMethod::Dots || holds(tool(m_state->dabs.settings().tool)))
        for (std::size_t k = 0; k + 1 < steps.size(); ++k)
            m_state->method->add(steps[k].sample, steps[k].moved);
    m_state->method->add(steps.back().sample, steps.back().moved);
    return dabs() != count || waited || m_state->method->waits() || !(m_state->dabs.surface().tree() == before);
}
void Stroke::finish() {
    while (!finishSlice()) {
    }
}
bool Stroke::finishSlice() {
    m_state->shown.reset();
    m_state->method->finish(); // what waits is done in the first
    return m_state->dabs.finishSlice();
}

const surface::Surface& Stroke::surface() const {
    if (!m_state->shown && m_state->method->waits())
        m_state->shown = m_state->dabs.preview(m_state->method->waiting());
    return m_state->shown ? *m_state->shown : m_state->dabs.surface();
}
std::optional<float> Stroke::depth() const {
    return m_state->dabs.depth();
}
int Stroke::dabs() const {
    return m_state->dabs.count();
}
std::span<const double> Stroke::dabSeconds() const {
    return m_state->dabs.seconds();
}

} // namespace sculpt
