#include "ui/panels/start_card.h"

#include "core/process/samples/samples.h"
#include "ui/theme/icon.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace ui {

StartCard::StartCard(QWidget& canvas, const std::vector<std::string>& recent, const PictureOf& pictureOf)
    : FloatingCard(canvas, Place::Centre, tr("Pointclay")) {
    auto* what = new QLabel(tr("Sculpt the clay behind this card: click beside it. Or begin with"));
    what->setObjectName("faint");
    column().addWidget(what);
    QAbstractButton* open = button(tr("Open a Model…"), "start-open", [this] { Q_EMIT openWanted(); });
    open->setIcon(icon("open"));
    open->setToolTip(tr("Scans and meshes; or drop a file anywhere on the window"));
    column().addWidget(open);
    addRecent(recent, pictureOf);
    addSamples();
    addFoot();
}

QAbstractButton* StartCard::button(const QString& text, const QString& name, const std::function<void()>& then) {
    auto* out = new QToolButton;
    out->setObjectName("plain");
    out->setProperty("start", name);
    out->setText(text);
    out->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    out->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    out->setFocusPolicy(Qt::StrongFocus);
    connect(out, &QToolButton::clicked, this, [this, then] {
        close();
        then();
    });
    return out;
}

void StartCard::addHeading(const QString& text) {
    auto* heading = new QLabel(text);
    heading->setObjectName("faint");
    column().addSpacing(4);
    column().addWidget(heading);
}

void StartCard::addSamples() {
    addHeading(tr("A sample"));
    auto* grid = new QGridLayout;
    grid->setSpacing(6);
    constexpr int across = 4;
    int count = 0;
    for (const process::SampleRow& row : process::sampleTable()) {
        const std::string id = row.id;
        QAbstractButton* each =
            button(tr(row.label), QString("start-") + row.id, [this, id] { Q_EMIT sampleWanted(id); });
        each->setToolTip(tr(row.tip));
        grid->addWidget(each, count / across, count % across);
        ++count;
    }
    column().addLayout(grid);
}

/// With pictures, where there are any: who comes again looks for a shape, not for a name.
void StartCard::addRecent(const std::vector<std::string>& recent, const PictureOf& pictureOf) {
    constexpr int most = 4; // in a row
    constexpr QSize size(132, 88);
    auto* grid = new QGridLayout;
    grid->setSpacing(6);
    int count = 0;
    for (const std::string& path : recent) {
        const QFileInfo file(QString::fromStdString(path));
        if (count == most || !file.exists())
            continue;
        if (count == 0)
            addHeading(tr("Open lately"));
        QAbstractButton* each = button(file.fileName(), "start-recent", [this, path] { Q_EMIT recentWanted(path); });
        each->setToolTip(file.filePath());
        if (const QIcon picture = pictureOf(path); !picture.isNull()) {
            each->setIcon(picture);
            each->setIconSize(size);
            static_cast<QToolButton*>(each)->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
            each->setFixedHeight(size.height() + 2 * fontMetrics().height());
        }
        grid->addWidget(each, 0, count++);
    }
    column().addLayout(grid);
}

void StartCard::addFoot() {
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    QAbstractButton* tour = button(tr("Take the Tour"), "start-tour", [this] { Q_EMIT tourWanted(); });
    tour->setToolTip(tr("Two minutes with your own hands; also in the Help menu"));
    row->addWidget(tour);
    QAbstractButton* sculpt = button(tr("Just Sculpt"), "start-sculpt", [] {});
    sculpt->setToolTip(tr("Esc does the same"));
    row->addWidget(sculpt);
    column().addSpacing(6);
    column().addLayout(row);
}

} // namespace ui
