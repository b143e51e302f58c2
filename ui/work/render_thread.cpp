#include "ui/work/render_thread.h"

#include "core/base/cancel_scope.h"
#include "core/render/smooth_image.h"
#include "ui/work/post.h"

#include <chrono>

namespace ui {

using Clock = std::chrono::steady_clock;

RenderThread::RenderThread(std::unique_ptr<render::CpuSplatter> renderer, Deliver deliver)
    : m_renderer(std::move(renderer)), m_deliver(std::move(deliver)) {
    m_thread = std::thread([this] { work(); });
}

RenderThread::~RenderThread() {
    {
        const std::lock_guard lock(m_mutex);
        m_ending = m_interrupt = true;
    }
    m_asked.notify_one();
    m_thread.join();
}

void RenderThread::request(const Frame& frame) {
    {
        const std::lock_guard lock(m_mutex);
        m_request = frame;
        m_interrupt = true;
    }
    m_asked.notify_one();
}

std::optional<RenderThread::Job> RenderThread::left() {
    if (m_unrefined) {
        Job finer{std::move(*m_unrefined)};
        m_unrefined.reset();
        finer.frame.moving = false;
        m_settling = true;
        return finer;
    }
    Job smoother{std::move(*m_rough), true};
    m_rough.reset();
    return smoother;
}

std::optional<RenderThread::Job> RenderThread::next() {
    std::unique_lock lock(m_mutex);
    const auto asked = [this] { return m_ending || m_request; };
    if (!m_unrefined && !m_rough)
        m_asked.wait(lock, asked);
    else if (!m_asked.wait_for(lock, std::chrono::duration<double>(m_unrefined && m_settling ? 0 : restSeconds), asked))
        return left();
    if (m_ending)
        return {};
    m_settling = m_interrupt = false;
    Job out{std::move(*m_request)};
    m_request.reset();
    return out;
}

/// Whether a frame can be made by drawing over what is in the image.
static bool samePlace(const Frame& a, const Frame& b) {
    render::RenderOptions options = a.options;
    options.detailPx = b.options.detailPx;
    if (options.colours && b.options.colours) // the renderer finds out which differ
        options.colours = b.options.colours;
    return a.camera == b.camera && options == b.options;
}

static render::TrueView::Subject subject(const Frame& frame) {
    return {frame.truth->surface,  frame.camera, frame.options,        frame.truth->quality,
            frame.truth->lighting, frame.smooth, frame.truth->measured};
}

static QImage pictureOf(const render::Image& image) {
    const QImage view(reinterpret_cast<const uchar*>(image.colour.data()), image.width, image.height,
                      QImage::Format_RGBX8888);
    return view.convertToFormat(QImage::Format_RGB32);
}

QImage RenderThread::picture() const {
    return pictureOf(m_image);
}

RenderThread::Result RenderThread::draw(const Frame& frame) {
    Result out;
    out.input = frame.input;
    render::Camera camera = frame.camera;
    render::RenderOptions options = frame.options;
    const bool same = m_drawn && samePlace(*m_drawn, frame);
    const bool update = frame.moving && same && m_updateSeconds <= fluentSeconds;
    if (update)
        options.detailPx = m_drawn->options.detailPx;
    else if (frame.moving)
        options.detailPx = m_pacer.moving();
    else if (m_settling && !frame.truth)
        options.detailPx = m_pacer.settling(m_lastDetail);
    out.reduced = frame.moving && !update && m_pacer.overwhelmed() && camera.width > 1 && camera.height > 1;
    if (out.reduced)
        camera.width /= 2, camera.height /= 2, options.pixelScale /= 2;
    const bool over = same && options.detailPx == m_drawn->options.detailPx;
    m_drawn.reset();
    const auto layer = frame.truth && !out.reduced ? m_truth.known(subject(frame)) : nullptr;
    m_renderer->showOver(layer);
    const auto start = Clock::now();
    m_renderer->update(frame.model, camera, options, m_image);
    out.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    out.detailPx = m_lastDetail = options.detailPx;
    // A quarter of the pixels costs at least a quarter of the time: a guess that never switches back too late.
    if (!over)
        m_pacer.drew(options.detailPx, out.reduced ? 3 * out.seconds : out.seconds);
    m_updateSeconds = over ? out.seconds : 0;
    if (!out.reduced) {
        m_drawn = frame;
        m_drawn->options = options;
    }
    out.picture = picture();
    if (layer)
        out.refinement.emplace();
    if (out.reduced) // here, not when painting: the interface's thread is only to copy
        out.picture = out.picture.scaled(frame.camera.width, frame.camera.height, Qt::IgnoreAspectRatio,
                                         Qt::SmoothTransformation);
    return out;
}

void RenderThread::refine(const Frame& frame) {
    base::Progress progress;
    progress.cancel = &m_interrupt;
    const auto start = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    Refinement reached;
    progress.report = [&, told = 0.0](double share, std::string_view) mutable {
        constexpr double patience = 0.2;
        if (reached.quality == 0 || reached.quality > frame.truth->quality || seconds() < told + patience)
            return; // levels tell themselves
        told = seconds();
        Result result;
        result.refinement = Refinement{reached.quality, false, told, share};
        m_deliver(std::move(result));
    };
    const auto show = [&](const render::TrueView::Level& level) {
        progress.step(0, {});
        m_renderer->showOver(level.layer);
        m_renderer->update(frame.model, frame.camera, m_drawn->options, m_image);
        Result result;
        result.input = frame.input;
        result.picture = picture();
        result.seconds = seconds();
        reached = {level.quality, level.complete, seconds()};
        result.refinement = reached;
        m_deliver(std::move(result));
    };
    try {
        m_truth.refine(subject(frame), show, progress);
    } catch (const base::Cancelled&) { // what was cast by now is kept for the frame that comes
    }
}

bool RenderThread::isSmooth(const Frame& frame) const {
    return m_smoothed && !frame.truth && frame.smooth && m_smoothed->model == frame.model &&
           m_smoothed->camera == frame.camera && m_smoothed->options == frame.options;
}

void RenderThread::smooth(const Frame& frame) {
    try {
        const base::CancelScope scope(&m_interrupt);
        if (!m_fine)
            m_fine = std::make_unique<render::CpuSplatter>();
        render::Camera camera = frame.camera;
        camera.width *= 2, camera.height *= 2;
        render::RenderOptions options = frame.options;
        options.pixelScale *= 2;
        render::Image fine, out;
        m_fine->render(frame.model, camera, options, fine);
        out.width = frame.camera.width, out.height = frame.camera.height;
        out.colour.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
        render::shrink(fine, out);
        Result result;
        result.input = frame.input;
        result.picture = m_smoothPicture = pictureOf(out);
        result.smooth = true;
        m_smoothed = frame;
        m_deliver(std::move(result));
    } catch (const base::Cancelled&) {
        m_fine.reset(); // stopped in the middle of anything
    }
}

void RenderThread::serve(const Frame& frame) {
    Result result;
    m_rough.reset();
    m_unrefined.reset();
    if (isSmooth(frame)) { // nothing has changed but what is painted over it
        result.input = frame.input;
        result.picture = m_smoothPicture;
        result.seconds = m_lastSeconds;
        return m_deliver(std::move(result));
    }
    m_smoothed.reset();
    result = draw(frame);
    m_lastSeconds = result.seconds;
    const bool coarse = result.reduced || result.detailPx > frame.options.detailPx;
    if (coarse || (frame.truth && frame.moving))
        m_unrefined = frame;
    else if (frame.smooth && !frame.truth)
        m_rough = frame;
    m_deliver(std::move(result));
    if (frame.truth && !m_unrefined)
        refine(frame);
}

void RenderThread::work() {
    while (const std::optional<Job> job = next()) {
        try {
            if (job->smooth)
                smooth(job->frame);
            else
                serve(job->frame);
        } catch (const std::exception& error) {
            m_unrefined.reset();
            m_rough.reset();
            Result result;
            result.trouble = textOf(error);
            m_deliver(std::move(result));
        }
    }
}

} // namespace ui
