// How the picture looks, and the frames asked of the viewport: the settings, what a shading has measured, the grid on
// the ground. Interface's thread only.
#pragma once

#include "core/render/effects/ground_grid.h"
#include "ui/settings/settings.h"
#include "ui/work/editor.h"
#include "ui/work/frame.h"

class QWidget;

namespace ui {

class PictureLook {
  public:
    /// `canvas` has the picture's pixels; all outlive it.
    PictureLook(const Editor& editor, const Settings& settings, const QWidget& canvas);

    /// What a shading that measures shows from now on, and what its colours mean; null: nothing. True where the
    /// picture becomes another one.
    bool showColours(std::shared_ptr<const render::BlockColours> colours,
                     const std::optional<render::ColourScale>& scale);
    const std::optional<render::ColourScale>& scale() const { return m_scale; }
    /// Lays the grid below the model as it is now, where it then stays.
    void placeGrid();

    /// What pictures show: the model as it is now, or what would become of it.
    const Snapshot& shown() const { return m_instead ? *m_instead : m_editor.snapshot(); }
    bool showsInstead() const { return m_instead.has_value(); }
    /// From now on this in place of the model, in its own shading where it has one; nothing: the model again.
    void showInstead(std::optional<Snapshot> instead, std::optional<render::Shading> shading = {}) {
        m_instead = std::move(instead);
        m_insteadShading = shading;
    }
    /// That pictures have: the settings', or that of what is shown instead.
    render::Shading shading() const { return m_insteadShading.value_or(m_settings.shading); }

    /// All that the settings and the model say of the picture's look; without colours.
    render::RenderOptions options() const;
    /// The model as it is now. `moving` and `input` as in Frame; `input` counts where the model's own is older.
    Frame frame(const render::Camera& camera, bool moving, std::uint64_t input) const;

  private:
    std::optional<TrueSurface> truth() const; ///< where the settings ask for it

    const Editor& m_editor;
    const Settings& m_settings;
    const QWidget& m_canvas;
    std::shared_ptr<const render::BlockColours> m_colours;
    std::optional<render::ColourScale> m_scale;
    render::GroundGrid m_grid;
    std::optional<Snapshot> m_instead;
    std::optional<render::Shading> m_insteadShading;
};

} // namespace ui
