#include "ui/window/manual_window.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

namespace ui {

QString manualFile() {
    const QString beside = QCoreApplication::applicationDirPath();
    for (const char* place : {"/desktop/manual.html", "/../share/doc/pointclay/manual.html"})
        if (QFileInfo::exists(beside + place))
            return QFileInfo(beside + place).canonicalFilePath();
    return {};
}

ManualWindow::ManualWindow(const QString& file, QWidget* parent)
    : QDialog(parent), m_page(new QTextBrowser), m_sought(new QLineEdit) {
    setWindowTitle(tr("Manual"));
    m_page->setOpenExternalLinks(true);
    m_page->setAccessibleName(tr("Manual"));
    if (file.isEmpty())
        m_page->setPlainText(tr("The manual is not beside this program. It is made with it (the target \"desktop\") "
                                "and installed by cmake --install."));
    else
        m_page->setSource(QUrl::fromLocalFile(file));
    m_sought->setPlaceholderText(tr("Find in the manual"));
    m_sought->setAccessibleName(m_sought->placeholderText());
    m_sought->setClearButtonEnabled(true);
    connect(m_sought, &QLineEdit::returnPressed, this, &ManualWindow::findNext);
    connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, m_sought, qOverload<>(&QWidget::setFocus));

    auto* browser = new QPushButton(tr("Open in &Browser"));
    browser->setAutoDefault(false); // Enter searches
    browser->setEnabled(!file.isEmpty());
    connect(browser, &QPushButton::clicked, this, [file] { QDesktopServices::openUrl(QUrl::fromLocalFile(file)); });
    auto* close = new QPushButton(tr("&Close"));
    close->setAutoDefault(false);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);

    auto* below = new QHBoxLayout;
    below->addWidget(m_sought, 1);
    below->addWidget(browser);
    below->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_page);
    layout->addLayout(below);
    resize(820, 700);
}

void ManualWindow::findNext() {
    if (m_page->find(m_sought->text()))
        return;
    m_page->moveCursor(QTextCursor::Start); // round again from the top
    m_page->find(m_sought->text());
}

} // namespace ui
