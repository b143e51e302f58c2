// Measures what measuring shadings show, and colours what is selected in all of them, off the interface's thread: after
// an edit, only the blocks near it.
//
//     interface                                  measuring thread
//     want(shading, surface, reference)   -->    evaluateField, automatic scale, colours
//     changed()  <-- colours(), scale()   <--    each time a version is done
//
// A newer version waits until the one at work is done, so that a long stroke cannot starve it; another shading, model
// or reference stops it at once. The scale stays while it fits: colours do not swim while a person works.
#pragma once

#include "core/render/shading/measured_colours.h"
#include "core/render/shading/selected_colours.h"
#include "ui/work/latest_worker.h"

#include <QObject>

namespace ui {

class Measurer : public QObject {
    Q_OBJECT
  public:
    explicit Measurer(QObject* parent = nullptr);

    // All on the interface's thread; they return at once.
    /// What the picture is to show from now on; a shading that measures nothing ends the work. `models` tells models
    /// apart (Snapshot::models). What is measured already is not measured again.
    /// `attribute`: which one Shading::Attribute shows.
    void want(render::Shading shading, const std::string& attribute, const surface::Surface& surface,
              const surface::Surface& reference, std::uint64_t models);
    /// Stops what is being measured; it stays without colours until something else is wanted.
    void cancel();
    bool busy() const { return m_busy; }
    /// For the shading wanted: of the last version measured, empty before the first, null where it measures nothing and
    /// nothing is selected.
    const std::shared_ptr<const render::BlockColours>& colours() const { return m_colours; }
    const std::optional<render::ColourScale>& scale() const { return m_scale; }

  Q_SIGNALS:
    void changed();                               ///< colours() and scale() are new
    void progressed(double share, QString doing); ///< 0 to 1
    void idled();                                 ///< nothing is being measured any more
    void failed(QString message);                 ///< what stopped it

  private:
    struct Request {
        render::Shading shading = render::Shading::Matcap;
        std::string attribute;
        surface::Surface surface, reference;
        std::uint64_t models = 0;
        bool sameSubject(const Request& o) const;
        bool selects() const; ///< the model carries a selection, maybe an empty one, that the shading leaves out
        bool operator==(const Request& o) const;
    };
    void work(const Request& request, const base::Progress& progress);
    render::Coloured measure(const Request& request, const base::Progress& progress);
    render::SelectedColours select(const Request& request, const render::Coloured& measured) const;
    void rest();

    Request m_wanted; ///< interface's
    std::shared_ptr<const render::BlockColours> m_colours;
    std::optional<render::ColourScale> m_scale;
    bool m_busy = false;

    /// Measuring thread's.
    struct Done {
        Request request;
        render::Coloured measured; ///< empty where the shading measures nothing
        render::SelectedColours colours;
    };
    void receive(const Done& done);
    std::optional<Done> m_last;
    LatestWorker<Request> m_worker; ///< last: it uses all of the above
};

} // namespace ui
