// The application that the window tests run in, and that it starts where there is neither GPU nor desktop.
#include "support/registry.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>

/// Nothing that a test does may reach the person's own files.
QCoreApplication* makeApplication(int& argc, char** argv) {
    static const QTemporaryDir home;
    for (const char* name : {"HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
        qputenv(name, home.path().toUtf8());
    if (!qEnvironmentVariableIsSet("DISPLAY") && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    auto* application = new QApplication(argc, argv);
    ui::applyTheme(*application);
    return application;
}

class ApplicationTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void textIsReadableOnEveryGround();
};

/// Contrast as WCAG 2 defines it: 4.5 is enough for small text.
static double contrast(const QColor& a, const QColor& b) {
    const auto channel = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const auto light = [&](const QColor& c) {
        return 0.2126 * channel(c.redF()) + 0.7152 * channel(c.greenF()) + 0.0722 * channel(c.blueF());
    };
    const double la = light(a), lb = light(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

void ApplicationTest::textIsReadableOnEveryGround() {
    const auto back = qScopeGuard([] { ui::applyTheme(*qApp); });
    for (const ui::ThemeRow& row : ui::themeTable()) {
        ui::applyTheme(*qApp, row.id);
        const QPalette palette = QApplication::palette();
        const auto readable = [&](QPalette::ColorRole text, QPalette::ColorRole ground, double least) {
            return contrast(palette.color(text), palette.color(ground)) > least;
        };
        QVERIFY2(readable(QPalette::WindowText, QPalette::Window, 7), row.id);
        QVERIFY2(readable(QPalette::Text, QPalette::Base, 7), row.id);
        QVERIFY2(readable(QPalette::ButtonText, QPalette::Button, 4.5), row.id);
        QVERIFY2(readable(QPalette::HighlightedText, QPalette::Highlight, 4.5), row.id);
        QVERIFY2(readable(QPalette::ToolTipText, QPalette::ToolTipBase, 4.5), row.id);
    }
}

static const test::Registered<ApplicationTest> registered;
#include "application_test.moc"
