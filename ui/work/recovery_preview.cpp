#include "ui/work/recovery_preview.h"

#include "core/base/cancel_scope.h"
#include "core/render/framed_box.h"
#include "core/render/shading/own_colours.h"
#include "core/render/smooth_image.h"
#include "core/render/splats/cpu_splatter.h"
#include "ui/words/words.h"
#include "ui/work/post.h"
#include "ui/work/snapshot.h"

namespace ui {

QString stepsText(const session::Recovery& recovery) {
    QStringList out;
    for (const auto& [label, count] : recovery.steps)
        out << (count == 1 ? spoken(label, "step") : QObject::tr("%1 × %2").arg(count).arg(spoken(label, "step")));
    return out.join(", ");
}

RecoveryPreview::RecoveryPreview(QObject* parent) : QObject(parent) {
    m_worker = std::make_unique<LatestWorker<Wanted>>(
        [this](const Wanted& wanted, const base::Progress& progress) { make(wanted, progress); },
        [this](const std::exception& error) { post(this, [this, why = textOf(error)] { Q_EMIT failed(why); }); });
}

RecoveryPreview::~RecoveryPreview() {
    m_worker.reset();
}

void RecoveryPreview::want(const std::filesystem::path& journal, QSize size) {
    m_worker->request({journal, size}, true);
}

static QImage pictureOf(const Snapshot& model, QSize size) {
    const render::Camera camera =
        render::Camera::looking(render::framedBox(model.whole), size.width(), size.height(), model.up);
    render::RenderOptions options;
    options.shading = render::usualShading(model.whole);
    options.definition = model.surface.definition();
    options.entire = isEntire(model);
    options.splatScale = model.splatScale;
    render::CpuSplatter renderer;
    render::Image image;
    renderSmooth(renderer, model.whole, camera, options, image);
    const QImage view(reinterpret_cast<const uchar*>(image.colour.data()), image.width, image.height,
                      QImage::Format_RGBX8888);
    return view.convertToFormat(QImage::Format_RGB32);
}

/// On the worker's thread.
void RecoveryPreview::make(const Wanted& wanted, const base::Progress& progress) {
    const base::CancelScope scope(progress.cancel);
    base::Progress told;
    told.cancel = progress.cancel;
    told.report = [this](double share, std::string_view doing) {
        post(this, [this, share, what = spoken(doing, "progress")] { Q_EMIT progressed(share, what); });
    };
    session::Document document;
    session::Context context{document, {}, told, {}, 0, {}};
    const session::Recovery recovery = session::recover(wanted.journal, context);
    session::ShownScene beside;
    const QImage picture = pictureOf(snapshotOf(document, beside), wanted.size);
    post(this, [this, picture, steps = stepsText(recovery)] { Q_EMIT shown(picture, steps); });
}

} // namespace ui
