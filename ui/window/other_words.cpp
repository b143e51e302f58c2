#include "ui/window/other_words.h"

#include "ui/words/words.h"

#include <QObject>

namespace ui {

std::span<const OtherWords> otherWordsTable() {
    static const OtherWords rows[] = {
        {"Export Image", QT_TR_NOOP("screenshot picture render png")},
        {"Export Mesh", QT_TR_NOOP("stl obj triangles wireframe convert print")},
        {"Layers", QT_TR_NOOP("add new layer strength")},
        {"Remove outliers", QT_TR_NOOP("strays floaters specks")},
        {"Reduce", QT_TR_NOOP("decimate simplify fewer")},
        {"Resample", QT_TR_NOOP("remesh even spacing")},
        {"Fill holes", QT_TR_NOOP("close repair watertight")},
        {"Cut", QT_TR_NOOP("slice halve")},
        {"Combine solids", QT_TR_NOOP("boolean subtract add union difference intersection")},
        {"Add a shape", QT_TR_NOOP("primitive boolean subtract union difference")},
        {"Drill", QT_TR_NOOP("bore subtract")},
        {"Transform", QT_TR_NOOP("move rotate scale translate")},
        {"Register", QT_TR_NOOP("align icp scans")},
    };
    return rows;
}

QString otherWords(const QString& englishLabel) {
    const QString label = QString(englishLabel).remove("…");
    for (const OtherWords& row : otherWordsTable())
        if (label == row.label)
            return QString("%1 %2").arg(row.words, spoken(row.words));
    return {};
}

} // namespace ui
