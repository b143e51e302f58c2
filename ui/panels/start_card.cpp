#include "ui/panels/start_card.h"

#include "core/process/samples/samples.h"
#include "ui/theme/icon.h"

#include <algorithm>
#include <numeric>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QResizeEvent>
#include <QToolButton>

namespace ui {

StartCard::StartCard(QWidget& canvas, const std::vector<std::string>& recent, const PictureOf& pictureOf)
    : FloatingCard(canvas, Place::Centre, tr("Pointclay")) {
    m_what = new QLabel(tr("Sculpt the clay behind this card: click beside it. Or begin with"));
    m_what->setObjectName("faint");
    m_what->setWordWrap(true);
    column().addWidget(m_what);
    QAbstractButton* open = button(tr("Open a Model…"), "start-open", [this] { Q_EMIT openWanted(); });
    open->setIcon(icon("open"));
    open->setToolTip(tr("Scans and meshes; or drop a file anywhere on the window"));
    column().addWidget(open);
    addRecent(recent, pictureOf);
    addSamples();
    addFoot();
    layOutFor(canvas.size());
}

/// Columns that have room for their words.
static int columnsIn(const std::vector<QAbstractButton*>& buttons, int room, int spacing) {
    constexpr int most = 4;
    for (int across = most; across > 1; --across) {
        std::vector<int> widths(static_cast<std::size_t>(across));
        for (std::size_t k = 0; k < buttons.size(); ++k) {
            int& width = widths[k % widths.size()];
            width = std::max(width, buttons[k]->sizeHint().width());
        }
        if (std::accumulate(widths.begin(), widths.end(), spacing * (across - 1)) <= room)
            return across;
    }
    return 1;
}

void StartCard::layOutFor(const QSize& canvas) {
    constexpr int margin = 14, narrow = 330;
    const int side = canvas.width() < narrow ? 8 : 18;
    column().setContentsMargins(side, 14, side, 14);
    const int room = canvas.width() - 2 * (margin + side);
    const int across = columnsIn(m_samples, room, m_grid->spacing());
    m_what->setVisible(canvas.width() >= narrow);
    m_foot->setDirection(canvas.width() < narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    for (QAbstractButton* each : m_samples) {
        m_grid->removeWidget(each);
        each->hide();
    }
    const int row = m_samples.front()->sizeHint().height() + m_grid->spacing();
    const int rows = std::max(0, (canvas.height() - 2 * margin - sizeHint().height()) / row);
    m_samplesHeading->setVisible(rows > 0); // all of them are in File > New
    for (int k = 0; k < int(m_samples.size()); ++k) {
        m_grid->addWidget(m_samples[std::size_t(k)], k / across, k % across);
        m_samples[std::size_t(k)]->setVisible(k / across < rows);
    }
}

bool StartCard::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::Resize)
        layOutFor(static_cast<QResizeEvent*>(event)->size());
    return FloatingCard::eventFilter(object, event);
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

QLabel* StartCard::addHeading(const QString& text) {
    auto* heading = new QLabel(text);
    heading->setObjectName("faint");
    column().addSpacing(4);
    column().addWidget(heading);
    return heading;
}

void StartCard::addSamples() {
    m_samplesHeading = addHeading(tr("A sample"));
    m_grid = new QGridLayout;
    m_grid->setSpacing(6);
    for (const process::SampleRow& row : process::sampleTable()) {
        const std::string id = row.id;
        m_samples.push_back(button(tr(row.label), QString("start-") + row.id, [this, id] { Q_EMIT sampleWanted(id); }));
        m_samples.back()->setToolTip(tr(row.tip));
    }
    column().addLayout(m_grid);
}

/// With pictures, where there are any: who comes again looks for a shape, not for a name.
void StartCard::addRecent(const std::vector<std::string>& recent, const PictureOf& pictureOf) {
    constexpr QSize size(132, 88);
    const int most = std::clamp((parentWidget()->width() - 70) / size.width(), 1, 4); // in a row
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
    m_foot = new QHBoxLayout;
    m_foot->setSpacing(6);
    QAbstractButton* tour = button(tr("Take the Tour"), "start-tour", [this] { Q_EMIT tourWanted(); });
    tour->setToolTip(tr("Two minutes with your own hands; also in the Help menu"));
    m_foot->addWidget(tour);
    QAbstractButton* sculpt = button(tr("Just Sculpt"), "start-sculpt", [] {});
    sculpt->setToolTip(tr("Esc does the same"));
    m_foot->addWidget(sculpt);
    column().addSpacing(6);
    column().addLayout(m_foot);
}

} // namespace ui
