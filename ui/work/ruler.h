// Measures between picked places, off the interface's thread: the latest wanted only. Interface's thread only.
#pragma once

#include "ui/work/latest_worker.h"
#include "ui/work/ruler_table.h"

#include <QObject>

namespace ui {

class Ruler : public QObject {
    Q_OBJECT
  public:
    explicit Ruler(QObject* parent = nullptr);

    /// One that still runs is dropped. REQUIRES: as many places as the row wants.
    void measure(const RulerRow& row, const surface::Surface& surface, std::vector<RuledPlace> places,
                 const base::Vec3d& origin);
    void cancel() { m_worker.cancel(); }

  Q_SIGNALS:
    void measured(const ui::Ruled& ruled);
    void progressed(double share, QString doing); ///< 0 to 1
    void failed(QString message);
    void idled(); ///< nothing runs any more

  private:
    struct Request {
        const RulerRow* row = nullptr;
        surface::Surface surface;
        std::vector<RuledPlace> places;
        base::Vec3d origin;
    };
    LatestWorker<Request> m_worker;
};

} // namespace ui
