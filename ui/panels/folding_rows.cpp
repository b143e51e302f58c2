#include "ui/panels/folding_rows.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace ui {

constexpr int spacing = 6;

FoldingRows::FoldingRows(QWidget* parent) : QWidget(parent), m_column(new QVBoxLayout(this)), m_rows(new QVBoxLayout) {
    m_column->setContentsMargins(4, 2, 4, 2);
    m_column->setSpacing(spacing);
    m_rows->setSpacing(2);
    m_column->addLayout(m_rows);
}

void FoldingRows::addLine(QLayout& row) {
    std::vector<QWidget*> line;
    while (QLayoutItem* item = row.takeAt(0)) {
        if (item->widget())
            line.push_back(item->widget());
        delete item;
    }
    m_lines.push_back(line);
    m_folded = m_lines;
    layOut();
}

void FoldingRows::addBelow(QWidget& widget) {
    m_column->addWidget(&widget);
}

void FoldingRows::foldOver(int picture) {
    const int width = roomOver(picture);
    std::vector<std::vector<QWidget*>> folded;
    for (const std::vector<QWidget*>& line : m_lines) {
        int used = 0;
        folded.emplace_back();
        for (QWidget* each : line) {
            const int wanted = std::clamp(each->sizeHint().width(), each->minimumWidth(), each->maximumWidth());
            if (used > 0 && used + spacing + wanted > width) {
                folded.emplace_back();
                used = 0;
            }
            used += (used > 0 ? spacing : 0) + wanted;
            folded.back().push_back(each);
        }
    }
    if (folded == m_folded)
        return;
    m_folded = std::move(folded);
    layOut();
}

void FoldingRows::layOut() {
    while (QLayoutItem* row = m_rows->takeAt(0)) {
        while (QLayoutItem* item = row->layout()->takeAt(0))
            delete item; // its widget stays
        delete row;
    }
    for (const std::vector<QWidget*>& line : m_folded) {
        auto* row = new QHBoxLayout;
        row->setSpacing(spacing);
        for (QWidget* each : line)
            row->addWidget(each);
        row->addStretch();
        m_rows->addLayout(row);
    }
    m_column->activate(); // whoever folded it asks for its size at once
    updateGeometry();
    if (parentWidget() && parentWidget()->layout())
        parentWidget()->layout()->invalidate();
}

} // namespace ui
