#include "ui/run_window.h"

#include "core/process/samples.h"
#include "ui/icon.h"
#include "ui/main_window.h"
#include "ui/theme.h"

#include <QApplication>
#include <QTimer>

namespace ui {

static void prepare(QApplication& application) {
    QApplication::setApplicationName("pointclay");
    QApplication::setApplicationDisplayName("Pointclay");
    QApplication::setApplicationVersion(POINTCLAY_VERSION);
    QApplication::setDesktopFileName("pointclay");
    QApplication::setWindowIcon(icon("pointclay"));
    applyTheme(application);
}

/// The first thing that a person sees: what they asked for, what a crash has left, or a lump of clay.
static void fill(MainWindow& window, const std::filesystem::path* model) {
    if (model)
        window.files().open(*model);
    else
        window.files().make(process::sampleTable().front().id);
}

int runWindow(int argc, char** argv, const std::vector<std::filesystem::path>& models) {
    QApplication application(argc, argv);
    prepare(application);
    std::vector<std::unique_ptr<MainWindow>> windows;
    const auto addWindow = [&]() -> MainWindow& {
        windows.push_back(std::make_unique<MainWindow>());
        windows.back()->show();
        return *windows.back();
    };
    // Once the loop runs, so that a question about lost work has a window behind it.
    const auto start = [&] {
        const bool recovering = windows.front()->files().offerRecovery();
        if (models.empty() && !recovering)
            fill(*windows.front(), nullptr);
        for (std::size_t i = 0; i < models.size(); ++i)
            fill(i == 0 && !recovering ? *windows.front() : addWindow(), &models[i]);
    };
    addWindow();
    QTimer::singleShot(0, &application, start);
    return QApplication::exec();
}

} // namespace ui
