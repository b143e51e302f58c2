#include "ui/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace ui {

static const QColor ground(0x24, 0x26, 0x2a), panel(0x2d, 0x30, 0x35), field(0x1d, 0x1f, 0x22),
    raised(0x3a, 0x3e, 0x45), text(0xdc, 0xdf, 0xe4), faint(0x84, 0x8a, 0x94), accent(0xd9, 0x8e, 0x4a);

static QPalette palette() {
    QPalette out;
    out.setColor(QPalette::Window, panel);
    out.setColor(QPalette::WindowText, text);
    out.setColor(QPalette::Base, field);
    out.setColor(QPalette::AlternateBase, ground);
    out.setColor(QPalette::Text, text);
    out.setColor(QPalette::PlaceholderText, faint);
    out.setColor(QPalette::Button, raised);
    out.setColor(QPalette::ButtonText, text);
    out.setColor(QPalette::BrightText, Qt::white);
    out.setColor(QPalette::Highlight, accent);
    out.setColor(QPalette::HighlightedText, QColor(0x1a, 0x14, 0x0e));
    out.setColor(QPalette::ToolTipBase, raised);
    out.setColor(QPalette::ToolTipText, text);
    out.setColor(QPalette::Link, accent);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        out.setColor(QPalette::Disabled, role, QColor(0x6a, 0x70, 0x79));
    return out;
}

static const char* const sheet = R"(
    QMainWindow::separator { background: #1b1d20; width: 1px; height: 1px; }
    QMenuBar { background: #24262a; padding: 2px; }
    QMenuBar::item { padding: 4px 10px; border-radius: 3px; background: transparent; }
    QMenuBar::item:selected { background: #3a3e45; }
    QMenu { background: #2d3035; border: 1px solid #1b1d20; padding: 4px; }
    QMenu::item { padding: 5px 26px 5px 26px; border-radius: 3px; }
    QMenu::item:selected { background: #4a4f58; }
    QMenu::item:disabled { color: #6a7079; }
    QMenu::icon { padding-left: 6px; }
    QMenu::separator { height: 1px; background: #1b1d20; margin: 4px 6px; }
    QToolBar { background: #2d3035; border: none; padding: 4px; spacing: 2px; }
    QToolBar::separator { background: #1b1d20; width: 1px; height: 1px; margin: 4px; }
    QToolButton { border: 1px solid transparent; border-radius: 4px; padding: 4px; }
    QToolButton:hover { background: #3a3e45; }
    QToolButton:checked { background: #4b4034; border-color: #d98e4a; }
    QToolButton:pressed { background: #1d1f22; }
    QToolButton:disabled { color: #6a7079; }
    QToolBar#corner { background: #24262a; padding: 0 6px; margin: 0; }
    QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
    QToolBar#corner QToolButton { padding: 0 4px; margin: 0; border: none; }
    QToolBar#tools QToolButton { padding: 5px 6px; }
    QToolButton#axis { min-width: 44px; background: #3a3e45; }
    QToolButton#axis:checked { background: #4b4034; }
    QLabel#heading { color: #aeb4be; font-weight: bold; padding-top: 8px; }
    QLabel#cell { color: #aeb4be; padding: 0 7px; border-left: 1px solid #1b1d20; }
    QStatusBar { background: #24262a; }
    QStatusBar::item { border: none; }
    QSlider::groove:horizontal { height: 4px; background: #1d1f22; border-radius: 2px; }
    QSlider::sub-page:horizontal { background: #9c6a3c; border-radius: 2px; }
    QSlider::handle:horizontal { background: #dcdfe4; width: 10px; margin: -4px 0; border-radius: 5px; }
    QScrollArea { border: none; }
    QToolTip { background: #3a3e45; color: #dcdfe4; border: 1px solid #1b1d20; padding: 3px; }
    QProgressBar { background: #1d1f22; border: none; border-radius: 3px; text-align: center; max-height: 16px; }
    QProgressBar::chunk { background: #9c6a3c; border-radius: 3px; }
)";

void applyTheme(QApplication& application) {
    application.setStyle(QStyleFactory::create("Fusion"));
    application.setPalette(palette());
    application.setStyleSheet(sheet);
}

} // namespace ui
