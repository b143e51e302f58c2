// How long a hand waits for its picture: drives the real window with timed mouse events, as a person's hand would send
// them, and prints how long it took from each event to the picture that shows it.
//
//     xvfb-run -s '-screen 0 1280x800x24' pointclay_window_input [--seconds 60] [--surfels 1000000] [--hz 125]
//         [--picture OUT.png] [--record OUT.jsonl]
//
// Strokes of nine tools with three radii follow each other, each some 500 pixels in a second and a half, with
// turns of the view between.
// Times count from when an event was due, not from when the window got round to it. Events that make no dab, for being
// closer than the spacing, have no picture to wait for and do not count.
#include "ui/panels/tool_bar.h"
#include "ui/theme/theme.h"
#include "ui/window/main_window.h"
#include "ui/window/status_line.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <numbers>
#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QTimer>

namespace {

using Gesture = ui::PointerRouter::Gesture;

/// A stroke or a turn of the view, `moveSeconds` long.
struct Move {
    const char* tool; ///< null: turns the view
    double radiusPx;
};
constexpr Move moves[] = {
    {"draw", 50},        {"clay", 80},    {"smooth", 60},     {nullptr, 0},   {"grab", 100},
    {"clay-strips", 40}, {"inflate", 60}, {nullptr, 0},       {"crease", 30}, {"draw", 120},
    {"smooth", 120},     {"flatten", 80}, {"snake-hook", 50}, {nullptr, 0},
};
constexpr double moveSeconds = 1.5, pauseSeconds = 0.2;

struct Sample {
    std::uint64_t input;
    double due;
    const Move* move;
};

class Driver : public QObject {
  public:
    Driver(ui::MainWindow& window, double seconds, double hz) : m_window(window), m_seconds(seconds), m_hz(hz) {
        window.viewport().shown = [this](std::uint64_t input) { answered(input); };
        window.viewport().framePainted = [this](double taken) { frames.push_back(taken); };
        m_timer.setTimerType(Qt::PreciseTimer);
        connect(&m_timer, &QTimer::timeout, this, &Driver::step);
    }
    void start() {
        m_clock.start();
        m_timer.start(1);
    }
    std::function<void()> finished;
    std::vector<std::pair<double, const Move*>> times; ///< seconds from event to picture
    std::vector<double> frames;                        ///< seconds that the renderer took for each

  private:
    double now() const { return static_cast<double>(m_clock.nsecsElapsed()) * 1e-9; }

    /// Those that the engine has taken without a change.
    void dropIdle() {
        const ui::Editor& editor = m_window.editor();
        const std::uint64_t taken = editor.takenInput(), changing = editor.changingInput();
        std::erase_if(m_open, [&](const Sample& each) {
            return each.move->tool && each.input > changing && each.input <= taken;
        });
    }

    /// All events that are due by now.
    void step() {
        dropIdle();
        while (m_next / m_hz <= now() && m_next / m_hz < m_seconds)
            event(m_next++ / m_hz);
        if (now() > m_seconds + 2) {
            m_timer.stop();
            finished();
        }
    }

    void event(double due) {
        const double slot = moveSeconds + pauseSeconds;
        const auto index = static_cast<int>(due / slot);
        const Move& move = moves[static_cast<std::size_t>(index) % std::size(moves)];
        const double u = (due - index * slot) / moveSeconds;
        if (u > 1 && !m_down)
            return;
        if (u > 1)
            return send(QEvent::MouseButtonRelease, m_at, due, move);
        m_at = place(index, u, move);
        if (m_down)
            return send(QEvent::MouseMove, m_at, due, move);
        if (move.tool)
            choose(move);
        send(QEvent::MouseMove, m_at, due, move);
        send(QEvent::MouseButtonPress, m_at, due, move);
    }

    void choose(const Move& move) {
        for (QAction* tool : m_window.toolBar().toolActions())
            if (tool->data().toString() == move.tool)
                tool->trigger();
        m_window.settings().radiusPx = move.radiusPx;
    }

