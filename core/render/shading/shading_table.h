// The ways to colour a surface: one table, over which menus, command line, help and tests loop. What a row says is all
// that renderers know about it (shading.h has the formula).
#pragma once

#include "core/process/scalar_field.h"
#include "core/render/shading/colour_map.h"
#include "core/surfel/surfel.h"

#include <optional>
#include <span>
#include <string_view>

namespace render {

/// In the order of the table.
enum class Shading {
    Matcap,
    Wax,
    Porcelain,
    Bronze,
    Jade,
    Zebra,
    Studio,
    Normal,
    Colour,
    Unlit,
    Mask,
    Curvature,
    CurvatureGaussian,
    CurvatureK1,
    CurvatureK2,
    OffCentre,
    Spacing,
    Deviation,
    Selection,
    Attribute
};

/// How the numbers of a row become colours.
struct MeasureRow {
    process::Quantity quantity;
    const char* title; ///< of the legend, with the unit
    bool isSigned;     ///< symmetric about zero and diverging; else from the least to the greatest
    /// Part of the values that an automatic range spans: a few wild ones must not make all others look alike.
    float share;
    /// Smallest range worth showing, below which all is one colour: least * diagonal^power.
    float least;
    int power;
    /// Of Attribute: the name; empty: which one is asked for beside the shading.
    const char* attribute = "";
    bool chosen = false; ///< values from 0 to 1 that choose: the scale is just that

    bool named() const { return quantity == process::Quantity::Attribute && *attribute == '\0'; }
    /// `asked`: the attribute that is asked for beside the shading.
    process::FieldQuestion question(surface::Surface surface, surface::Surface reference,
                                    const std::string& asked) const {
        return {quantity, std::move(surface), std::move(reference), named() ? asked : attribute};
    }
};

struct ShadingRow {
    Shading shading;
    const char* id; ///< "matcap"
    const char* label;
    const char* tip;
    const char* group; ///< rows of a group stand together, the menu draws a line between groups
    /// Light of the ball (light_ball.h), sRGB.
    base::Vec3f (*light)(const base::Vec3f& normal);
    base::Vec3f maskTint, backTint; ///< see ShadingStyle
    bool surfelColours;             ///< the surfels' own
    std::optional<MeasureRow> measure;

    bool usesColour() const { return surfelColours || measure; }
};
std::span<const ShadingRow> shadingTable();
const ShadingRow& shadingRow(Shading shading);
/// Throws base::Error naming the known shadings.
Shading shading(std::string_view id);

/// The scale that fits values (process::sampleField) of a model with this diagonal: the share of them that the row
/// says, ends rounded outwards to two digits.
ColourScale automaticScale(const MeasureRow& row, std::vector<float> values, float diagonal);
/// Of a range that was asked for. Throws base::Error unless low < high.
ColourScale fixedScale(const MeasureRow& row, float low, float high);

} // namespace render
