// What rays truly hit of a creased model, and what they hit of surfaces that stand for it.
#pragma once

#include "core/cells/any_surface.h"
#include "reduce/creased_models.h"

namespace creased {

struct Truth {
    std::vector<base::Rayf> rays;
    std::vector<double> t;       ///< below zero: nothing is there
    std::vector<double> spacing; ///< where it hits
};

/// Rays to places around the samples, most of them beside creases.
inline Truth truthOf(const Model& model, const surfel::SurfelList& list, const Spacing& spacing, std::size_t count,
                     base::Random& random) {
    Truth out;
    const auto layout = *cells::LabelLayout::of(*list.layout);
    std::vector<std::size_t> beside;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (layout.at(list.extraOf(i)).meeting != cells::Meeting::None)
            beside.push_back(i);
    while (out.rays.size() < count) {
        const bool edge = out.rays.size() % 4 != 0 && !beside.empty();
        const Vec3d p = base::cast<double>(
            list.items[edge ? beside[random.below(beside.size())] : random.below(list.size())].position);
        const Vec3d target = p + random.unitVector() * random.uniform(0, 2 * spacing(p)), d = random.unitVector();
        const base::Rayf ray{base::cast<float>(target - d * 4), base::cast<float>(d)};
        const base::Rayd exact{base::cast<double>(ray.origin), base::normalized(base::cast<double>(ray.direction))};
        std::size_t face = 0;
        const double t = model.hit(exact, 8, 0.004, face);
        if (t > 0 && std::abs(dot(model.faces[face].normal(exact.at(t)), exact.direction)) < 0.15)
            continue;
        out.rays.push_back(ray), out.t.push_back(t);
        out.spacing.push_back(spacing(t > 0 ? exact.at(t) : p));
    }
    return out;
}

struct Judged {
    std::size_t lost = 0, early = 0, off = 0; ///< behind or before the truth by a spacing; by a part of one
    double rms = 0;                           ///< of the others, in spacings
    std::size_t wrong() const { return lost + early + off; }
};

/// Rays that hit the model. `tolerance` in spacings.
inline Judged judged(const surface::Surface& surface, const Truth& truth, double tolerance) {
    std::vector<surface::RayHit<float>> hits(truth.rays.size());
    cells::intersect(cells::AnySurface(surface), truth.rays, {}, hits);
    Judged out;
    double sum = 0;
    std::size_t counted = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (truth.t[i] < 0)
            continue;
        const double off = hits[i].hit ? (static_cast<double>(hits[i].t) - truth.t[i]) / truth.spacing[i] : 1e9;
        if (std::abs(off) > 1) {
            ++(off > 0 ? out.lost : out.early);
            continue;
        }
        out.off += std::abs(off) > tolerance ? 1 : 0;
        sum += off * off, ++counted;
    }
    out.rms = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, counted)));
    return out;
}

} // namespace creased
