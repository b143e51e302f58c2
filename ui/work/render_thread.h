// Draws frames off the interface's thread. Only the latest request counts: a newer one replaces what waits.
//
// While frames follow each other, a DetailPacer chooses how coarse they are drawn so that one takes `fluentSeconds` at
// most; if even the coarsest takes longer, they are drawn at half the resolution. When nothing new has come for
// `restSeconds` the picture settles: finer from frame to frame up to its best. Frames from the same place, such as
// those of a stroke, draw only what has changed (Renderer::update), as fine as it was.
//
// Where frames ask for it, outlines become smooth once the picture is at its best and rests: it is drawn again with
// four times the pixels, by a renderer of its own, so that what comes next still draws only what has changed. A request
// stops that at once.
//
// If a frame asks for the true surface, its levels are delivered once the view rests, until another request comes;
// frames of a stroke keep what no dab has touched.
#pragma once

#include "core/render/cast/true_view.h"
#include "core/render/splats/cpu_splatter.h"
#include "core/render/splats/detail_pacer.h"
#include "ui/work/frame.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <QImage>
#include <QString>
#include <thread>

namespace ui {

class RenderThread {
  public:
    static constexpr double fluentSeconds = 0.016, restSeconds = 0.12;

    struct Result {
        std::uint64_t input = 0;              ///< of the frame
        QImage picture;                       ///< RGB32, of the size asked for; null: only `refinement` is news
        double seconds = 0;                   ///< that the renderer took
        float detailPx = 0;                   ///< that it was drawn with
        bool reduced = false;                 ///< drawn at half resolution and enlarged
        std::optional<Refinement> refinement; ///< of the true surface, where the picture shows some
        bool smooth = false;                  ///< the same picture as the last, with smooth outlines
        QString trouble;                      ///< not empty: no picture, and why
    };
    using Deliver = std::function<void(Result)>;

    /// `deliver` is called on the drawing thread.
    RenderThread(std::unique_ptr<render::CpuSplatter> renderer, Deliver deliver);
    ~RenderThread();
    void request(const Frame& frame); ///< any thread

  private:
    void work();
    struct Job {
        Frame frame;
        bool smooth = false; ///< only the outlines are left to do
    };
    /// Waits for a request, or until the picture left unfinished may be completed. Empty: time to end.
    std::optional<Job> next();
    std::optional<Job> left(); ///< what is left to do for the last picture
    /// The picture of this very frame is there, with smooth outlines.
    bool isSmooth(const Frame& frame) const;
    void smooth(const Frame& frame);
    void serve(const Frame& frame);
    Result draw(const Frame& frame);
    /// Delivers levels; returns early where something else is asked.
    void refine(const Frame& frame);
    QImage picture() const; ///< what is in m_image

    std::unique_ptr<render::CpuSplatter> m_renderer; ///< touched by the drawing thread alone
    Deliver m_deliver;
    std::mutex m_mutex;
    std::condition_variable m_asked;
    std::optional<Frame> m_request;
    bool m_ending = false;
    std::atomic<bool> m_interrupt = false; ///< something is asked that the work has not looked at
    std::optional<Frame> m_unrefined;      ///< drawn coarsely; to be drawn finer at rest
    bool m_settling = false;               ///< m_unrefined needs no further rest
    std::optional<Frame> m_rough;          ///< drawn at its best, with rough outlines
    std::optional<Frame> m_smoothed;       ///< drawn in m_smoothPicture
    QImage m_smoothPicture;
    double m_lastSeconds = 0;                    ///< that the last picture took
    std::unique_ptr<render::CpuSplatter> m_fine; ///< of smooth outlines
    render::DetailPacer m_pacer{fluentSeconds};
    float m_lastDetail = 0;
    double m_updateSeconds = 0;   ///< what the last frame from the same place took
    std::optional<Frame> m_drawn; ///< the last one drawn in all its pixels, while it is in m_image; its detailPx counts
    render::Image m_image;
    render::TrueView m_truth;
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace ui
