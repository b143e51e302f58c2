#include "ui/interaction/picture_look.h"

#include "core/render/shading/selected_colours.h"
#include "core/surface/rims.h"

#include <algorithm>
#include <QWidget>

namespace ui {

PictureLook::PictureLook(const Editor& editor, const Settings& settings, const QWidget& canvas)
    : m_editor(editor), m_settings(settings), m_canvas(canvas) {}

bool PictureLook::showColours(std::shared_ptr<const render::BlockColours> colours,
                              const std::optional<render::ColourScale>& scale) {
    m_scale = scale;
    if (colours == m_colours)
        return false;
    m_colours = std::move(colours);
    return true;
}

void PictureLook::placeGrid() {
    const Snapshot& now = m_editor.snapshot();
    m_grid = render::gridBelow(now.whole.bounds(), upRow(now.up).up, now.origin);
}

render::RenderOptions PictureLook::options() const {
    render::RenderOptions out = lookOf(m_settings);
    out.shading = shading();
    out.pixelScale = static_cast<float>(m_canvas.devicePixelRatioF());
    if (m_settings.grid)
        out.grid = m_grid;
    return out;
}

/// Of several models, all surfels as one surface, which ends where the first of them does; by their rims where all of
/// them know these.
static surface::Surface allOf(const Snapshot& now) {
    if (now.beside.empty())
        return now.surface;
    surface::SurfaceDefinition definition = now.surface.definition();
    for (const session::ShownModel& each : now.beside) {
        definition.boundaryLimit = std::min(definition.boundaryLimit, each.surface.definition().boundaryLimit);
        definition.knownRims = definition.knownRims && surface::knowsRims(each.surface);
    }
    return {now.whole, definition};
}

std::optional<TrueSurface> PictureLook::truth() const {
    const Snapshot& now = shown();
    if (!m_settings.truth.on || now.whole.empty())
        return {};
    TrueSurface out{allOf(now), m_settings.truth.quality, m_settings.truth.lighting, nullptr};
    const std::optional<render::MeasureRow>& row = render::shadingRow(shading()).measure;
    if (row && m_scale)
        out.measured = std::make_shared<render::Measured>(
            render::Measured{row->question(now.surface, now.reference, m_settings.attribute), *m_scale});
    else if (!row && m_colours) // something is selected
        out.measured = std::make_shared<render::Measured>(render::Measured{
            render::selectionQuestion(now.surface),
            {},
            render::shadingRow(shading()).surfelColours ? render::Measured::Over::Own : render::Measured::Over::White});
    return out;
}

Frame PictureLook::frame(const render::Camera& camera, bool moving, std::uint64_t input) const {
    const Snapshot& now = shown();
    Frame out;
    out.model = now.whole;
    out.camera = camera;
    out.moving = moving;
    out.options = options();
    out.options.colours = m_colours;
    out.options.definition = now.surface.definition();
    out.options.entire = isEntire(now);
    out.options.splatScale = now.splatScale;
    out.truth = truth();
    out.smooth = true;
    out.input = std::max(now.input, input);
    return out;
}

} // namespace ui
