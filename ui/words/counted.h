// Large counts as people read them: 191,799, with a comma whatever the language is, as the core's own messages have it.
#pragma once

#include <QLocale>

namespace ui {

inline QString counted(qulonglong count) {
    QLocale plain = QLocale::c();
    plain.setNumberOptions({});
    return plain.toString(count);
}

} // namespace ui
