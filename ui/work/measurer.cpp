#include "ui/work/measurer.h"

#include "ui/work/post.h"

namespace ui {

using render::Coloured;
using render::ColourScale;
using render::SelectedColours;

static bool same(const surface::Surface& a, const surface::Surface& b) {
    return a.tree() == b.tree() && a.definition() == b.definition();
}

bool Measurer::Request::sameSubject(const Request& o) const {
    return shading == o.shading && attribute == o.attribute && models == o.models && same(reference, o.reference) &&
           surface.definition() == o.surface.definition();
}

bool Measurer::Request::selects() const {
    return shading != render::Shading::Selection && surface.tree().layout()->find("selection");
}

bool Measurer::Request::operator==(const Request& o) const {
    return sameSubject(o) && surface.tree() == o.surface.tree();
}

Measurer::Measurer(QObject* parent)
    : QObject(parent),
      m_worker(
          [this](const Request& request, const base::Progress& progress) { work(request, progress); },
          [this](const std::exception& error) { post(this, [this, text = textOf(error)] { Q_EMIT failed(text); }); },
          [this] {
              postRest(
                  this, [this] { return m_worker.busy(); }, [this] { rest(); });
          }) {}

void Measurer::want(render::Shading shading, const std::string& attribute, const surface::Surface& surface,
                    const surface::Surface& reference, std::uint64_t models) {
    const auto& row = render::shadingRow(shading).measure;
    const bool deviates = row && row->quantity == process::Quantity::Deviation;
    Request wanted{shading, row && row->named() ? attribute : std::string(), surface,
                   deviates ? reference : surface::Surface{}, models};
    const bool work = row || wanted.selects();
    if (!work)
        wanted.surface = {}, wanted.models = 0;
    if (wanted == m_wanted)
        return;
    if (!wanted.sameSubject(m_wanted)) {
        m_colours = row ? std::make_shared<const render::BlockColours>(tree::SurfelTree{}) : nullptr;
        m_scale.reset();
    }
    const bool other = !wanted.sameSubject(std::exchange(m_wanted, wanted));
    m_busy = m_busy || work;
    if (work)
        m_worker.request(wanted, other);
    else
        m_worker.cancel();
}

void Measurer::cancel() {
    m_worker.cancel();
}

/// Colours must not swim with every dab, nor stay where they tell nothing any more.
static bool stillFits(const ColourScale& old, const ColourScale& now) {
    if (old.map != now.map)
        return false;
    const float a = old.high - old.low, b = now.high - now.low;
    return a < 2 * b && b < 2 * a && std::abs(old.low - now.low) < 0.3f * b && std::abs(old.high - now.high) < 0.5f * b;
}

Coloured Measurer::measure(const Request& request, const base::Progress& progress) {
    const render::MeasureRow& row = *render::shadingRow(request.shading).measure;
    const process::FieldQuestion question = row.question(request.surface, request.reference, request.attribute);
    const Coloured* before = m_last && m_last->request.sameSubject(request) ? &m_last->measured : nullptr;
    Coloured out;
    out.field = process::evaluateField(question, before ? &before->field : nullptr, progress);
    out.scale = render::scaleFor(row, question, {}, &out.field, progress);
    if (before && stillFits(before->scale, out.scale))
        out.scale = before->scale;
    out.colours = coloursOf(out.field, out.scale, before);
    return out;
}

SelectedColours Measurer::select(const Request& request, const Coloured& measured) const {
    if (!request.selects())
        return {measured.colours, measured.colours};
    const bool known = m_last && m_last->request.sameSubject(request);
    return render::showSelected(request.surface.tree(), request.shading, measured.colours,
                                known ? &m_last->colours : nullptr);
}

void Measurer::receive(const Done& done) {
    if (!done.request.sameSubject(m_wanted))
        return;
    m_colours = done.colours.shown;
    m_scale.reset();
    if (render::shadingRow(done.request.shading).measure)
        m_scale = done.measured.scale;
    Q_EMIT changed();
}

void Measurer::rest() {
    m_busy = false;
    Q_EMIT idled();
}

void Measurer::work(const Request& request, const base::Progress& cancel) {
    const base::Progress progress = postedProgress(cancel, this, [this](double share, const QString& doing) {
        if (m_busy)
            Q_EMIT progressed(share, doing);
    });
    const Coloured measured = render::shadingRow(request.shading).measure ? measure(request, progress) : Coloured{};
    const Done done{request, measured, select(request, measured)};
    m_last = done;
    post(this, [this, done] { receive(done); });
}

} // namespace ui
