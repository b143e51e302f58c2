// Of feeling the model: which device, how the clay is, whether it is sculpted. A plain value; touch_bar.h edits it,
// touch_input.h does it.
#pragma once

#include <string>

namespace ui {

struct TouchSettings {
    bool on = false;
    std::string device = "hand"; ///< id of a row of haptics::deviceTable()
    bool sculpts = false;        ///< pressing makes the chosen tool work; else the model is only felt
    double stiffness = 800;      ///< newtons per metre
    double friction = 0.2;
    double relief = 0, grain = 0; ///< texture, of relief and of colour (haptics/texture.h)
    double viscosity = 2;         ///< newton seconds per metre, while the tool works
    double tip = 0.25;            ///< radius of the ball, in radii of the brush
    double reach = 20;            ///< centimetres of the hand that the picture is high
    bool viewDevice = false;      ///< a 3D mouse turns the view meanwhile
    bool operator==(const TouchSettings&) const = default;
};

} // namespace ui