    /// Loops and sweeps about the middle of the view, another one each time.
    QPointF place(int index, double u, const Move& move) const {
        const QRectF view = m_window.viewport().widget()->rect();
        const double size = 0.16 * std::min(view.width(), view.height()), turn = 2.4 * index;
        const double angle = 2 * std::numbers::pi * u * (index % 3 == 0 ? 1 : 0.5) + turn;
        const QPointF loop(std::cos(angle) * size, std::sin(2 * angle) * size * 0.6);
        return view.center() + (move.tool ? loop : QPointF(220 * (u - 0.5), 40 * std::sin(6 * u)));
    }

    void send(QEvent::Type type, QPointF at, double due, const Move& move) {
        QWidget& view = *m_window.viewport().widget();
        const Qt::MouseButton button = move.tool ? Qt::LeftButton : Qt::RightButton;
        const bool press = type == QEvent::MouseButtonPress, release = type == QEvent::MouseButtonRelease;
        QMouseEvent event(type, at, view.mapToGlobal(at), press || release ? button : Qt::NoButton,
                          release || (!press && !m_down) ? Qt::NoButton : button, Qt::NoModifier);
        m_down = press || (m_down && !release);
        QApplication::sendEvent(&view, &event);
        if (!release && m_window.sculptView().pointer().gesture() != Gesture::None)
            m_open.push_back({m_window.sculptView().pointer().inputs(), due, &move});
    }

    void answered(std::uint64_t input) {
        for (; !m_open.empty() && m_open.front().input <= input; m_open.pop_front())
            times.emplace_back(now() - m_open.front().due, m_open.front().move);
    }

    ui::MainWindow& m_window;
    double m_seconds, m_hz;
    QTimer m_timer;
    QElapsedTimer m_clock;
    int m_next = 0;
    bool m_down = false;
    QPointF m_at;
    std::deque<Sample> m_open; ///< no picture yet
};

void print(const char* name, std::vector<double> seconds) {
    if (seconds.empty())
        return;
    std::sort(seconds.begin(), seconds.end());
    const auto at = [&](double part) {
        return 1000 * seconds[static_cast<std::size_t>(part * static_cast<double>(seconds.size() - 1))];
    };
    std::printf("%-14s %6zu times   p50 %6.1f   p90 %6.1f   p99 %6.1f   max %6.1f ms\n", name, seconds.size(), at(0.5),
                at(0.9), at(0.99), at(1));
}

void report(const Driver& driver) {
    std::vector<double> strokes, turns;
    std::map<std::string, std::vector<double>> tools;
    for (const auto& [seconds, move] : driver.times) {
        (move->tool ? strokes : turns).push_back(seconds);
        if (move->tool)
            tools[move->tool].push_back(seconds);
    }
    print("frames", driver.frames);
    print("strokes", strokes);
    print("turns", turns);
    for (const auto& [tool, seconds] : tools)
        print(("  " + tool).c_str(), seconds);
}

double option(const QStringList& arguments, const char* name, double fallback) {
    const auto at = arguments.indexOf(name);
    return at >= 0 && at + 1 < arguments.size() ? arguments[at + 1].toDouble() : fallback;
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    ui::applyTheme(application);
    const QStringList arguments = QApplication::arguments();
    const QTemporaryDir folder;
    ui::WindowOptions options;
    options.settingsFile = folder.filePath("settings.ini");
    options.editor.journal = folder.filePath("journal.jsonl").toStdString();
    ui::MainWindow window(options);
    window.resize(1280, 800);
    window.show();
    Driver driver(window, option(arguments, "--seconds", 60), option(arguments, "--hz", 125));
    driver.finished = [&] {
        report(driver);
        const auto picture = arguments.indexOf("--picture");
        if (picture >= 0 && picture + 1 < arguments.size())
            window.grab().save(arguments[picture + 1]);
        const auto session = arguments.indexOf("--record");
        if (session >= 0 && session + 1 < arguments.size())
            QFile::copy(folder.filePath("journal.jsonl"), arguments[session + 1]);
        std::fflush(stdout);
        window.editor().discardJournal();
        QApplication::exit();
    };
    window.editor().run({{"op", "new"}, {"sample", "clay"}, {"count", int(option(arguments, "--surfels", 1e6))}},
                        [&](bool) {
                            std::printf("drawn by %s, %zu surfels\n", qPrintable(window.viewport().rendererName()),
                                        window.editor().snapshot().surfels);
                            QTimer::singleShot(1000, &driver, [&] { driver.start(); });
                        });
    return QApplication::exec();
}
