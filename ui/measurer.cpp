#include "ui/measurer.h"

namespace ui {

using render::Coloured;
using render::ColourScale;

static bool same(const surface::Surface& a, const surface::Surface& b) {
    return a.tree() == b.tree() && a.definition() == b.definition();
}

bool Measurer::Request::sameSubject(const Request& o) const {
    return shading == o.shading && models == o.models && same(reference, o.reference) &&
           surface.definition() == o.surface.definition();
}

bool Measurer::Request::operator==(const Request& o) const {
    return sameSubject(o) && surface.tree() == o.surface.tree();
}

Measurer::Measurer(QObject* parent) : QObject(parent), m_thread([this] { work(); }) {}

Measurer::~Measurer() {
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
        m_cancel = true;
    }
    m_asked.notify_all();
    m_thread.join();
}

void Measurer::want(render::Shading shading, const surface::Surface& surface, const surface::Surface& reference,
                    std::uint64_t models) {
    const auto& row = render::shadingRow(shading).measure;
    const bool deviates = row && row->quantity == process::Quantity::Deviation;
    const Request wanted{shading, row ? surface : surface::Surface{}, deviates ? reference : surface::Surface{},
                         row ? models : 0};
    if (wanted == m_wanted)
        return;
    if (!wanted.sameSubject(m_wanted)) {
        m_colours = row ? std::make_shared<const render::BlockColours>(tree::SurfelTree{}) : nullptr;
        m_scale.reset();
    }
    m_wanted = wanted;
    {
        const std::lock_guard lock(m_mutex);
        m_request = row ? std::optional(wanted) : std::nullopt;
        m_cancel = m_running && (!row || !m_running->sameSubject(wanted));
    }
    m_busy = m_busy || row;
    m_asked.notify_all();
}

void Measurer::cancel() {
    const std::lock_guard lock(m_mutex);
    m_request.reset();
    m_cancel = true;
}

/// Runs it on the interface's thread, if this still lives then.
void Measurer::post(const std::function<void()>& call) {
    QMetaObject::invokeMethod(this, call, Qt::QueuedConnection);
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
    const process::FieldQuestion question{row.quantity, request.surface, request.reference};
    const Coloured* before = m_last && m_last->first.sameSubject(request) ? &m_last->second : nullptr;
    Coloured out;
    out.field = process::evaluateField(question, before ? &before->field : nullptr, progress);
    out.scale = render::scaleFor(row, question, {}, &out.field, progress);
    if (before && stillFits(before->scale, out.scale))
        out.scale = before->scale;
    out.colours = coloursOf(out.field, out.scale, before);
    return out;
}

void Measurer::receive(const Request& request, const Coloured& done) {
    if (!request.sameSubject(m_wanted))
        return;
    m_colours = done.colours;
    m_scale = done.scale;
    Q_EMIT changed();
}

/// Unless something has been asked for meanwhile.
void Measurer::rest() {
    {
        const std::lock_guard lock(m_mutex);
        if (m_request || m_running)
            return;
    }
    m_busy = false;
    Q_EMIT idled();
}

void Measurer::work() {
    const base::Progress progress{
        [this](double share, std::string_view doing) {
            post([this, share, text = QString::fromUtf8(doing.data(), qsizetype(doing.size()))] {
                if (m_busy)
                    Q_EMIT progressed(share, text);
            });
        },
        &m_cancel};
    for (;;) {
        Request request;
        {
            std::unique_lock lock(m_mutex);
            m_running.reset();
            if (!m_request)
                post([this] { rest(); });
            m_asked.wait(lock, [this] { return m_ending || m_request; });
            if (m_ending)
                return;
            request = *m_request;
            m_running = std::exchange(m_request, std::nullopt);
            m_cancel = false;
        }
        try {
            const Coloured done = measure(request, progress);
            m_last.emplace(request, done);
            post([this, request, done] { receive(request, done); });
        } catch (const base::Cancelled&) { // something else is wanted, or nothing
        }
    }
}

} // namespace ui
