#include "core/session/measured_model.h"

#include "core/base/error.h"
#include "core/process/measuring/measured_attribute.h"
#include "core/render/shading/shading_table.h"

#include <sstream>

namespace session {

using tree::SurfelTree;

static std::vector<float> floatsOf(const std::vector<double>& values) {
    return {values.begin(), values.end()};
}

static render::ColourScale scaleOf(const MeasuredModel& measured, const std::vector<float>& values, float diagonal) {
    static const render::MeasureRow thickness{process::Quantity::Spacing, "Thickness (length)", false, 0.99f, 1e-5f, 1};
    const render::MeasureRow row =
        measured.colours == "thickness" ? thickness : *render::shadingRow(render::shading("deviation")).measure;
    if (measured.range)
        return render::fixedScale(row, static_cast<float>(measured.range->first),
                                  static_cast<float>(measured.range->second));
    std::vector<float> known;
    for (const float v : values)
        if (!std::isnan(v))
            known.push_back(v);
    return render::automaticScale(row, std::move(known), diagonal);
}

surface::Surface withMeasured(const surface::Surface& surface, const MeasuredModel& measured) {
    SurfelTree tree = surface.tree();
    std::vector<float> colouring;
    const auto take = [&](const char* name, const std::vector<double>& numbers) {
        const std::vector<float> values = floatsOf(numbers);
        tree = process::withAttribute(tree, name, values);
        if (measured.colours == name)
            colouring = values;
    };
    if (measured.deviation)
        take("deviation", measured.deviation->distance);
    if (measured.thickness)
        take("thickness", measured.thickness->at);
    if (!measured.colours.empty()) {
        if (colouring.empty())
            throw base::Error("colours by \"" + measured.colours + "\", which was not measured", {},
                              "measure it in the same step");
        const render::ColourScale scale = scaleOf(measured, colouring, surface.tree().bounds().diagonal());
        std::vector<surfel::Colour> colours;
        for (const float v : colouring)
            colours.push_back(scale.of(v));
        tree = process::withColours(tree, colours);
    }
    return {tree, surface.definition()};
}

std::string sentenceOf(const process::DeviationFigures& d) {
    std::ostringstream out;
    out.precision(7);
    out << d.count << " surfels, rms " << d.rms << ", mean " << d.mean << ", 99 % within " << d.p99 << ", max " << d.max
        << (d.sided ? "" : "; without sign, the other surface has no sides");
    return out.str();
}

std::string sentenceOf(const process::ThicknessFigures& t) {
    std::ostringstream out;
    out.precision(7);
    if (t.count == 0)
        return "none: nothing lies opposite to any surfel";
    out << t.count << " surfels, min " << t.min << ", 1 % below " << t.p1 << ", median " << t.median << ", mean "
        << t.mean << ", max " << t.max;
    if (t.none > 0)
        out << "; " << t.none << " have nothing opposite";
    return out.str();
}

} // namespace session
