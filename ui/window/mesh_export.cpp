#include "ui/window/mesh_export.h"

#include "ui/window/file_dialogs.h"
#include "ui/words/counted.h"
#include "ui/work/editor.h"
#include "ui/work/post.h"

#include <QFileDialog>
#include <QPainter>

namespace ui {

/// After a pause this long the person has chosen, or the stroke is over.
constexpr int patienceMs = 300;

MeshExport::MeshExport(QMainWindow& window, Editor& editor, QWidget& canvas, FloatingBars& bars)
    : QObject(&window), m_window(window), m_editor(editor), m_canvas(canvas), m_bar(new MeshBar(&window)) {
    m_bar->hide();
    bars.add(*m_bar);
    m_bar->toggleViewAction()->setVisible(false); // the menu's entry opens it
    m_soon.setSingleShot(true);
    m_soon.setInterval(patienceMs);
    connect(&m_soon, &QTimer::timeout, this, &MeshExport::make);
    connect(m_bar, &MeshBar::edited, this, &MeshExport::follow);
    connect(m_bar, &MeshBar::exportWanted, this, &MeshExport::askPath);
    connect(&editor, &Editor::changed, this, &MeshExport::follow);
    connect(&m_mesher, &Mesher::changed, this, &MeshExport::tellMade);
    connect(&m_mesher, &Mesher::saved, this, [this](const QString& path) { Q_EMIT told(tr("Wrote %1").arg(path)); });
    connect(&m_mesher, &Mesher::failed, this, [this](const QString& why) { m_bar->tell(why, why); });
    m_drawer = std::make_unique<LatestWorker<Wanted>>(
        [this](const Wanted& wanted, const base::Progress& progress) { draw(wanted, progress); },
        [this](const std::exception& error) { post(this, [this, why = textOf(error)] { m_bar->tell(why, why); }); });
}

MeshExport::~MeshExport() {
    m_drawer.reset();
}

void MeshExport::setOpen(bool open) {
    m_bar->setVisible(open);
    if (open) {
        measure();
        return follow();
    }
    m_soon.stop();
    m_mesher.cancel();
    m_canvas.update();
}

/// The choice or the model may be another.
void MeshExport::follow() {
    if (!open())
        return;
    const tree::SurfelTree& model = m_editor.snapshot().surface.tree();
    const std::shared_ptr<const MadeMesh>& made = m_mesher.made();
    if (made && made->model == model && made->choice.sameMesh(m_bar->choice()))
        return tellMade();
    tellEstimate();
    m_soon.start();
    m_canvas.update();
}

/// Costs what the whole model costs: not for every dab.
void MeshExport::measure() {
    const Snapshot& now = m_editor.snapshot();
    m_area = estimatedArea(now.surface.tree(), static_cast<double>(now.spacing));
}

void MeshExport::make() {
    const std::shared_ptr<const MadeMesh>& made = m_mesher.made();
    if (!made || !(made->model == m_editor.snapshot().surface.tree())) {
        measure();
        tellEstimate();
    }
    if (m_bar->choice().preview && m_editor.snapshot().surfels > 0)
        m_mesher.want(m_bar->choice(), m_editor.snapshot());
}

void MeshExport::tellEstimate() {
    const Snapshot& now = m_editor.snapshot();
    const auto spacing = static_cast<double>(now.spacing);
    const double triangles = static_cast<double>(estimatedTriangles(m_area, spacing, m_bar->choice()));
    const double unit = triangles >= 1000 ? std::pow(10, std::floor(std::log10(triangles)) - 1) : 1;
    m_bar->tell(tr("about %1 triangles").arg(counted(static_cast<std::size_t>(std::round(triangles / unit) * unit))));
}

void MeshExport::tellMade() {
    m_canvas.update();
    const MadeMesh& made = *m_mesher.made();
    if (!(made.model == m_editor.snapshot().surface.tree() && made.choice.sameMesh(m_bar->choice())))
        return;
    QString text = tr("%1 triangles").arg(counted(made.mesh->triangles.size()));
    if (made.limitLoops > 0)
        text += made.limitLoops > 1 ? tr(", %1 boundary loops").arg(counted(made.limitLoops)) : tr(", 1 boundary loop");
    if (made.foldLoops > 0)
        text += tr(", %1 at folds").arg(counted(made.foldLoops));
    m_bar->tell(text, tr("%1 vertices, made in %2 s. Boundary loops: orange where the surface ends at its limit, "
                         "red at folds, where it is undefined")
                          .arg(counted(made.mesh->positions.size()))
                          .arg(made.seconds, 0, 'f', 1));
}

void MeshExport::askPath() {
    const std::filesystem::path& path = m_editor.snapshot().path;
    const QString name = path.empty() ? QString("mesh") : textOf(path.parent_path() / (path.stem().string() + "-mesh"));
    auto* dialog = new QFileDialog(&m_window, tr("Export Mesh"), name, meshFilter());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix("ply");
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.section("*.", 1, 1).section(' ', 0, 0).remove(')'));
    });
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& file) { save(std::filesystem::path(file.toStdString())); });
    dialog->open();
}

void MeshExport::save(const std::filesystem::path& path) {
    m_mesher.save(m_bar->choice(), m_editor.snapshot(), path);
}

// --- the preview ---

void MeshExport::paint(QPainter& painter, const render::Camera& camera) {
    const std::shared_ptr<const MadeMesh>& made = m_mesher.made();
    if (!open() || !m_bar->choice().preview || !made || !(made->model == m_editor.snapshot().surface.tree()))
        return;
    if (m_drawn.made == made && m_drawn.camera == camera) {
        painter.drawImage(0, 0, m_lines);
        return;
    }
    if (m_asked.made == made && m_asked.camera == camera)
        return;
    m_asked = {made, camera};
    m_drawer->request(m_asked, true);
}

/// On the drawing thread.
void MeshExport::draw(const Wanted& wanted, const base::Progress& progress) {
    if (m_wires.mesh != wanted.made->mesh)
        m_wires = render::wiresOf(wanted.made->mesh);
    render::Image image;
    drawWires(m_wires, wanted.camera, {}, image, progress);
    const QImage view(reinterpret_cast<const uchar*>(image.colour.data()), image.width, image.height,
                      QImage::Format_RGBA8888);
    const QImage lines = view.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    post(this, [this, lines, wanted] {
        m_lines = lines;
        m_drawn = wanted;
        m_canvas.update();
    });
}

} // namespace ui
