#include "ui/window/menus/letters.h"

#include "ui/window/command_palette.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>

namespace ui {

static QChar letterOf(const QString& text) {
    const qsizetype mark = text.indexOf('&');
    return mark >= 0 && mark + 1 < text.size() ? text[mark + 1].toLower() : QChar();
}

/// Where the mark goes; -1: every letter is taken. Of the alphabet alone: others are not on every keyboard.
static qsizetype placeIn(const QString& text, const QString& taken) {
    const auto free = [&](qsizetype i) {
        const char16_t letter = text[i].toLower().unicode();
        return letter >= u'a' && letter <= u'z' && !taken.contains(letter);
    };
    for (const bool beginning : {true, false})
        for (qsizetype i = 0; i < text.size(); ++i)
            if (free(i) && (!beginning || i == 0 || !text[i - 1].isLetterOrNumber()))
                return i;
    return -1;
}

static bool takes(const QAction& action) {
    return !action.isSeparator() && !action.text().isEmpty();
}

static void giveLetters(const QList<QAction*>& actions, QString taken) {
    QList<QAction*> without;
    for (QAction* each : actions) {
        if (!takes(*each))
            continue;
        const QChar letter = letterOf(each->text());
        if (letter.isNull() || taken.contains(letter))
            without << each;
        else
            taken += letter;
    }
    for (QAction* each : without) {
        QString text = each->text().remove('&');
        if (const qsizetype at = placeIn(text, taken); at >= 0) {
            taken += text[at].toLower();
            text.insert(at, '&');
        }
        each->setText(text);
    }
    for (const QAction* each : actions)
        if (each->menu())
            giveLetters(each->menu()->actions(), {});
}

/// The letters of all keys that are Alt and a letter.
static QString keysWithAlt(const QMenuBar& bar) {
    QString out;
    for (const PaletteEntry& entry : paletteEntries(bar))
        for (const QKeySequence& key : entry.action ? entry.action->shortcuts() : QList<QKeySequence>())
            if (key[0].keyboardModifiers() == Qt::AltModifier && key[0].key() >= Qt::Key_A && key[0].key() <= Qt::Key_Z)
                out += QChar(key[0].key()).toLower();
    return out;
}

void giveLetters(QMenuBar& bar) {
    giveLetters(bar.actions(), keysWithAlt(bar));
}

} // namespace ui
