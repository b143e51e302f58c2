// How long a hand waits for its picture: drives the real window with timed mouse events, as a person's hand would send
// them, and prints how long it took from each event to the picture that shows it.
//
//     xvfb-run -s '-screen 0 1280x800x24' pointclay_window_input [--seconds 60] [--surfels 1000000] [--hz 125]
//         [--tools usual|all|NAME,NAME...] [--picture OUT.png] [--record OUT.jsonl]
//
// Strokes of nine usual tools with three radii follow each other, each some 500 pixels in a second and a half, with
// turns of the view between; or one of each tool that is asked for.
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
    QString tool; ///< empty: turns the view
    double radiusPx;
};
const std::vector<Move> usual = {
    {"draw", 50},       {"clay", 80}, {"smooth", 60}, {"", 0},       {"grab", 100},   {"clay-strips", 40},
    {"inflate", 60},    {"", 0},      {"crease", 30}, {"draw", 120}, {"smooth", 120}, {"flatten", 80},
    {"snake-hook", 50}, {"", 0},
};
constexpr double usualRadius = 60; ///< of tools by name
constexpr std::size_t strokesPerTurn = 4;

/// What `--tools` says.
std::vector<Move> movesOf(const QString& tools, const ui::MainWindow& window) {
    if (tools == "usual")
        return usual;
    QStringList names = tools.split(',');
    if (tools == "all") {
        names.clear();
        for (const QAction* tool : window.toolBar().toolActions())
            names.push_back(tool->data().toString());
    }
    std::vector<Move> out;
    for (const QString& name : names) {
        out.push_back({name, usualRadius});
        if (out.size() % (strokesPerTurn + 1) == strokesPerTurn)
            out.push_back({"", 0});
    }
    return out;
}

constexpr double moveSeconds = 1.5, pauseSeconds = 0.2;

struct Sample {
    std::uint64_t input;
    double due;
    const Move* move;
};

class Driver : public QObject {
  public:
    Driver(ui::MainWindow& window, std::vector<Move> moves, double seconds, double hz)
        : m_window(window), m_moves(std::move(moves)), m_seconds(seconds), m_hz(hz) {
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
            return !each.move->tool.isEmpty() && each.input > changing && each.input <= taken;
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
        const Move& move = m_moves[static_cast<std::size_t>(index) % m_moves.size()];
        const double u = (due - index * slot) / moveSeconds;
        if (u > 1 && !m_down)
            return;
        if (u > 1)
            return send(QEvent::MouseButtonRelease, m_at, due, move);
        m_at = place(index, u, move);
        if (m_down)
            return send(QEvent::MouseMove, m_at, due, move);
        if (!move.tool.isEmpty())
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
        return view.center() + (!move.tool.isEmpty() ? loop : QPointF(220 * (u - 0.5), 40 * std::sin(6 * u)));
    }

    void send(QEvent::Type type, QPointF at, double due, const Move& move) {
        QWidget& view = *m_window.viewport().widget();
        const Qt::MouseButton button = !move.tool.isEmpty() ? Qt::LeftButton : Qt::RightButton;
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
    const std::vector<Move> m_moves;
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
        const bool stroke = !move->tool.isEmpty();
        (stroke ? strokes : turns).push_back(seconds);
        if (stroke)
            tools[move->tool.toStdString()].push_back(seconds);
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
    const auto tools = arguments.indexOf("--tools");
    std::vector<Move> moves = movesOf(tools >= 0 ? arguments.value(tools + 1) : "usual", window);
    const double once = (moveSeconds + pauseSeconds) * static_cast<double>(moves.size());
    Driver driver(window, std::move(moves), option(arguments, "--seconds", tools >= 0 ? once : 60),
                  option(arguments, "--hz", 125));
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
