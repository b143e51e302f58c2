#include "core/surfel/shape.h"

#include "core/base/error.h"

#include <bit>

namespace surfel {

int shapeChannel(const AttributeLayout& layout) {
    const std::vector<Attribute>& all = layout.attributes();
    for (std::size_t i = 0; i + 2 < all.size(); ++i) {
        bool found = true;
        for (std::size_t k = 0; k < 3 && found; ++k)
            found = all[i + k].type == ScalarType::Float32 && all[i + k].name == shapeNames[k];
        if (found)
            return Extra + static_cast<int>(all[i].firstWord);
    }
    return 0;
}

void addShape(AttributeLayout& layout) {
    if (shapeChannel(layout) > 0)
        return;
    for (const char* name : shapeNames)
        if (layout.find(name))
            throw base::Error("the attribute " + std::string(name) + " is no part of a shape", "supports",
                              "rename or remove that attribute");
    for (const char* name : shapeNames)
        layout.add(name, ScalarType::Float32);
}

SurfelList withoutShape(const SurfelList& list) {
    const int channel = shapeChannel(*list.layout);
    if (channel == 0)
        return list;
    auto layout = std::make_shared<AttributeLayout>();
    layout->normals = list.layout->normals, layout->oriented = list.layout->oriented;
    layout->colours = list.layout->colours, layout->masks = list.layout->masks;
    const std::size_t first = shapeWord(*list.layout);
    for (const Attribute& each : list.layout->attributes())
        if (each.firstWord < first || each.firstWord >= first + 3)
            layout->add(each.name, each.type);
    SurfelList out;
    out.items = list.items;
    out.extra.reserve(list.size() * layout->words());
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto words = list.extraOf(i);
        out.extra.insert(out.extra.end(), words.begin(), words.begin() + static_cast<std::ptrdiff_t>(first));
        out.extra.insert(out.extra.end(), words.begin() + static_cast<std::ptrdiff_t>(first + 3), words.end());
    }
    out.layout = std::move(layout);
    return out;
}

base::Vec3f shapeIn(std::span<const std::uint32_t> words, std::size_t first) {
    base::Vec3f out;
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = std::bit_cast<float>(words[first + k]);
    return out;
}

void putShape(std::span<std::uint32_t> words, std::size_t first, const base::Vec3f& b) {
    for (std::size_t k = 0; k < 3; ++k)
        words[first + k] = std::bit_cast<std::uint32_t>(b[k]);
}

base::Vec3f soundShape(const base::Vec3f& b, const base::Vec3f& n) {
    if (!(std::isfinite(b.x) && std::isfinite(b.y) && std::isfinite(b.z)))
        return {};
    constexpr float rounding = 1e-5f; // what is sound keeps its bits
    const float known = lengthSq(n), beside = dot(b, n);
    const bool across = !(known > 0) || std::abs(beside) <= rounding * std::sqrt(known * lengthSq(b));
    const base::Vec3f along = across ? b : b - n * (beside / known);
    const float length = base::length(along);
    return length > (1 + rounding) * longestShape ? along * (longestShape / length) : along;
}

Ellipse deformed(const Ellipse& support, const base::Vec3f& n, const base::Mat3d& jacobian, const base::Vec3f& turned) {
    using base::Vec3d;
    const Vec3d normal = normalized(base::cast<double>(n)), across = normalized(base::cast<double>(turned));
    const Vec3d b = base::cast<double>(support.shape);
    const double size = double(support.radius), ratio = std::sqrt(1 + lengthSq(b));
    const Vec3d beside = b - normal * dot(b, normal);
    const Vec3d shortWay = lengthSq(beside) > 0 ? normalized(beside) : perpendicular(normal);
    const Vec3d u = cross(normal, shortWay) * size, v = shortWay * (size / ratio);
    const auto moved = [&](const Vec3d& a) {
        const Vec3d out = jacobian * a;
        return out - across * dot(out, across);
    };
    // the 2x2 matrix with the columns Ju and Jv in a basis of the new tangent plane; its singular values are the axes
    const Vec3d s = perpendicular(across), t = cross(across, s), mu = moved(u), mv = moved(v);
    const double xx = dot(s, mu) * dot(s, mu) + dot(s, mv) * dot(s, mv);
    const double yy = dot(t, mu) * dot(t, mu) + dot(t, mv) * dot(t, mv);
    const double xy = dot(s, mu) * dot(t, mu) + dot(s, mv) * dot(t, mv);
    const double mean = (xx + yy) / 2, off = std::hypot((xx - yy) / 2, xy);
    const double large = std::sqrt(mean + off);
    if (!(large > 0) || !std::isfinite(large))
        return support;
    const double small = std::max(std::sqrt(std::max(mean - off, 0.0)), large / double(mostAspect));
    const double stretch = large / small, length = std::sqrt(std::max(stretch * stretch - 1, 0.0));
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy); // of the long axis
    const Vec3d thin = t * std::cos(angle) - s * std::sin(angle);
    constexpr double round = 1e-3; // what rounding makes of a ball
    return {static_cast<float>(large), length > round ? base::cast<float>(thin * length) : base::Vec3f{}};
}

void becomeBall(const AttributeLayout& layout, Surfel& s, std::span<std::uint32_t> words) {
    if (shapeChannel(layout) == 0)
        return;
    s.support *= meanAxis(shapeIn(words, shapeWord(layout)));
    putShape(words, shapeWord(layout), {});
}

} // namespace surfel
