// What the window remembers between two runs: a plain value with defaults, compared with ==, read from and written to
// QSettings. Nothing here changes a model; a stroke takes what it needs with strokeSettings().
//
// Reading is forgiving: what is missing, unknown or out of range keeps its default, so that a settings file of another
// version never stops the program.
#pragma once

#include "core/sculpt/stroke.h"
#include "ui/render/renderer.h"

#include <QByteArray>
#include <string>
#include <vector>

class QSettings;

namespace ui {

enum class RadiusUnit {
    Pixels, ///< the brush keeps its size on the screen
    Model   ///< the brush keeps its size on the model
};

/// What a person has set for one tool; absent entries are the table's defaults.
struct ToolChoice {
    double strength = 0.5;
    std::map<std::string, double> parameters;
    bool operator==(const ToolChoice&) const = default;
};

struct Settings {
    std::string tool;                 ///< id of the chosen tool; empty: the table's first
    std::string shiftTool = "smooth"; ///< the tool while Shift is held
    RadiusUnit radiusUnit = RadiusUnit::Pixels;
    double radiusPx = 50;
    double radiusModel = 0.1;
    sculpt::Falloff falloff = sculpt::Falloff::Smooth;
    double spacing = 0.1; ///< of dabs, as a part of the radius
    sculpt::Symmetry symmetry;
    bool invert = false;
    bool resample = true;
    std::map<std::string, ToolChoice> tools;
    render::Shading shading = render::Shading::Matcap;
    std::vector<std::string> recentFiles; ///< newest first, at most `recentLimit`
    QByteArray geometry, windowState;     ///< as QMainWindow saves them

    static constexpr std::size_t recentLimit = 10;
    static constexpr double minRadiusPx = 2, maxRadiusPx = 500, minSpacing = 0.01, maxSpacing = 1;
    bool operator==(const Settings&) const = default;

    const sculpt::ToolRow& toolRow() const;
    /// The person's choice for a tool, complete with the table's defaults.
    ToolChoice choice(const sculpt::ToolRow& row) const;
    void remember(const std::string& file);
};

/// What a stroke of `row` with a brush of `radius` (model units) does; `flip` inverts once more (Ctrl held).
sculpt::StrokeSettings strokeSettings(const Settings& settings, const sculpt::ToolRow& row, float radius, bool flip);

Settings readSettings(const QSettings& store);
void writeSettings(const Settings& settings, QSettings& store);

} // namespace ui
