#include "core/render/shading/shading_table.h"

#include "core/base/error.h"
#include "core/base/ranked.h"
#include "core/base/row_of_id.h"
#include "core/render/shading/light_ball.h"

#include <algorithm>
#include <cmath>

namespace render {

using base::Vec3f;
using process::Quantity;

static const Vec3f clayMask{0.5f, 0.47f, 0.46f}, clayBack{0.58f, 0.5f, 0.46f}, plainMask{0.55f, 0.53f, 0.53f},
    plainBack{0.62f, 0.6f, 0.6f}, white{1, 1, 1};

std::span<const ShadingRow> shadingTable() {
    constexpr const char *materials = "Materials", *own = "The surfels' own", *measured = "Measured",
                         *carried = "Carried";
    static const ShadingRow rows[] = {
        {Shading::Matcap,
         "matcap",
         "Clay",
         "Neutral clay in studio light; protected places are darker",
         materials,
         clayLight,
         clayMask,
         clayBack,
         false,
         {}},
        {Shading::Wax,
         "wax",
         "Red Wax",
         "Sculptor's wax: deep shadows and a soft gloss show the form of details",
         materials,
         waxLight,
         clayMask,
         clayBack,
         false,
         {}},
        {Shading::Porcelain,
         "porcelain",
         "Porcelain",
         "White and glossy: highlights show the smallest dents",
         materials,
         porcelainLight,
         clayMask,
         {0.6f, 0.56f, 0.54f},
         false,
         {}},
        {Shading::Bronze,
         "bronze",
         "Bronze",
         "Polished metal: reflections show how the surface bends",
         materials,
         bronzeLight,
         clayMask,
         clayBack,
         false,
         {}},
        {Shading::Jade,
         "jade",
         "Jade",
         "Light shines through: shows large forms rather than small ones",
         materials,
         jadeLight,
         clayMask,
         clayBack,
         false,
         {}},
        {Shading::Zebra,
         "zebra",
         "Zebra",
         "Stripes of equal slope: they break where the surface has an edge and kink "
         "where its curvature jumps",
         materials,
         zebraLight,
         plainMask,
         plainBack,
         false,
         {}},
        {Shading::Studio,
         "studio",
         "Studio",
         "Grey in three white lights, the plainest look",
         materials,
         studioLight,
         clayMask,
         clayBack,
         false,
         {}},
        {Shading::Normal,
         "normal",
         "Normals",
         "Direction of the normals as seen from the eye",
         own,
         normalColour,
         white,
         {0.7f, 0.7f, 0.7f},
         false,
         {}},
        {Shading::Colour,
         "colour",
         "Colour",
         "Colours of the surfels in plain light",
         own,
         plainLight,
         plainMask,
         plainBack,
         true,
         {}},
        {Shading::Unlit,
         "unlit",
         "Colour, Unlit",
         "Colours of the surfels as they are, without any light",
         own,
         noLight,
         plainMask,
         {1, 1, 1},
         true,
         {}},
        {Shading::Mask,
         "mask",
         "Mask",
         "Parts protected from tools, in blue",
         own,
         clayLight,
         {0.24f, 0.38f, 0.62f},
         clayBack,
         false,
         {}},
        {Shading::Curvature, "curvature", "Mean Curvature", "Red where the surface bulges, blue where it is hollow",
         measured, measureLight, plainMask, plainBack, false,
         MeasureRow{Quantity::MeanCurvature, "Mean curvature (1/length)", true, 0.95f, 0.1f, -1}},
        {Shading::CurvatureGaussian, "curvature-gauss", "Gaussian Curvature",
         "Red on bumps and in bowls, blue on saddles, grey where the surface could be unrolled", measured, measureLight,
         plainMask, plainBack, false,
         MeasureRow{Quantity::GaussianCurvature, "Gaussian curvature (1/length^2)", true, 0.95f, 0.1f, -2}},
        {Shading::CurvatureK1, "curvature-k1", "Largest Curvature k1",
         "Curvature across ridges: red along all that stands out", measured, measureLight, plainMask, plainBack, false,
         MeasureRow{Quantity::LargestCurvature, "Largest curvature k1 (1/length)", true, 0.95f, 0.1f, -1}},
        {Shading::CurvatureK2, "curvature-k2", "Smallest Curvature k2",
         "Curvature across valleys: blue along grooves and folds", measured, measureLight, plainMask, plainBack, false,
         MeasureRow{Quantity::SmallestCurvature, "Smallest curvature k2 (1/length)", true, 0.95f, 0.1f, -1}},
        {Shading::OffCentre, "off-centre", "Off-Centre Value",
         "How far the points' centroid lies from the surface, in supports: large at rims and where samples are uneven",
         measured, measureLight, plainMask, plainBack, false,
         MeasureRow{Quantity::OffCentre, "Off-centre value (supports)", false, 0.98f, 0.01f, 0}},
        {Shading::Spacing, "spacing", "Spacing", "Distance between neighbouring surfels", measured, measureLight,
         plainMask, plainBack, false, MeasureRow{Quantity::Spacing, "Spacing (length)", false, 0.98f, 1e-6f, 1}},
        {Shading::Deviation, "deviation", "Deviation",
         "Distance from the model as it was opened or last saved: red where it was raised, blue where it was lowered",
         measured, measureLight, plainMask, plainBack, false,
         MeasureRow{Quantity::Deviation, "Deviation (length)", true, 0.995f, 1e-5f, 1}},
        {Shading::Selection, "selection", "Selection", "What is selected, in orange", carried, measureLight, plainMask,
         plainBack, false, MeasureRow{Quantity::Attribute, "Selected", false, 1, 1, 0, "selection", true}},
        {Shading::Attribute, "attribute", "Attribute",
         "A number that the surfels carry by name: intensity, classification, thickness, ...", carried, measureLight,
         plainMask, plainBack, false, MeasureRow{Quantity::Attribute, "", false, 0.98f, 1e-30f, 0}},
    };
    return rows;
}

const ShadingRow& shadingRow(Shading shading) {
    return shadingTable()[static_cast<std::size_t>(shading)];
}

Shading shading(std::string_view id) {
    return base::rowOf(shadingTable(), id, {"unknown shading '%'", "", "use one of: %"}).shading;
}

/// To two digits, away from zero or, for `direction` < 0, downwards.
static float rounded(double value, int direction) {
    if (value == 0)
        return 0;
    const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 1), count = value / unit;
    return static_cast<float>((direction < 0 ? std::floor(count + 1e-4) : std::ceil(count - 1e-4)) * unit);
}

