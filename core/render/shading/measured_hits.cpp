#include "core/render/shading/measured_hits.h"

#include "core/render/shading/selected_colours.h"

namespace render {

/// Pixels asked for together, in squares: neighbours in the list are neighbours in space.
constexpr int squareSide = 128;

static surfel::Colour shownAs(const Measured& measured, surfel::Colour own, float value) {
    if (measured.over == Measured::Over::Nothing)
        return measured.scale.of(value);
    return underSelection(measured.over == Measured::Over::Own ? own : surfel::white, value);
}

void colourHits(const Measured& measured, int width, std::span<raycast::Sample> samples,
                std::span<const raycast::Sample> before, const base::Progress& progress) {
    const int height = width > 0 ? static_cast<int>(samples.size() / static_cast<std::size_t>(width)) : 0;
    std::vector<std::size_t> pixels;
    std::vector<base::Vec3f> x;
    std::vector<float> values;
    const auto ask = [&](int left, int top) {
        pixels.clear(), x.clear();
        for (int row = top; row < std::min(top + squareSide, height); ++row)
            for (int column = left; column < std::min(left + squareSide, width); ++column) {
                const auto i =
                    static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
                raycast::Sample& sample = samples[i];
                if (!sample.hit.hit)
                    continue;
                if (!before.empty() && before[i].hit.hit && before[i].hit.position == sample.hit.position) {
                    sample.colour = before[i].colour;
                    continue;
                }
                pixels.push_back(i);
                x.push_back(sample.hit.position);
            }
        values.resize(x.size());
        process::quantityAt(measured.question, x, values);
        for (std::size_t k = 0; k < pixels.size(); ++k)
            samples[pixels[k]].colour = shownAs(measured, samples[pixels[k]].colour, values[k]);
    };
    for (int top = 0; top < height; top += squareSide)
        for (int left = 0; left < width; left += squareSide) {
            progress.step(static_cast<double>(top) / height, "Measuring the surface");
            ask(left, top);
        }
}

} // namespace render
