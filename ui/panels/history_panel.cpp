#include "ui/panels/history_panel.h"

#include "ui/words/words.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QVBoxLayout>

namespace ui {

static QString sizeText(qint64 bytes) {
    return QLocale().formattedDataSize(bytes, 0, QLocale::DataSizeTraditionalFormat);
}

HistoryPanel::HistoryPanel(int budgetMib, QWidget* parent)
    : QWidget(parent), m_list(new QListWidget), m_held(new QLabel), m_budget(new QComboBox) {
    m_list->setAccessibleName(tr("History"));
    m_list->setUniformItemSizes(true);
    m_list->setFrameShape(QFrame::NoFrame);
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0 && row != m_present)
            Q_EMIT wanted(row - m_present);
    });
    constexpr int sizes[] = {64, 256, 1024, 4096, 16384};
    for (const int mib : sizes)
        m_budget->addItem(tr("of %1").arg(sizeText(qint64(mib) << 20)), mib);
    if (m_budget->findData(budgetMib) < 0)
        m_budget->addItem(tr("of %1").arg(sizeText(qint64(budgetMib) << 20)), budgetMib);
    m_budget->setCurrentIndex(m_budget->findData(budgetMib));
    m_budget->setToolTip(tr("Memory that steps back may hold; the oldest are forgotten first"));
    m_budget->setAccessibleName(tr("Memory for history"));
    connect(m_budget, &QComboBox::currentIndexChanged, this,
            [this] { Q_EMIT budgetChosen(m_budget->currentData().toInt()); });

    m_held->setObjectName("faint");
    auto* below = new QHBoxLayout;
    below->setContentsMargins(8, 4, 8, 6);
    below->addWidget(m_held, 1);
    below->addWidget(m_budget);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_list, 1);
    layout->addLayout(below);
}

QStringList HistoryPanel::labels() const {
    QStringList out;
    for (int row = 0; row < m_list->count(); ++row)
        out << m_list->item(row)->text();
    return out;
}

void HistoryPanel::show(const Snapshot& snapshot) {
    m_held->setText(sizeText(static_cast<qint64>(snapshot.historyBytes)));
    const int present = static_cast<int>(snapshot.past.size());
    if (m_list->count() > 0 && m_list->currentRow() == present && present == m_present && snapshot.past == m_past &&
        snapshot.future == m_future)
        return;
    const QSignalBlocker quiet(m_list); // only a person's click is a wish
    m_past = snapshot.past;
    m_future = snapshot.future;
    m_present = present;
    m_list->clear();
    m_list->addItem(tr("Start"));
    for (const auto* labels : {&m_past, &m_future})
        for (const std::string& label : *labels)
            m_list->addItem(spoken(label, "step"));
    for (int row = present + 1; row < m_list->count(); ++row)
        m_list->item(row)->setForeground(palette().color(QPalette::Disabled, QPalette::Text));
    m_list->setCurrentRow(present);
    m_list->scrollToItem(m_list->item(present));
}

} // namespace ui
