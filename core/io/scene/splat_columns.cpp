#include "core/io/scene/splat_columns.h"

#include "core/process/estimation/keep_points.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

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

namespace {

/// The numbers of a splat's covariance among its further words.
class Covariance {
  public:
    explicit Covariance(const surfel::AttributeLayout& layout) {
        for (std::size_t k = 0; k < 3; ++k)
            m_scale[k] = layout.find("scale_" + std::to_string(k));
        for (std::size_t k = 0; k < 4; ++k)
            m_turn[k] = layout.find("rot_" + std::to_string(k));
    }
    /// Axes by descending length, each as long as the standard deviation along it; none where they are no numbers.
    std::optional<std::array<base::Vec3d, 3>> axes(std::span<const std::uint32_t> words) const {
        std::array<double, 4> q; // w x y z
        double length = 0;
        for (std::size_t k = 0; k < 4; ++k)
            q[k] = surfel::read(*m_turn[k], words), length += q[k] * q[k];
        std::array<base::Vec3d, 3> out = turned(q, 2 / length);
        for (std::size_t k = 0; k < 3; ++k) {
            out[k] = out[k] * std::exp(surfel::read(*m_scale[k], words));
            if (const double square = lengthSq(out[k]); !std::isfinite(square) || !(square > 0))
                return {};
        }
        std::stable_sort(out.begin(), out.end(),
                         [](const base::Vec3d& a, const base::Vec3d& b) { return lengthSq(a) > lengthSq(b); });
        return out;
    }

  private:
    /// Columns of the rotation by a quaternion; `twice`: 2 over its squared length.
    static std::array<base::Vec3d, 3> turned(const std::array<double, 4>& q, double twice) {
        const auto [w, x, y, z] = q;
        return {{{1 - twice * (y * y + z * z), twice * (x * y + w * z), twice * (x * z - w * y)},
                 {twice * (x * y - w * z), 1 - twice * (x * x + z * z), twice * (y * z + w * x)},
                 {twice * (x * z + w * y), twice * (y * z - w * x), 1 - twice * (x * x + y * y)}}};
    }
    std::array<const surfel::Attribute*, 3> m_scale{};
    std::array<const surfel::Attribute*, 4> m_turn{};
};

/// The same points with room for shapes: balls.
void addShapes(surfel::SurfelList& points) {
    auto layout = std::make_shared<surfel::AttributeLayout>(*points.layout);
    surfel::addShape(*layout);
    layout->normals = true, layout->oriented = false;
    std::vector<std::uint32_t> extra(points.size() * layout->words());
    for (std::size_t i = 0; i < points.size(); ++i)
        std::ranges::copy(points.extraOf(i), extra.begin() + static_cast<std::ptrdiff_t>(i * layout->words()));
    points.extra = std::move(extra);
    points.layout = std::move(layout);
}

} // namespace

void shapeSplats(FileModel& model) {
    constexpr double thin = 2; // middle axis over the least: below it the least one is no normal
    surfel::SurfelList& points = model.points;
    if (model.hasSupports || surfel::shapeChannel(*points.layout) > 0)
        return; // it has its own
    addShapes(points);
    const Covariance covariance(*points.layout);
    const std::size_t first = surfel::shapeWord(*points.layout), words = points.layout->words();
    for (std::size_t i = 0; i < points.size(); ++i) {
        points.items[i].normal = {};
        const auto axes = covariance.axes(points.extraOf(i));
        if (!axes)
            continue;
        const auto& [longest, middle, least] = *axes;
        if (length(middle) >= thin * length(least))
            points.items[i].normal = base::cast<float>(normalized(least));
        const double aspect = std::min(length(longest) / length(middle), double(surfel::mostAspect));
        surfel::putShape(std::span(points.extra).subspan(i * words, words), first,
                         base::cast<float>(normalized(middle) * std::sqrt(aspect * aspect - 1)));
    }
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
