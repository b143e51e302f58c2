// What the window remembers between two runs: a plain value with defaults, compared with ==, read from and written to
// QSettings. Options of a stroke are those of one tool or of all (sculpt/stroke/stroke_options.h). Nothing here changes
// a model; a stroke takes what it needs with strokeSettings().
//
// Reading is forgiving: what is missing, unknown or out of range keeps its default, so that a settings file of another
// version never stops the program.
#pragma once

#include "core/raycast/lighting.h"
#include "core/render/overlay/annotations.h"
#include "core/render/renderer.h"
#include "core/sculpt/stroke/stroke_options.h"
#include "ui/view/saved_views.h"

#include <QByteArray>
#include <QMap>
#include <QVariant>
#include <string>
#include <vector>

class QSettings;

namespace ui {

enum class RadiusUnit {
    Pixels, ///< the brush keeps its size on the screen
    Model   ///< the brush keeps its size on the model
};

/// Of showing the surface itself instead of splats.
struct TruthSettings {
    static constexpr double minQuality = 0.25, maxQuality = 8;
    bool on = false;
    double quality = 1;         ///< in pixels (adaptive_cast.h)
    raycast::Lighting lighting; ///< of cast pictures for files, too
    bool operator==(const TruthSettings&) const = default;
};

struct Settings {
    std::string tool;                 ///< id of the chosen tool; empty: the table's first
    std::string shiftTool = "smooth"; ///< the tool while Shift is held
    RadiusUnit radiusUnit = RadiusUnit::Pixels;
    double radiusPx = 50;
    double radiusModel = 0.1;
    sculpt::StrokeSettings shared;                       ///< of which the options of sculpt::Scope::AllTools count
    std::map<std::string, sculpt::StrokeSettings> tools; ///< by id, what a person has set; else sculpt::defaultsOf
    std::map<std::string, bool> groups;                  ///< of the panel, by id: open or shut by a person
    render::Shading shading = render::Shading::Matcap;
    std::string attribute; ///< that Shading::Attribute shows
    render::Backdrop backdrop = render::Backdrop::Studio;
    render::Effects effects = 0;
    render::Annotated annotated = render::Legend;
    bool grid = false;       ///< on the ground
    bool edges = false;      ///< lines along what stays sharp
    bool leftHanded = false; ///< tools on the right, panels on the left
    bool gizmo = true;       ///< axes to click, in the corner of the picture
    bool previews = true;    ///< dialogs show in the picture what would come
    TruthSettings truth;
    std::map<std::string, std::string> keys; ///< of actions, by id, where a person has chosen others (window/keys.h)
    std::string theme = "dark";              ///< id of a row of ui::themeTable()
    std::string language = "system";         ///< id of a row of ui::languageTable()
    int historyMib = 1024;                   ///< memory that the steps back may hold
    std::string navigation = "turntable";    ///< id of the style in which dragging turns the view
    std::vector<SavedView> savedViews;       ///< names differ
    std::vector<std::string> recentFiles;    ///< newest first, at most `recentLimit`
    QByteArray geometry, windowState;        ///< as QMainWindow saves them

    static constexpr std::size_t recentLimit = 10;
    static constexpr double minRadiusPx = 2, maxRadiusPx = 500;
    bool operator==(const Settings&) const = default;

    const sculpt::ToolRow& toolRow() const;
    /// The options of a tool and of all tools; those said stroke by stroke have no meaning in it.
    sculpt::StrokeSettings choice(const sculpt::ToolRow& row) const;
    /// A tool's own to change: from now on the person's.
    sculpt::StrokeSettings& edit(const sculpt::ToolRow& row);
    void remember(const std::string& file);
};

/// What a stroke of `row` with a brush of `radius` (model units) does; `flip` inverts once more (Ctrl held).
sculpt::StrokeSettings strokeSettings(const Settings& settings, const sculpt::ToolRow& row, float radius, bool flip);

/// How the model looks, whichever it is: what these settings say of a picture; the grid's place follows from the model.
render::RenderOptions lookOf(const Settings& settings);

Settings readSettings(const QSettings& store);

/// As they are stored: keys and values, defaults of tools and options left out. How they get into a file, beside what
/// other windows have put there: settings_file.h.
using Entries = QMap<QString, QVariant>;
Entries entriesOf(const Settings& settings);

} // namespace ui
