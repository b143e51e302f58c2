#include "ui/work/ruler.h"

#include "ui/work/post.h"

namespace ui {

Ruler::Ruler(QObject* parent)
    : QObject(parent),
      m_worker(
          [this](const Request& request, const base::Progress& stop) {
              const base::Progress progress = postedProgress(
                  stop, this, [this](double share, const QString& doing) { Q_EMIT progressed(share, doing); });
              Ruled found = request.row->measure(request.surface, request.places, request.origin, progress);
              post(this, [this, found = std::move(found)] { Q_EMIT measured(found); });
          },
          [this](const std::exception& error) { post(this, [this, text = textOf(error)] { Q_EMIT failed(text); }); },
          [this] {
              postRest(
                  this, [this] { return m_worker.busy(); }, [this] { Q_EMIT idled(); });
          }) {}

void Ruler::measure(const RulerRow& row, const surface::Surface& surface, std::vector<RuledPlace> places,
                    const base::Vec3d& origin) {
    m_worker.request({&row, surface, std::move(places), origin}, true);
}

} // namespace ui
