// What a left journal would bring back: the model it leads to, as a picture, and its steps in words. Replays the
// journal on a thread of its own; nothing of it is kept. Interface's thread only.
#pragma once

#include "core/session/recover.h"
#include "ui/work/latest_worker.h"

#include <QImage>
#include <QObject>
#include <QSize>

namespace ui {

/// "8 x Draw, 2 x Smooth", in the order of first use; "" for no step.
QString stepsText(const session::Recovery& recovery);

class RecoveryPreview : public QObject {
    Q_OBJECT
  public:
    explicit RecoveryPreview(QObject* parent = nullptr);
    /// Stops what is running.
    ~RecoveryPreview() override;
    void want(const std::filesystem::path& journal, QSize size);

  Q_SIGNALS:
    void shown(QImage picture, QString steps);
    void failed(QString why);
    void progressed(double share, QString doing);

  private:
    struct Wanted {
        std::filesystem::path journal;
        QSize size;
    };
    void make(const Wanted& wanted, const base::Progress& progress);

    std::unique_ptr<LatestWorker<Wanted>> m_worker; ///< last: its thread ends first
};

} // namespace ui
