// From other threads to the interface's: calls that run there later, in the order in which they were posted.
#pragma once

#include "core/base/progress.h"
#include "ui/words/words.h"

#include <QObject>
#include <QString>

#include <exception>
#include <new>

namespace ui {

/// Runs `call` on the receiver's thread, if the receiver still lives then.
template <class Call>
void post(QObject* receiver, Call call) {
    QMetaObject::invokeMethod(receiver, std::move(call), Qt::QueuedConnection);
}

/// A worker rests: calls `rest` on the receiver's thread unless the worker is `busy` again, and after all that the
/// worker has posted by then, for it may have done another piece since it told that it rests.
template <class Busy, class Rest>
void postRest(QObject* receiver, Busy busy, Rest rest) {
    post(receiver, [=] {
        if (!busy())
            post(receiver, [=] {
                if (!busy())
                    rest();
            });
    });
}

inline QString textOf(std::string_view utf8) {
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}
inline QString textOf(const std::exception& error) {
    return dynamic_cast<const std::bad_alloc*>(&error) ? QObject::tr("There is not enough memory for this.")
                                                       : QString::fromUtf8(error.what());
}

/// Stopped as `stop` is; how far it is goes to tell(share, doing) on the receiver's thread.
template <class Tell>
base::Progress postedProgress(const base::Progress& stop, QObject* receiver, const Tell& tell) {
    base::Progress out = stop;
    out.report = [receiver, tell](double share, std::string_view doing) {
        post(receiver, [tell, share, text = spoken(doing, "progress")] { tell(share, text); });
    };
    return out;
}

} // namespace ui
