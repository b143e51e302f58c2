#include "ui/window/image_export.h"

#include "core/render/image_io.h"
#include "core/render/scene_picture.h"
#include "ui/window/file_dialogs.h"

#include <QFileDialog>

namespace ui {

ImageExport::ImageExport(QMainWindow& window, Editor& editor, const Settings& settings, SculptView& view)
    : QObject(&window), m_window(window), m_editor(editor), m_settings(settings), m_view(view),
      m_failure(window, editor) {}

ImageChoice ImageExport::asShown() const {
    const render::Camera now = m_view.motion().camera();
    return {.size = {now.width, now.height}, .transparent = false, .smooth = true, .rayCast = false};
}

void ImageExport::ask() {
    const ImageChoice shown = asShown();
    auto* dialog = new ImageDialog(m_last.size.isEmpty() ? shown : m_last, shown.size, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        m_last = dialog->choice();
        askPath(m_last);
    });
    dialog->open();
}

void ImageExport::askPath(const ImageChoice& choice) {
    const std::filesystem::path& path = m_editor.snapshot().path;
    const QString name = path.empty() ? QString("pointclay") : textOf(path.stem());
    const QString folder = folderFor(m_editor.snapshot(), m_settings);
    const QString start = (folder.isEmpty() ? QString() : folder + "/") + name + ".png";
    const QString filter = tr("Portable Network Graphics (*.png)");
    const QString file = QFileDialog::getSaveFileName(&m_window, tr("Export Image"), start, filter);
    if (!file.isEmpty())
        write(completed(file, filter), choice);
}

void ImageExport::write(const std::filesystem::path& path) {
    write(path, asShown());
}

void ImageExport::write(const std::filesystem::path& path, const ImageChoice& choice) {
    m_failure.clear();
    render::Camera camera = m_view.motion().camera();
    camera.width = choice.size.width(), camera.height = choice.size.height();
    render::PictureOptions options;
    options.style = m_view.look().options();
    options.style.transparent = choice.transparent;
    options.annotated = m_settings.annotated;
    options.reference = m_editor.snapshot().reference;
    options.smooth = options.smoothRays = choice.smooth;
    options.rayCast = choice.rayCast;
    options.lighting = m_settings.truth.lighting;
    options.sections = m_view.cuts().cuts().section;
    const Snapshot& shown = m_editor.snapshot();
    const bool activeToo = shown.beside.empty() || shown.scene[shown.active].visible;
    const auto work = [=, beside = shown.beside](const surface::Surface& surface, const base::Progress& progress) {
        std::vector<surface::Surface> models;
        if (activeToo)
            models.push_back(surface);
        for (const session::ShownModel& each : beside)
            models.push_back(each.surface);
        render::PictureStats stats;
        const render::Image image = render::ScenePictureMaker(models, options).draw(camera, stats, progress);
        progress.step(0.5, "Writing the image");
        render::savePng(image, path);
    };
    m_editor.runAside({"Drawing the image", work, [this, path](bool done) {
                           if (done)
                               Q_EMIT m_editor.told(tr("Wrote %1").arg(textOf(path)));
                           else
                               m_failure.show(tr("Could not write %1").arg(textOf(path.filename())));
                       }});
}

} // namespace ui
