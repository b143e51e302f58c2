// Numbers as colours: maps that keep their order for colour-blind eyes and in print, made by code.
//
//     Diverging   blue - light grey - red, for signed numbers: Moreland, Diverging Color Maps for Scientific
//                 Visualization (2009), equal steps in Msh; grey means zero
//     Sequential  dark blue - green - yellow: even steps of lightness in OKLCH (Ottosson 2020)
//     Chosen      light grey - orange, for what is chosen among the rest
#pragma once

#include "core/surfel/surfel.h"

#include <string>
#include <vector>

namespace render {

enum class ColourMap { Diverging, Sequential, Chosen };

/// The map's colour at t, 0 to 1; beyond it the end's, for NaN `unknownColour`.
surfel::Colour mapped(ColourMap map, float t);
/// Where there is no number: a grey darker than that of zero.
constexpr surfel::Colour unknownColour = surfel::rgba(104, 104, 108);

/// What numbers a map spans.
struct ColourScale {
    ColourMap map = ColourMap::Diverging;
    float low = -1, high = 1; ///< low < high
    std::string title;        ///< "Mean curvature (1/length)"

    surfel::Colour of(float value) const { return mapped(map, (value - low) / (high - low)); }
    bool operator==(const ColourScale&) const = default;
};

/// Round numbers within the scale, 1, 2 or 5 times a power of ten apart, at least three where it is not tiny.
std::vector<double> ticks(const ColourScale& scale);
/// As short as it is exact to four digits: "0.05", "1.2e-06".
std::string numberLabel(double value);

} // namespace render
