#include "ui/window/failure_box.h"

#include "ui/theme/icon.h"
#include "ui/work/editor.h"

#include <QMessageBox>

namespace ui {

FailureBox::FailureBox(QMainWindow& window, const Editor& editor, QObject* parent) : QObject(parent), m_window(window) {
    connect(&editor, &Editor::failed, this, [this](const QString& message) { m_failure = message; });
}

void FailureBox::show(const QString& title) {
    if (!m_failure.isEmpty())
        show(title, m_failure);
}

void FailureBox::show(const QString& title, const QString& failure) {
    auto* box = new QMessageBox(QMessageBox::NoIcon, title, failure, QMessageBox::Ok, &m_window);
    box->setIconPixmap(icon("stop").pixmap(32, 32));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

} // namespace ui
