// What a stroke does, apart from where it goes: a plain value that sessions record. Defaults are the plain brush;
// names, ranges and texts of the fields are in stroke_options.h, one row each.
#pragma once

#include "core/base/up_axis.h"
#include "core/sculpt/tool.h"

namespace sculpt {

enum class Axis { X, Y, Z };

struct AxisRow {
    Axis value;
    const char* id; ///< as sessions name it: "x"
    const char* label;
};
std::span<const AxisRow> axisTable();
const AxisRow& row(Axis axis);
/// Throws base::Error naming the axes.
Axis axis(std::string_view id);

struct UpAxisRow {
    base::UpAxis value;
    const char* id; ///< as sessions name it: "-z"
    const char* label;
};
std::span<const UpAxisRow> upAxisTable();
const UpAxisRow& row(base::UpAxis axis);
/// Throws base::Error naming the axes.
base::UpAxis upAxis(std::string_view id);

/// Planes x = 0, y = 0, z = 0 of the file's coordinates.
struct MirrorPlanes {
    bool x = false, y = false, z = false;
    bool operator==(const MirrorPlanes&) const = default;
};

/// Images of a stroke: mirrored at coordinate planes, then turned about an axis through the origin.
struct Symmetry {
    MirrorPlanes planes;
    int copies = 1; ///< this many in all, evenly about the axis; 1 to 64
    Axis axis = Axis::Z;
    bool operator==(const Symmetry&) const = default;
};

/// How samples become dabs. Tools that hold what they touched first (Motion::Drag, Motion::Turn) have
/// their own way and take no notice of it.
enum class StrokeMethod {
    Space,    ///< evenly along the surface
    Dots,     ///< one at every sample
    Airbrush, ///< evenly in time, also where the pointer rests
    Anchored, ///< one, at the first contact; its radius reaches the pointer and its stamp turns with it
    Line      ///< evenly along the straight line from the first to the last sample
};

struct MethodRow {
    StrokeMethod value;
    const char* id; ///< as sessions name it: "space"
    const char* label;
    const char* tip;
    bool lastOnly; ///< the result depends on the first and the last sample alone
};
std::span<const MethodRow> methodTable();
const MethodRow& row(StrokeMethod method);
/// Throws base::Error naming the known methods.
StrokeMethod method(std::string_view id);

struct StrokeSettings {
    std::string tool = "draw";
    float radius = 0;      ///< model units; REQUIRES > 0
    float strength = 0.5f; ///< 0 to 1
    bool invert = false;
    Falloff falloff = Falloff::Smooth;
    CurvePoints falloffCurve{{0, 1}, {1, 0}}; ///< of Falloff::Custom: weight over distance in radii
    Symmetry symmetry;
    bool resample = true;                     ///< let the sampling follow the deformation
    bool graded = false;                      ///< makes all that is touched even, by the supports at each place
    float spacing = 0.1f;                     ///< distance of dabs as a part of the radius
    std::map<std::string, double> parameters; ///< the tool's own; missing ones take their defaults

    StrokeMethod method = StrokeMethod::Space;
    float rate = 20;      ///< dabs a second of Airbrush, 1 to 500
    float stabiliser = 0; ///< length of the rope on which the brush follows the pointer, in radii; 0: none
    CurvePoints pressureStrength{{0, 0}, {1, 1}}; ///< strength over pressure; tools that hold take no notice
    CurvePoints pressureRadius{{0, 1},
                               {1, 1}}; ///< radius over pressure, as a part of it; tools that hold take no notice

    /// Off: dabs work on the surface that the stroke began on, and where they overlap the one that goes farthest
    /// counts, so that they do not pile up. Tools that hold take no notice.
    bool accumulate = true;
    float autoSmooth = 0;                          ///< strength of the smooth tool after every dab, 0 to 1
    bool frontFacing = false;                      ///< leaves alone what faces away from the viewer
    bool connected = false;                        ///< works only on what can be walked to from the contact
    float normalRadius = 0.5f, planeRadius = 0.5f; ///< areas of Dab::areaNormal and areaCentre, in radii, 0 to 2
    std::string stamp;         ///< the image that the brush presses in, as the session names it; empty: none
    float stampAngleRad = 0;   ///< turns it to the left
    bool stampFollows = false; ///< its upper edge leads along the stroke; else it stands upright as seen
    base::UpAxis stampUpright = base::UpAxis::Y; ///< the model's axis that is upright then

    /// A stroke that stays in its place, and a stamp that is anchored, are as strong there as a stroke that goes over
    /// it.
    bool fullTap = false;
    /// Sharpness of the edge that tools which draw lines leave along the stroke, 0 to 1; 0: none.
    float edge = 0;
    float snap = 0;         ///< in radii: the stroke keeps to seams and corners that are so near; 0: to none
    bool fadeEdges = false; ///< smoothing takes the sharpness of edges that it goes over

    bool operator==(const StrokeSettings&) const = default;
};

/// The first contact is held and goes with the pointer; methods and spacing have no say.
inline bool holds(const ToolRow& tool) {
    return tool.motion == Motion::Drag || tool.motion == Motion::Turn;
}

/// The result depends on the first and the last sample alone.
bool lastOnly(const StrokeSettings& settings);

/// Dabs closer than this (in radii) share the strength that they would have at this distance.
constexpr float usualSpacing = 0.1f;

/// Throws base::Error for settings out of range, before anything is touched.
void check(const StrokeSettings& settings);

} // namespace sculpt
