#include "core/session/live_stroke.h"

#include "core/base/error.h"
#include "core/session/commands.h"
#include "core/session/journal.h"
#include "core/session/stroke_json.h"

#include <nlohmann/json.hpp>

namespace session {

static surface::Surface startOf(const Context& context, const sculpt::StrokeSettings& settings) {
    requireModel(context);
    sculpt::check(settings);
    if (context.document.surface().definition().manifold == surface::Manifold::Curve)
        throw base::Error("the model is a curve, which has nothing to sculpt", {},
                          "set the surface option manifold to surface");
    return context.document.surface();
}

LiveStroke::LiveStroke(Context& context, sculpt::StrokeSettings settings)
    : m_context(context), m_settings(std::move(settings)),
      m_stroke(startOf(context, m_settings), m_settings, context.document.provenance().origin) {}

bool LiveStroke::add(const sculpt::StrokeSample& sample) {
    m_samples.push_back(recordable(sample, m_context.document.provenance().origin));
    return m_stroke.add(m_samples.back());
}

bool LiveStroke::finish() {
    m_stroke.finish();
    m_context.dabs = m_stroke.dabs();
    m_context.dabSeconds.assign(m_stroke.dabSeconds().begin(), m_stroke.dabSeconds().end());
    if (m_stroke.surface().tree() == m_context.document.surface().tree())
        return false;
    m_context.document.commit(m_stroke.surface(), sculpt::tool(m_settings.tool).label);
    if (m_context.journal)
        m_context.journal->record(complete(strokeLine(m_settings, m_samples, m_context.document.provenance().origin)),
                                  m_context);
    return true;
}

} // namespace session
