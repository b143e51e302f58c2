#include "ui/render_thread.h"

#include <chrono>

namespace ui {

using Clock = std::chrono::steady_clock;

RenderThread::RenderThread(std::unique_ptr<render::Renderer> renderer, Deliver deliver)
    : m_renderer(std::move(renderer)), m_deliver(std::move(deliver)) {
    m_thread = std::thread([this] { work(); });
}

RenderThread::~RenderThread() {
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
    }
    m_asked.notify_one();
    m_thread.join();
}

void RenderThread::request(const Frame& frame) {
    {
        const std::lock_guard lock(m_mutex);
        m_request = frame;
    }
    m_asked.notify_one();
}

std::optional<Frame> RenderThread::next() {
    std::unique_lock lock(m_mutex);
    const auto asked = [this] { return m_ending || m_request; };
    if (!m_unrefined)
        m_asked.wait(lock, asked);
    else if (!m_asked.wait_for(lock, std::chrono::duration<double>(restSeconds), asked)) {
        Frame full = std::move(*m_unrefined);
        m_unrefined.reset();
        full.moving = false;
        return full;
    }
    if (m_ending)
        return {};
    std::optional<Frame> out = std::move(m_request);
    m_request.reset();
    return out;
}

RenderThread::Result RenderThread::draw(const Frame& frame) {
    Result out;
    out.input = frame.input;
    render::Camera camera = frame.camera;
    const bool same = m_drawn && m_drawn->camera == camera && m_drawn->options == frame.options;
    double& usual = same ? m_updateSeconds : m_fullSeconds;
    out.reduced = frame.moving && usual > fluentSeconds && camera.width > 1 && camera.height > 1;
    if (out.reduced)
        camera.width /= 2, camera.height /= 2;
    m_drawn.reset();
    const auto start = Clock::now();
    m_renderer->update(frame.model, camera, frame.options, m_image);
    out.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    // A quarter of the pixels costs at least a quarter of the time: a guess that never switches back too late.
    usual = out.reduced ? std::max(usual * 0.9, out.seconds * 1.5) : out.seconds;
    if (!out.reduced)
        m_drawn = frame;
    if (!same)
        m_updateSeconds = 0;
    const QImage view(reinterpret_cast<const uchar*>(m_image.colour.data()), m_image.width, m_image.height,
                      QImage::Format_RGBX8888);
    out.picture = view.convertToFormat(QImage::Format_RGB32);
    if (out.reduced) // here, not when painting: the interface's thread is only to copy
        out.picture = out.picture.scaled(frame.camera.width, frame.camera.height, Qt::IgnoreAspectRatio,
                                         Qt::SmoothTransformation);
    return out;
}

void RenderThread::work() {
    while (const std::optional<Frame> frame = next()) {
        Result result;
        try {
            result = draw(*frame);
        } catch (const std::exception& error) {
            result.trouble = QString::fromUtf8(error.what());
        }
        m_unrefined.reset();
        if (result.reduced)
            m_unrefined = frame;
        m_deliver(std::move(result));
    }
}

} // namespace ui
