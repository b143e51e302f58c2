#include "ui/window/run_window.h"

#include "core/process/samples/samples.h"
#include "ui/settings/settings_file.h"
#include "ui/theme/icon.h"
#include "ui/theme/theme.h"
#include "ui/window/guarded_application.h"
#include "ui/window/main_window.h"
#include "ui/window/welcome.h"
#include "ui/words/language.h"

#include <clocale>
#include <cstdio>
#include <QLocale>
#include <QTimer>
#include <string_view>
#include <sys/mman.h>

namespace ui {

static void prepare(QApplication& application) {
    QApplication::setApplicationName("pointclay");
    QApplication::setApplicationDisplayName("Pointclay");
    QApplication::setApplicationVersion(POINTCLAY_VERSION);
    QApplication::setDesktopFileName("pointclay");
    QApplication::setWindowIcon(icon("pointclay"));
    const Settings settings = SettingsFile().read();
    speak(application, languageFor(settings.language, QLocale::system().uiLanguages()));
    applyTheme(application, settings.theme);
}

/// Without any display Qt would abort instead of telling.
static bool hasDisplay(int argc, char** argv) {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (!qEnvironmentVariableIsEmpty(name))
            return true;
    for (int i = 1; i < argc; ++i)
        if (std::string_view(argv[i]) == "-platform")
            return true;
    return false;
}

/// Room that Qt, its plugins and the threads of a window take before there is a model. With less they crash in places
/// that no program can catch.
static bool hasRoom() {
    constexpr std::size_t needed = std::size_t(384) << 20;
    void* const room = ::mmap(nullptr, needed, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    return room != MAP_FAILED && ::munmap(room, needed) == 0;
}

/// The first thing that a person sees: what they asked for, what a crash has left, or a lump of clay.
static void fill(MainWindow& window, const std::filesystem::path* model) {
    if (model)
        window.files().openArgument(model->string());
    else
        window.files().make(process::sampleTable().front().id);
}

int runWindow(int argc, char** argv, const std::vector<std::filesystem::path>& models) {
    if (!hasDisplay(argc, argv)) {
        std::fprintf(stderr,
                     "pointclay: there is no display to open a window on; set DISPLAY, or work without a window: "
                     "pointclay --help\n");
        return 1;
    }
    if (!hasRoom()) {
        std::fprintf(stderr,
                     "pointclay: not enough memory for a window; raise the limit (ulimit -v), or work without a "
                     "window: pointclay --help\n");
        return 1;
    }
    installLastWords();
    GuardedApplication application(argc, argv);
    // Qt has taken over the person's locale. Numbers are written and read with a point everywhere, as in files.
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
    prepare(application);
    std::vector<std::unique_ptr<MainWindow>> windows;
    std::function<MainWindow&()> addWindow = [&]() -> MainWindow& {
        windows.push_back(std::make_unique<MainWindow>());
        windows.back()->openAnother = [&](const std::filesystem::path& model) { addWindow().files().open(model); };
        windows.back()->show();
        return *windows.back();
    };
    // Once the loop runs, so that a question about lost work has a window behind it.
    const auto start = [&] {
        const bool recovering = windows.front()->files().offerRecovery();
        if (models.empty() && !recovering) {
            fill(*windows.front(), nullptr);
            showStart(*windows.front());
        }
        for (std::size_t i = 0; i < models.size(); ++i)
            fill(i == 0 && !recovering ? *windows.front() : addWindow(), &models[i]);
    };
    addWindow();
    QTimer::singleShot(0, &application, start);
    return QApplication::exec();
}

} // namespace ui
