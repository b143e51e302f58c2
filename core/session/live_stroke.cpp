#include "core/session/live_stroke.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/short_number.h"
#include "core/io/pictures/grey_image.h"
#include "core/selection/hidden.h"
#include "core/session/command.h"
#include "core/session/commands/commands.h"
#include "core/session/place_text.h"
#include "core/session/stroke_edges.h"
#include "core/session/stroke_json.h"
#include "core/surface/definition_text.h"

#include <nlohmann/json.hpp>

namespace session {

static surface::Surface startOf(const Context& context, const sculpt::StrokeSettings& settings) {
    requireModel(context);
    refuseChange(context.document.scene().models[context.document.scene().active]);
    sculpt::check(settings);
    if (context.document.surface().definition().manifold != surface::Manifold::Surface)
        throw base::Error("the model is " + surface::nounOf(context.document.surface().definition().manifold) +
                              ", which no tool sculpts",
                          {}, "set the surface option manifold to surface");
    const layers::Stack& stack = context.document.layers();
    if (!layers::takesStrokes(stack))
        throw base::Error("the layer \"" + stack.layers[static_cast<std::size_t>(stack.target())].name +
                              "\" does not show what would be sculpted on it",
                          {}, "show it, raise its strength, or make another layer the active one");
    if (sculpt::tool(settings.tool).needs.layer && stack.target() < 0)
        throw base::Error("there is no stored shape to go back to", {},
                          stack.empty() ? "add a layer first: it stores the shape, and strokes go into it"
                                        : "make the layer the active one whose strokes are to be taken back");
    if ((leavesEdge(settings) || fadesEdges(settings)) && !stack.empty())
        throw base::Error("strokes on layers neither leave nor fade edges", {},
                          "merge the layers, or leave \"edge\" and \"fade-edges\" as they are");
    const surface::Surface shown = selection::shownOf(context.document.surface());
    if ((leavesEdge(settings) || fadesEdges(settings)) && !(shown.tree() == context.document.surface().tree()))
        throw base::Error("strokes neither leave nor fade edges while parts of the model are hidden", {},
                          "show them, or leave \"edge\" and \"fade-edges\" as they are");
    return shown;
}

static std::shared_ptr<const sculpt::BrushStamp> stampOf(const std::string& image) {
    if (image.empty())
        return {};
    io::GreyImage grey = io::readGreyImage(image);
    return std::make_shared<sculpt::BrushStamp>(grey.width, grey.height, std::move(grey.values));
}

LiveStroke::LiveStroke(Context& context, sculpt::StrokeSettings settings)
    : m_context(context), m_settings(std::move(settings)), m_start(startOf(context, m_settings)),
      m_stroke(m_start, m_settings, context.document.provenance().origin, stampOf(m_settings.stamp),
               context.progress.cancel) {
    if (!context.document.layers().empty())
        m_stroke.onLayers(std::make_shared<layers::Stack>(context.document.layers()));
}

bool LiveStroke::add(const sculpt::StrokeSample& sample) {
    const base::CancelScope scope(m_context.progress.cancel);
    if (sculpt::lastOnly(m_settings) && m_samples.size() > 1) // what lies between has no say
        m_samples.pop_back();
    m_samples.push_back(recordable(sample, m_context.document.provenance().origin));
    return m_stroke.add(m_samples.back());
}

const char* LiveStroke::label() const {
    return sculpt::tool(m_settings.tool).label;
}

bool LiveStroke::settle() {
    const base::CancelScope scope(m_context.progress.cancel);
    return m_stroke.finishSlice();
}

surface::Surface LiveStroke::withItsEdges() {
    const base::Vec3d& origin = m_context.document.provenance().origin;
    if (fadesEdges(m_settings))
        return withFadedEdges(m_stroke.surface(), m_settings, m_samples, origin);
    if (!leavesEdge(m_settings) || !changed())
        return m_stroke.surface();
    std::string message;
    const surface::Surface start = withEdges(m_context.document.surface(), m_stroke.surface(), m_settings, m_samples,
                                             origin, message, m_context.progress);
    if (!message.empty())
        m_context.messages.push_back(message);
    if (start.tree() == m_context.document.surface().tree())
        return m_stroke.surface();
    sculpt::Stroke again(start, m_settings, origin, stampOf(m_settings.stamp), m_context.progress.cancel);
    for (const sculpt::StrokeSample& sample : m_samples)
        again.add(sample);
    again.finish();
    return again.surface();
}

void LiveStroke::tellOfStep(const tree::SurfelTree& done) {
    constexpr double seen = 0.5; // spacings
    const selection::Step step = selection::stepBesideHidden(m_context.document.surface().tree(), m_start.tree(), done);
    if (step.spacings < seen)
        return;
    m_context.messages.push_back(
        "A step of " + base::shortNumber(step.height, 3) + " is left beside what is hidden, at " +
        placeText(base::cast<double>(step.place) + m_context.document.provenance().origin, step.height) +
        ": smooth it once that is shown, or mask there first.");
}

bool LiveStroke::finish() {
    const base::CancelScope scope(m_context.progress.cancel);
    m_stroke.finish();
    m_context.dabs = m_stroke.dabs();
    m_context.dabSeconds.assign(m_stroke.dabSeconds().begin(), m_stroke.dabSeconds().end());
    surface::Surface done = depth() ? withItsEdges() : m_stroke.surface();
    if (done.tree() == m_start.tree())
        return false;
    const surface::Surface& whole = m_context.document.surface();
    if (!(m_start.tree() == whole.tree())) {
        tellOfStep(done.tree());
        done = {selection::grafted(whole.tree(), m_start.tree(), done.tree()), whole.definition()};
    }
    m_context.document.commit(done, label(), layers::How::Keep);
    record(m_context, line());
    return true;
}

nlohmann::json LiveStroke::line() const {
    return complete(strokeLine(m_settings, m_samples, m_context.document.provenance().origin));
}

} // namespace session
