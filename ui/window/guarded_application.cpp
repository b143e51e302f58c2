#include "ui/window/guarded_application.h"

#include "ui/work/post.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <QMessageBox>
#include <utility>

namespace ui {

bool GuardedApplication::notify(QObject* receiver, QEvent* event) {
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::exception& error) {
        tell(textOf(error));
    }
    return false;
}

/// Later, when what the event held is given back.
void GuardedApplication::tell(const QString& trouble) {
    if (std::exchange(m_telling, true))
        return;
    post(this, [this, trouble] {
        QMessageBox box(QMessageBox::Warning, tr("Something went wrong"), trouble, QMessageBox::Ok, activeWindow());
        box.setInformativeText(tr("Save your work, and close what you do not need."));
        box.exec();
        m_telling = false;
    });
}

/// Without asking for any memory.
[[noreturn]] static void endWith(const char* what) {
    std::fprintf(stderr, "pointclay: %s; start again to recover what was not saved\n", what);
    std::_Exit(1);
}

[[noreturn]] static void endWithException() {
    try {
        if (const std::exception_ptr error = std::current_exception())
            std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        endWith("not enough memory");
    } catch (const std::exception& error) {
        endWith(error.what());
    } catch (...) {
    }
    endWith("the program had to end");
}

static QtMessageHandler ordinary = nullptr;

static void onMessage(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (type == QtFatalMsg)
        endWith(text.toUtf8().constData());
    ordinary(type, context, text);
}

void installLastWords() {
    std::set_terminate(endWithException);
    ordinary = qInstallMessageHandler(onMessage);
}

} // namespace ui
