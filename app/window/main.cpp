// pointclay-window: what `pointclay` becomes without a subcommand. The only program of ours that knows Qt.
#include "app/command_line.h"
#include "core/base/parallel.h"
#include "ui/window/run_window.h"

static int work(int argc, char** argv) {
    CLI::App program("", "pointclay");
    app::CommonOptions common;
    app::describe(program, common);
    if (const auto code = app::parse(program, argc, argv))
        return *code;
    base::setThreadCount(common.threads);
    return ui::runWindow(argc, argv, {common.models.begin(), common.models.end()});
}

int main(int argc, char** argv) {
    return app::guarded([&] { return work(argc, argv); });
}
