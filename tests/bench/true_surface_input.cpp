// How long a person waits for the true surface: the real window, its view turned, left at rest and sculpted in, with
// the times from the last event to the first picture that rays have changed and to the final accuracy.
//
//     xvfb-run -s '-screen 0 1280x800x24' pointclay_true_surface_input MODEL|sample:ID [--quality PX] [--pictures
//     PREFIX]
#include "ui/theme/theme.h"
#include "ui/window/main_window.h"

#include <cstdio>
#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QMenu>
#include <QMouseEvent>
#include <QTemporaryDir>

namespace {

class Hand {
  public:
    Hand(ui::MainWindow& window, QString pictures) : m_window(window), m_pictures(std::move(pictures)) {
        window.viewport().refined = [this](const std::optional<ui::Refinement>& refinement) {
            const double now = seconds();
            if (refinement && refinement->quality > 0 && m_first < 0)
                m_first = now;
            if (refinement && refinement->complete)
                m_final = now;
        };
        window.viewport().shown = [this](std::uint64_t input) {
            if (m_shown < 0 && m_awaited > 0 && input >= m_awaited)
                m_shown = seconds();
        };
    }

    /// Until all levels have come; tells when they came after what was done before.
    void rest(const char* name) {
        waitUntil([this] { return m_final >= 0; }, 60);
        std::printf("%-24s first change %7.1f ms   final %7.1f ms", name, 1000 * m_first, 1000 * m_final);
        if (m_shown >= 0)
            std::printf("   the dab was seen after %.1f ms", 1000 * m_shown);
        std::printf("\n");
        if (!m_pictures.isEmpty())
            m_window.grab().save(QString("%1-%2.png").arg(m_pictures).arg(m_count++));
    }
    void begin() {
        m_clock.start();
        m_first = m_final = m_shown = -1;
        m_awaited = 0;
    }
    /// Another view: a drag of `pixels` in `frames` steps of 16 ms.
    void turn(double pixels, int frames) {
        const QPointF from = centre() - QPointF(pixels / 2, 0);
        send(QEvent::MouseButtonPress, from, Qt::RightButton);
        for (int k = 1; k <= frames; ++k) {
            send(QEvent::MouseMove, from + QPointF(pixels * k / frames, 0), Qt::RightButton);
            waitUntil([] { return false; }, 0.016);
        }
        begin();
        send(QEvent::MouseButtonRelease, from + QPointF(pixels, 0), Qt::RightButton);
    }
    /// One dab in the middle.
    void dab() {
        send(QEvent::MouseMove, centre(), Qt::NoButton);
        begin();
        send(QEvent::MouseButtonPress, centre(), Qt::LeftButton);
        m_awaited = m_window.sculptView().pointer().inputs();
        waitUntil([this] { return m_shown >= 0; }, 10);
        m_first = m_final = -1;
        send(QEvent::MouseButtonRelease, centre(), Qt::LeftButton);
    }
    template <class Condition>
    void waitUntil(const Condition& condition, double most) const {
        QElapsedTimer clock;
        for (clock.start(); !condition() && static_cast<double>(clock.elapsed()) < 1000 * most;)
            QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 2);
    }

  private:
    double seconds() const { return static_cast<double>(m_clock.nsecsElapsed()) * 1e-9; }
    QPointF centre() const { return QRectF(m_window.viewport().widget()->rect()).center(); }
    void send(QEvent::Type type, QPointF at, Qt::MouseButton button) {
        QWidget& view = *m_window.viewport().widget();
        const bool move = type == QEvent::MouseMove, release = type == QEvent::MouseButtonRelease;
        QMouseEvent event(type, at, view.mapToGlobal(at), move ? Qt::NoButton : button, release ? Qt::NoButton : button,
                          Qt::NoModifier);
        QApplication::sendEvent(&view, &event);
    }

    ui::MainWindow& m_window;
    QString m_pictures;
    QElapsedTimer m_clock;
    double m_first = -1, m_final = -1, m_shown = -1;
    std::uint64_t m_awaited = 0;
    int m_count = 0;
};

QString option(const QStringList& arguments, const char* name, const QString& fallback) {
    const auto at = arguments.indexOf(name);
    return at >= 0 && at + 1 < arguments.size() ? arguments[at + 1] : fallback;
}

void trace(ui::MainWindow& window, Hand& hand) {
    hand.waitUntil([] { return false; }, 1);
    hand.begin();
    for (QAction* action : window.menu("view")->actions())
        if (action->objectName() == "true-surface-on")
            action->trigger();
    hand.rest("switched on");
    hand.turn(4, 1);
    hand.rest("turned by 1 degree");
    hand.turn(36, 4);
    hand.rest("turned by 10 degrees");
    hand.turn(300, 60);
    hand.rest("orbit of a second");
    hand.dab();
    hand.rest("dab");
    hand.dab();
    hand.rest("another dab");
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    ui::applyTheme(application);
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() < 2) {
        std::fprintf(stderr,
                     "usage: pointclay_true_surface_input MODEL|sample:ID [--quality PX] [--pictures PREFIX]\n");
        return 2;
    }
    const QTemporaryDir folder;
    ui::WindowOptions options;
    options.settingsFile = folder.filePath("settings.ini");
    options.editor.journal = folder.filePath("journal.jsonl").toStdString();
    ui::MainWindow window(options);
    window.settings().truth.quality = option(arguments, "--quality", "1").toDouble();
    window.resize(1280, 800);
    window.show();
    Hand hand(window, option(arguments, "--pictures", {}));
    const std::string model = arguments[1].toStdString();
    const nlohmann::json open = model.starts_with("sample:")
                                    ? nlohmann::json{{"op", "new"}, {"sample", model.substr(7)}}
                                    : nlohmann::json{{"op", "open"}, {"path", model}};
    int code = 1;
    window.editor().run(open, [&](bool done) {
        if (done) {
            std::printf("drawn by %s, %zu surfels, %d x %d pixels\n", qPrintable(window.viewport().rendererName()),
                        window.editor().snapshot().surfels, window.viewport().widget()->width(),
                        window.viewport().widget()->height());
            trace(window, hand);
            code = 0;
        }
        std::fflush(stdout);
        window.editor().discardJournal();
        QApplication::exit(code);
    });
    return QApplication::exec();
}
