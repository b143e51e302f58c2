#include "core/render/overlay/annotations.h"

#include "core/render/overlay/stroke_font.h"

#include <algorithm>
#include <cmath>

namespace render {

using base::Vec3d;

std::span<const AnnotationRow> annotationTable() {
    static constexpr AnnotationRow rows[] = {
        {Legend, "legend", "Colour Legend", "Which colour means which value, for shadings that measure"},
        {ScaleBar, "scale-bar", "Scale Bar", "A length in model units, true at the depth that the view turns about"},
        {Axes, "axes", "Axes", "Where the coordinate axes point: x red, y green, z blue"},
    };
    return rows;
}

namespace {

struct Layout {
    Drawing& out;
    float width, height; ///< of the image
    float unit;          ///< pixels for one that a person sees
    base::Vec3f ink;

    float margin() const { return 18 * unit; }
    float letters() const { return 9 * unit; }
    void line(ImagePoint a, ImagePoint b, float thick) const { out.lines.push_back({a, b, thick * unit, ink}); }
    void text(ImagePoint at, float anchor, const std::string& words) const {
        out.texts.push_back({at, anchor, letters(), words, ink});
    }
};

/// Round numbers and both ends, without what would touch an end's letters.
std::vector<double> labelled(const ColourScale& scale, double lettersOfHeight) {
    const double low = scale.low, high = scale.high, near = 1.8 * lettersOfHeight * (high - low);
    std::vector<double> out{low};
    for (const double tick : ticks(scale))
        if (tick - low > near && high - tick > near)
            out.push_back(tick);
    out.push_back(high);
    return out;
}

void addLegend(const Layout& layout, const ColourScale& scale) {
    const float tall = std::max(40.0f, 0.42f * layout.height), wide = 14 * layout.unit, gap = 6 * layout.unit;
    const std::vector<double> numbers = labelled(scale, static_cast<double>(layout.letters() / tall));
    float longest = 0;
    for (const double number : numbers)
        longest = std::max(longest, textWidth(numberLabel(number), layout.letters()));
    const float right = layout.width - layout.margin(), left = right - longest - gap - wide;
    const float top = 0.5f * (layout.height - tall);
    layout.out.ramps.push_back({{left, top}, wide, tall, scale.map});
    for (const double number : numbers) {
        const double part = (number - static_cast<double>(scale.low)) / static_cast<double>(scale.high - scale.low);
        const float y = top + tall * static_cast<float>(1 - part);
        layout.line({left + wide - 3 * layout.unit, y}, {left + wide, y}, 1.2f);
        layout.text({left + wide + gap, y + 0.5f * layout.letters()}, 0, numberLabel(number));
    }
    layout.text({right, top - 14 * layout.unit}, 1, scale.title);
}

/// 1, 2 or 5 times a power of ten, at most `most`.
double roundBelow(double most) {
    const double power = std::pow(10, std::floor(std::log10(most))), factor = most / power;
    return power * (factor >= 5 ? 5 : factor >= 2 ? 2 : 1);
}

void addScaleBar(const Layout& layout, const Camera& camera, float left) {
    const double depth = dot(camera.target - camera.eye, camera.forward());
    const double perUnit = camera.pixelsPerUnit(std::max(depth, 1e-300));
    const double length = roundBelow(0.22 * static_cast<double>(layout.width) / perUnit);
    const float y = layout.height - layout.margin(), right = left + static_cast<float>(length * perUnit);
    const float tick = 4 * layout.unit;
    layout.line({left, y}, {right, y}, 1.8f);
    layout.line({left, y - tick}, {left, y + tick}, 1.4f);
    layout.line({right, y - tick}, {right, y + tick}, 1.4f);
    layout.text({0.5f * (left + right), y - 8 * layout.unit}, 0.5f, numberLabel(length));
}

constexpr float axisLength = 30;

void addAxes(const Layout& layout, const Camera& camera) {
    const float around = layout.margin() + (axisLength + 8) * layout.unit;
    const ImagePoint middle{around, layout.height - around};
    struct Axis {
        Vec3d direction;
        const char* name;
        base::Vec3f colour;
    };
    Axis axes[] = {{{1, 0, 0}, "X", {0.86f, 0.29f, 0.27f}},
                   {{0, 1, 0}, "Y", {0.36f, 0.68f, 0.28f}},
                   {{0, 0, 1}, "Z", {0.31f, 0.52f, 0.92f}}};
    const Vec3d right = camera.right(), up = camera.upright(), forward = camera.forward();
    std::sort(std::begin(axes), std::end(axes), // the one that points towards the eye is drawn last
              [&](const Axis& a, const Axis& b) { return dot(a.direction, forward) > dot(b.direction, forward); });
    for (const Axis& axis : axes) {
        const auto at = [&](double length) {
            return ImagePoint{middle.x + static_cast<float>(length * dot(axis.direction, right)) * layout.unit,
                              middle.y - static_cast<float>(length * dot(axis.direction, up)) * layout.unit};
        };
        layout.out.lines.push_back({middle, at(axisLength), 2.2f * layout.unit, axis.colour});
        const ImagePoint name = at(axisLength + 9);
        layout.out.texts.push_back(
            {{name.x, name.y + 0.5f * layout.letters()}, 0.5f, layout.letters(), axis.name, axis.colour});
    }
}

} // namespace

Drawing annotate(Annotated wanted, const Camera& camera, const std::optional<ColourScale>& scale, Backdrop backdrop,
                 float pixelScale) {
    Drawing out;
    // In small pictures letters shrink too, down to what can still be read.
    const auto height = static_cast<float>(camera.height);
    const float unit = pixelScale * std::clamp(height / (600 * pixelScale), 0.6f, 1.0f);
    const Layout layout{out, static_cast<float>(camera.width), height, unit, backdropRow(backdrop).ink};
    if (wanted & Axes)
        addAxes(layout, camera);
    if (wanted & ScaleBar)
        addScaleBar(layout, camera, layout.margin() + (wanted & Axes ? (2 * axisLength + 34) * unit : 0));
    if (scale && (wanted & Legend))
        addLegend(layout, *scale);
    return out;
}

} // namespace render