ColourScale automaticScale(const MeasureRow& row, std::vector<float> values, float diagonal) {
    if (row.chosen)
        return {ColourMap::Chosen, 0, 1, row.title};
    const double least = static_cast<double>(row.least) * std::pow(static_cast<double>(diagonal), row.power);
    ColourScale out{row.isSigned ? ColourMap::Diverging : ColourMap::Sequential, 0, 0, row.title};
    if (row.isSigned) {
        for (float& value : values)
            value = std::abs(value);
        const double end =
            values.empty() ? 0.0 : static_cast<double>(base::quantile(values, static_cast<double>(row.share)));
        out.high = rounded(std::max({end, least, 1e-30}), 1);
        out.low = -out.high;
        return out;
    }
    const double tail = 0.5 * (1 - static_cast<double>(row.share));
    out.low = values.empty() ? 0.0f : rounded(static_cast<double>(base::quantile(values, tail)), -1);
    const double high = values.empty() ? 0.0 : static_cast<double>(base::quantile(values, 1 - tail));
    out.high = rounded(std::max({high, static_cast<double>(out.low) + least, 1e-30}), 1);
    if (!(out.high > out.low))
        out.high = std::nextafter(out.low, std::numeric_limits<float>::infinity());
    return out;
}

ColourScale fixedScale(const MeasureRow& row, float low, float high) {
    if (!(low < high))
        throw base::Error("the range of colours is empty", "", "give the lower number first, as in --range -0.5,0.5");
    return {row.chosen     ? ColourMap::Chosen
            : row.isSigned ? ColourMap::Diverging
                           : ColourMap::Sequential,
            low, high, row.title};
}

} // namespace render
