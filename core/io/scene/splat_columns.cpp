#include "core/io/scene/splat_columns.h"

#include "core/process/estimation/keep_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace io {

static const Field* find(const std::vector<Field>& fields, std::string_view name) {
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
    return found == fields.end() ? nullptr : &*found;
}

bool areSplats(const std::vector<Field>& fields) {
    for (const char* name :
         {"f_dc_0", "f_dc_1", "f_dc_2", "opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"})
        if (!find(fields, name))
            return false;
    return !find(fields, "red");
}

static double opacityOf(double logit) {
    return 1 / (1 + std::exp(-logit));
}

void colourSplats(RecordTable& table) {
    constexpr double harmonic = 0.28209479177387814; // Y00 = 1 / (2 sqrt(pi))
    std::vector<Field> made;
    for (std::size_t k = 0; k < 4; ++k) {
        const Field source =
            *find(table.fields, std::array<const char*, 4>{"f_dc_0", "f_dc_1", "f_dc_2", "opacity"}[k]);
        Field out{std::array<const char*, 4>{"red", "green", "blue", "alpha"}[k], ScalarType::Float64,
                  ScalarType::UInt8, 0};
        out.made = [&table, source, k](std::size_t i) {
            const double value = valueOf(table, source, i), share = k == 3 ? opacityOf(value) : 0.5 + harmonic * value;
            return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) * 255 : 0;
        };
        made.push_back(std::move(out));
    }
    std::erase_if(table.fields, [](const Field& field) {
        return field.name.starts_with("f_dc_") || field.name.starts_with("f_rest_") || field.name == "nx" ||
               field.name == "ny" || field.name == "nz";
    });
    table.fields.insert(table.fields.end(), made.begin(), made.end());
}

std::size_t dropTransparent(FileModel& model) {
    constexpr double least = 0.1; // below it splats are haze, not surface
    const surfel::Attribute* opacity = model.points.layout->find("opacity");
    if (!opacity)
        return 0;
    std::vector<bool> keep(model.points.size());
    for (std::size_t i = 0; i < keep.size(); ++i)
        keep[i] = opacityOf(surfel::read(*opacity, model.points.extraOf(i))) >= least;
    const std::size_t before = keep.size();
    if (std::find(keep.begin(), keep.end(), true) == keep.end())
        return before;
    std::vector<std::uint32_t> numbers(before, std::numeric_limits<std::uint32_t>::max());
    std::uint32_t kept = 0;
    process::keepPoints(model.points, [&](std::size_t i) {
        if (keep[i])
            numbers[i] = kept++;
        return keep[i];
    });
    model.polygons.renumber(numbers);
    return before - model.points.size();
}

} // namespace io
