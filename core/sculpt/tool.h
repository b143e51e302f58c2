// A tool is one row of a table (tool_table.cpp): its name, its parameters, and a function from a version and a dab to
// an edit. It asks the interface nothing, and nothing outside the table knows it by name.
//
//     Stroke --ray--> contact --Dab--> ToolRow::apply(version, dab) --Edit--> SurfelTree::apply --> next version
#pragma once

#include "core/base/mat3.h"
#include "core/sculpt/falloff.h"
#include "core/surface/surface.h"

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace layers {
struct Stack;
}

namespace sculpt {

class BrushStamp;
class Connected;

/// A dab that a stroke has done, as later dabs of the stroke remember it.
struct PastDab {
    base::Vec3f centre;
    float radius, strength;
};

/// What a tool remembers from dab to dab of a stroke, for speed: its results follow from the dabs so far.
struct ToolMemory {
    virtual ~ToolMemory() = default;
};

/// One application of a tool at an exact contact. Lengths in model units; directions of unit length.
struct Dab {
    base::Vec3f centre;       ///< on the surface of the version that the stroke works on
    base::Vec3f normal;       ///< unit gradient there, facing the viewer
    base::Vec3f areaNormal;   ///< mean of the surfels' normals in the stroke's area of the normal, facing the viewer
    base::Vec3f areaCentre;   ///< mean of the surfels' positions in the stroke's area of the plane
    base::Vec3f view;         ///< direction of the ray
    base::Vec3f move;         ///< from here to the place of the next dab (Motion::Drag); zero otherwise
    base::Vec3f travel;       ///< from the dab before to this one; zero for a stroke's first
    float angle = 0;          ///< by how much the pointer turned about the contact (Motion::Turn), about areaNormal
    base::Vec3f anchor;       ///< the stroke's first contact, of the same image as this dab
    base::Vec3f anchorNormal; ///< the area normal there
    base::Mat3f image = base::Mat3f::identity();   ///< what symmetry did to directions
    const surface::Surface* first = nullptr;       ///< the version that the stroke began on; null: the present one
    std::span<const PastDab> past;                 ///< the stroke's dabs so far, all images, oldest first
    const layers::Stack* layers = nullptr;         ///< of the model; null: it has none
    std::unique_ptr<ToolMemory>* memory = nullptr; ///< the stroke's, empty at first; null: nothing is remembered
    float radius = 0;
    float strength = 0;      ///< 0 to 1, pressure and symmetry included; negative when inverted
    bool footprints = false; ///< supports follow the stretch: where no resampling ties them to the target spacing
    Falloff falloff = Falloff::Smooth;
    std::shared_ptr<const BrushCurve> curve; ///< of Falloff::Custom
    // What brush_factors.h multiplies by, for every tool alike.
    bool oriented = true;                       ///< normals have meaningful signs
    bool frontFacing = false;                   ///< only what faces the viewer
    std::shared_ptr<const Connected> connected; ///< only these surfels of the version; null: all
    std::shared_ptr<const BrushStamp> stamp;    ///< null: none
    int stampLevel = 0;
    base::Vec3f stampRight, stampUp;          ///< its axes, at right angles to areaNormal
    std::map<std::string, double> parameters; ///< the tool's own, complete with defaults
    float parameter(const char* id) const { return static_cast<float>(parameters.at(id)); }
};

/// What a tool's memory is, made of `args` by the first dab; kept in `once` where the dab belongs to no stroke.
template <class Memory, class... Args>
Memory& memoryOf(const Dab& dab, std::unique_ptr<ToolMemory>& once, Args&&... args) {
    std::unique_ptr<ToolMemory>& memory = dab.memory ? *dab.memory : once;
    if (!memory)
        memory = std::make_unique<Memory>(std::forward<Args>(args)...);
    return static_cast<Memory&>(*memory);
}

/// What a parameter's number stands for, and so how it is chosen.
enum class ParameterKind {
    Number,
    Colour, ///< 65536 red + 256 green + blue
    SourceX,
    SourceY,
    SourceZ ///< of the place to copy from, chosen on the model: setSource
};

/// A parameter of a tool as panels, command line and manual show it.
struct ToolParameter {
    const char* id;
    const char* label;
    const char* unit; ///< "" for a plain number
    const char* tip;
    double fallback, min, max;
    ParameterKind kind = ParameterKind::Number;
    bool chosenOnModel() const { return kind >= ParameterKind::SourceX; }
};

/// How dabs follow the pointer.
enum class Motion {
    Along,  ///< a dab at every contact along the stroke, spaced by a part of the radius
    Follow, ///< the same for tools that carry along dab.travel: closer dabs carry less far, not less strongly
    Drag,   ///< the first contact is held and carried in the plane that faces the viewer
    Turn    ///< the first contact is held; the pointer turns about it, seen along the first ray
};

/// What a tool may change.
enum class Writes {
    Shape,   ///< positions, normals and supports, by a formula in space
    Surface, ///< the same, by what the surface is: neighbours have a say
    Mask,
    Colour,
    Count ///< surfels go or come, and what they leave is evened out
};

/// What a tool asks of a stroke beside contacts.
struct ToolNeeds {
    bool source = false; ///< a place to copy from
    bool plane = false;  ///< Dab::areaCentre
    bool layer = false;  ///< one that strokes act on
};

struct ToolRow {
    const char* id;       ///< as sessions name it: "draw"
    const char* label;    ///< "Draw"
    const char* icon;     ///< icons/tool-draw.svg
    const char* shortcut; ///< several: "X; V"
    const char* tip;      ///< one sentence
    Motion motion;
    double strength; ///< where nobody sets another
    std::span<const ToolParameter> parameters;
    /// What the dab does to the surfels: positions and normals changed by its formula (told in the tool's header).
    /// Blocks in which nothing moves do not appear; what does not move keeps its bits. In parallel, deterministic.
    tree::Edit (*apply)(const surface::Surface& version, const Dab& dab);
    Writes writes = Writes::Shape;
    ToolNeeds needs = {};
    /// At the end of a stroke, what its dabs have left to be done, a slice at a time; an empty edit: nothing is left.
    /// Null where dabs leave nothing. `memory`: what they have made.
    tree::Edit (*rest)(const surface::Surface& version, ToolMemory& memory) = nullptr;
};

/// Surfels move, and none comes or goes.
inline bool movesSurfaces(const ToolRow& tool) {
    return tool.writes == Writes::Shape || tool.writes == Writes::Surface;
}

std::span<const ToolRow> toolTable();
/// Throws base::Error naming the known tools.
const ToolRow& tool(std::string_view id);

} // namespace sculpt
