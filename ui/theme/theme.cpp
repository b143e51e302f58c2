#include "ui/theme/theme.h"

#include "ui/theme/icon.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>
#include <QWidget>

namespace ui {

namespace {

/// What a colour is for, in the dark and in the light: the sheet names roles. Longer names stand first, since one may
/// begin another.
struct Role {
    const char *name, *dark, *light;
};
constexpr Role roles[] = {
    {"@headinghover", "#3d4147", "#d2d6dc"}, {"@placeholder", "#848a94", "#747b86"},
    {"@stronger", "#5d636e", "#a4abb6"},     {"@disabled", "#6a7079", "#9aa0aa"},
    {"@selected", "#5c4630", "#f0cda6"},     {"@onaccent", "#1a140e", "#ffffff"},
    {"@checked", "#4b4034", "#f3dcc3"},      {"@heading", "#35383e", "#dcdfe4"},
    {"@ground", "#24262a", "#dfe2e6"},       {"@raised", "#3a3e45", "#d3d7dd"},
    {"@strong", "#4a4f58", "#bcc2cb"},       {"@figure", "#aeb4be", "#4b525c"},
    {"@accent", "#d98e4a", "#a95f18"},       {"@filled", "#9c6a3c", "#dd9a5c"},
    {"@chosen", "#ffffff", "#1f2329"},       {"@panel", "#2d3035", "#eceef1"},
    {"@hover", "#474c54", "#c5cad2"},        {"@field", "#1d1f22", "#ffffff"},
    {"@faint", "#b6bcc6", "#565d67"},        {"@line", "#1b1d20", "#c2c6cc"},
    {"@text", "#dcdfe4", "#1f2329"},         {"@soft", "#c6cbd3", "#333941"},
    {"@hint", "#d9b48e", "#8a4c12"},
};

} // namespace

static QColor colour(const char* name, bool light) {
    for (const Role& role : roles)
        if (std::string_view(role.name).substr(1) == name)
            return QColor(light ? role.light : role.dark);
    return {};
}

static QPalette palette(bool light) {
    QPalette out;
    const std::pair<QPalette::ColorRole, const char*> uses[] = {{QPalette::Window, "panel"},
                                                                {QPalette::WindowText, "text"},
                                                                {QPalette::Base, "field"},
                                                                {QPalette::AlternateBase, "ground"},
                                                                {QPalette::Text, "text"},
                                                                {QPalette::PlaceholderText, "placeholder"},
                                                                {QPalette::Button, "raised"},
                                                                {QPalette::ButtonText, "text"},
                                                                {QPalette::BrightText, "chosen"},
                                                                {QPalette::Highlight, "accent"},
                                                                {QPalette::HighlightedText, "onaccent"},
                                                                {QPalette::ToolTipBase, "raised"},
                                                                {QPalette::ToolTipText, "text"},
                                                                {QPalette::Link, "accent"}};
    for (const auto& [role, name] : uses)
        out.setColor(role, colour(name, light));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        out.setColor(QPalette::Disabled, role, colour("disabled", light));
    return out;
}

static const char* const sheet = R"(
    QMainWindow::separator { background: @line; width: 1px; height: 1px; }
    QMenuBar { background: @ground; padding: 2px; }
    QMenuBar::item { padding: 4px 10px; border-radius: 3px; background: transparent; }
    QMenuBar::item:selected { background: @raised; }
    QMenu { background: @panel; border: 1px solid @line; padding: 4px; }
    QMenu::item { padding: 3px 26px 3px 26px; border-radius: 3px; }
    QMenu::item:selected { background: @strong; }
    QMenu::item:disabled { color: @disabled; }
    QMenu::icon { padding-left: 6px; }
    QListWidget::item { padding: 4px 8px; }
    QListWidget::item:selected { background: @strong; color: @accent; }
    QMenu::separator { height: 1px; background: @line; margin: 4px 6px; }
    QToolBar { background: @panel; border: none; padding: 4px; spacing: 2px; }
    QToolBar::separator { background: @line; width: 1px; height: 1px; margin: 4px; }
    QToolButton { border: 1px solid transparent; border-radius: 4px; padding: 4px; }
    QToolButton:hover { background: @raised; }
    QToolButton:checked { background: @checked; border-color: @accent; }
    QToolButton:pressed { background: @field; }
    QToolButton:disabled { color: @disabled; }
    QToolButton[popupMode="2"] { padding-right: 15px; }
    QToolButton#qt_toolbar_ext_button { padding: 0; }
    QToolButton::menu-indicator { subcontrol-origin: padding; subcontrol-position: center right; right: 3px; }
    QFrame#gap { color: @strong; }
    QWidget#corner { background: @ground; }
    QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
    QWidget#corner QToolButton { padding: 2px 5px; margin: 0; border: none; }
    QToolBar#tools QToolButton { padding: 5px 6px; }
    QToolButton#plain, QToolButton#tool-parameter { background: @raised; padding: 2px 6px; min-height: 16px; }
    QToolButton#plain:hover { background: @hover; }
    QToolButton#plain:checked { background: @selected; }
    QToolButton#plain:pressed { background: @field; }
    QToolButton#heading { background: @heading; color: @soft; font-weight: bold; text-align: left; border: none;
        border-radius: 0; padding: 3px 8px; }
    QToolButton#heading:hover { background: @headinghover; }
    QLabel#title { font-weight: bold; font-size: 11pt; }
    QLabel#faint { color: @faint; }
    QLabel#hint { color: @hint; }
    QLabel#stamp-picture { background: @field; border: 1px solid @line; border-radius: 4px; }
    QComboBox { background: @raised; border: 1px solid transparent; border-radius: 4px; padding: 1px 6px;
        min-height: 18px; }
    QComboBox:hover { background: @hover; }
    QComboBox:disabled { color: @disabled; }
    QComboBox::drop-down { border: none; width: 16px; }
    QComboBox::down-arrow { image: url(:/icons/down.svg); width: 10px; height: 10px; }
    QComboBox QAbstractItemView { background: @panel; color: @text; border: 1px solid @line; outline: none;
        padding: 3px; selection-background-color: @selected; selection-color: @chosen; }
    QComboBox QAbstractItemView::item { min-height: 20px; padding: 1px 6px; color: @text; }
    QComboBox QAbstractItemView::item:selected { background: @selected; color: @chosen; border-radius: 3px; }
    QToolBar[floating="true"] { border: 1px solid @line; border-radius: 7px; padding: 5px 8px; spacing: 5px; }
    QFrame#card { background: @panel; border: 1px solid @strong; border-radius: 9px; }
    QFrame#card QToolButton#plain { padding: 5px 10px; }
    QFrame#card QToolButton#plain:focus { border-color: @accent; }
    QCheckBox { spacing: 6px; color: @soft; }
    QLabel#cell { color: @figure; padding: 0 7px; border-left: 1px solid @line; }
    QStatusBar { background: @ground; }
    QStatusBar::item { border: none; }
    QSlider::groove:horizontal { height: 4px; background: @field; border-radius: 2px; }
    QSlider::sub-page:horizontal { background: @filled; border-radius: 2px; }
    QSlider::handle:horizontal { background: @text; width: 10px; margin: -4px 0; border-radius: 5px; }
    QScrollArea { border: none; }
    QScrollBar:vertical { background: @panel; width: 8px; margin: 0; }
    QScrollBar::handle:vertical { background: @strong; border-radius: 3px; min-height: 24px; margin: 1px; }
    QScrollBar::handle:vertical:hover { background: @stronger; }
    QScrollBar::add-line:vertical, QScrollBar::sub-line:vertical { height: 0; }
    QScrollBar::add-page:vertical, QScrollBar::sub-page:vertical { background: none; }
    QToolTip { background: @raised; color: @text; border: 1px solid @line; padding: 3px; }
    QProgressBar { background: @field; border: none; border-radius: 3px; text-align: center; max-height: 16px; }
    QProgressBar::chunk { background: @filled; border-radius: 3px; }
)";

std::span<const ThemeRow> themeTable() {
    static const ThemeRow rows[] = {
        {"dark", "Dark", "Light on dark: the model is the brightest thing there"},
        {"light", "Light", "Dark on light, for bright rooms"},
        {"desktop", "As the Desktop", "Dark or light as the desktop was when the program started"},
    };
    return rows;
}

void applyTheme(QApplication& application, std::string_view id) {
    static const bool desktopIsLight = QApplication::palette().color(QPalette::Window).lightness() > 127;
    const bool light = id == "light" || (id == "desktop" && desktopIsLight);
    QString text = sheet;
    for (const Role& role : roles)
        text.replace(role.name, light ? role.light : role.dark);
    setIconColour(colour("text", light));
    application.setStyle(QStyleFactory::create("Fusion"));
    application.setPalette(palette(light));
    application.setStyleSheet(text);
    for (QWidget* widget : QApplication::allWidgets())
        widget->update();
}

} // namespace ui
