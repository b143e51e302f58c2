// What a command would make of the model, tried on a copy of the document by a thread of its own; nothing of it is
// kept. A wish replaces the one before, and stops it. Interface's thread only.
// While a command spreads samples over the model, these are shown, a round after the other and no faster than an eye
// follows (floaters.h).
#pragma once

#include "ui/work/editor.h"
#include "ui/work/latest_worker.h"

namespace ui {

struct Previewed {
    Snapshot after;
    /// Where surfels stand that would go, if the command does nothing but take some out; every so many of them.
    std::vector<base::Vec3d> gone;
    QString said; ///< by the command, a line for each message
};

/// Places of the surfels of `before` that `after` has not, if it has no others; else none. Evenly thinned to `most`.
std::vector<base::Vec3d> goneFrom(const tree::SurfelTree& before, const tree::SurfelTree& after, std::size_t most);

class CommandPreview : public QObject {
    Q_OBJECT
  public:
    static constexpr std::size_t mostShown = 20000;

    /// The editor outlives it.
    explicit CommandPreview(Editor& editor, QObject* parent = nullptr);
    /// Stops what is running.
    ~CommandPreview() override;
    void want(const nlohmann::json& command);
    /// How long a round of samples is seen, at least, of what is wanted from now on.
    void setRoundMs(int ms) { m_roundMs = ms; }
    /// Nothing that was wanted will be shown.
    void cancel();

  Q_SIGNALS:
    void shown(const Previewed& found);
    void spread(const Snapshot& floaters); ///< what it has so far, of commands that spread samples over the model
    void failed(QString why);
    void progressed(double share, QString doing);

  private:
    struct Wanted {
        session::Document document;
        nlohmann::json command;
        std::uint64_t wish = 0;
        int roundMs = 0;
    };
    void make(const Wanted& wanted, const base::Progress& progress);
    /// On the interface's thread, unless something else is wanted by now.
    template <class Call>
    void answer(std::uint64_t wish, Call call);

    Editor& m_editor;
    int m_roundMs = 60;
    std::uint64_t m_wish = 0;                       ///< the last, by number
    std::unique_ptr<LatestWorker<Wanted>> m_worker; ///< last: its thread ends first
};

} // namespace ui
