#include "ui/theme/theme.h"

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
    QToolButton#plain, QToolButton#tool-parameter { background: #3a3e45; padding: 2px 6px; min-height: 16px; }
    QToolButton#plain:hover { background: #474c54; }
    QToolButton#plain:checked { background: #5c4630; }
    QToolButton#plain:pressed { background: #1d1f22; }
    QToolButton#heading { background: #35383e; color: #c6cbd3; font-weight: bold; text-align: left; border: none;
        border-radius: 0; padding: 3px 8px; }
    QToolButton#heading:hover { background: #3d4147; }
    QLabel#title { font-weight: bold; font-size: 11pt; }
    QLabel#faint { color: #b6bcc6; }
    QLabel#hint { color: #d9b48e; }
    QLabel#stamp-picture { background: #1d1f22; border: 1px solid #1b1d20; border-radius: 4px; }
    QComboBox { background: #3a3e45; border: 1px solid transparent; border-radius: 4px; padding: 1px 6px;
        min-height: 18px; }
    QComboBox:hover { background: #474c54; }
    QComboBox:disabled { color: #6a7079; }
    QComboBox::drop-down { border: none; width: 16px; }
    QComboBox::down-arrow { image: url(:/icons/down.svg); width: 10px; height: 10px; }
    QCheckBox { spacing: 6px; color: #c6cbd3; }
    QLabel#cell { color: #aeb4be; padding: 0 7px; border-left: 1px solid #1b1d20; }
    QStatusBar { background: #24262a; }
    QStatusBar::item { border: none; }
    QSlider::groove:horizontal { height: 4px; background: #1d1f22; border-radius: 2px; }
    QSlider::sub-page:horizontal { background: #9c6a3c; border-radius: 2px; }
    QSlider::handle:horizontal { background: #dcdfe4; width: 10px; margin: -4px 0; border-radius: 5px; }
    QScrollArea { border: none; }
    QScrollBar:vertical { background: #2d3035; width: 8px; margin: 0; }
    QScrollBar::handle:vertical { background: #4a4f58; border-radius: 3px; min-height: 24px; margin: 1px; }
    QScrollBar::handle:vertical:hover { background: #5d636e; }
    QScrollBar::add-line:vertical, QScrollBar::sub-line:vertical { height: 0; }
    QScrollBar::add-page:vertical, QScrollBar::sub-page:vertical { background: none; }
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
