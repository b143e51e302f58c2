#include "core/complexes/complex_rays.h"

#include "core/base/parallel.h"
#include "core/complexes/foot_on_cell.h"

#include <algorithm>

namespace complexes {

using base::Rayd, base::Rayf, base::Vec3d;

namespace {

using Interval = std::pair<double, double>;

/// Where on the ray the patch may be, ascending and apart. Patches without points of their own: anywhere in their box.
std::vector<Interval> intervalsOf(const Cell& patch, const Rayd& ray, double from, double to) {
    auto [enter, leave] = base::clip(ray, patch.bounds);
    enter = std::max(enter, from);
    leave = std::min(leave, to);
    std::vector<Interval> all;
    if (!(enter <= leave))
        return all;
    if (patch.own.tree().empty())
        return {{enter, leave}};
    const Rayf near{base::cast<float>(ray.at(enter)), base::cast<float>(ray.direction)}; // no digits lost far away
    patch.own.tree().alongRay(near, [&](const surfel::SurfelBlock& block, int cluster, float t0, float t1) {
        const double slack = 1e-3 * static_cast<double>(block.bounds(cluster).maxSupport);
        all.emplace_back(std::max(enter, enter + static_cast<double>(t0) - slack),
                         std::min(leave, enter + static_cast<double>(t1) + slack));
        return true;
    });
    std::sort(all.begin(), all.end());
    std::vector<Interval> out;
    for (const Interval& each : all)
        if (out.empty() || each.first > out.back().second)
            out.push_back(each);
        else
            out.back().second = std::max(out.back().second, each.second);
    return out;
}

/// One ray and one patch.
class PatchRay {
  public:
    PatchRay(const Complex& complex, std::uint32_t patch, const Rayd& ray)
        : m_complex(complex), m_patch(patch), m_ray(ray) {}

    template <class Wanted>
    void addHits(const Interval& interval, Wanted& out) {
        Sample before;
        const double slack = 1e-9 * (interval.second - interval.first);
        for (double t = interval.first;;) {
            if (before.t > out.until()) // not now.t: what lies between has the bits that it has without an end
                return;
            const Sample now = at(t, before.axis);
            if (before.usable && now.usable && before.f != 0 && before.f * now.f <= 0)
                addRoot(before, now, out);
            if (t >= interval.second)
                return;
            const double unit = now.usable ? now.unit : m_unit;
            const double step = now.usable ? std::max(0.5 * std::abs(now.f), unit / 28) : unit / 14;
            t = std::min(interval.second, t + std::max({step, slack, 1e-12 * t}));
            before = now;
        }
    }
    void setLeastUnit(double unit) { m_unit = unit; }

  private:
    struct Sample {
        double t = -std::numeric_limits<double>::infinity(), f = 0, unit = 0;
        Vec3d axis;
        bool usable = false;
    };

    Sample at(double t, const Vec3d& side) {
        const Vec3d x = m_ray.at(t);
        const CellFrame frame = frameOf(m_complex, m_patch, x, side);
        ++m_evaluations;
        if (!frame.ok())
            return {t, 0, m_unit, {}, false};
        m_unit = frame.unit;
        return {t, dot(frame.axis, x - frame.centre), frame.unit, frame.axis, true};
    }

    /// Between two places with different signs: the Illinois way of regula falsi.
    template <class Wanted>
    void addRoot(Sample a, Sample b, Wanted& out) {
        const double tolerance = 1e-13 * std::max(a.unit, std::abs(b.t));
        Sample root = b;
        int kept = 0;
        for (int i = 0; i < 80 && std::abs(b.t - a.t) > tolerance && root.f != 0; ++i) {
            const double share = a.f / (a.f - b.f);
            root = at(a.t + (b.t - a.t) * std::clamp(share, 0.01, 0.99), b.axis);
            if (!root.usable)
                return;
            if ((root.f > 0) == (b.f > 0)) {
                b = root;
                if (kept == 1)
                    a.f *= 0.5;
                kept = 1;
            } else {
                a = root;
                if (kept == 2)
                    b.f *= 0.5;
                kept = 2;
            }
            if (std::abs(root.f) < 1e-14 * root.unit)
                break;
        }
        accept(root, out);
    }

    template <class Wanted>
    void accept(const Sample& root, Wanted& out) {
        const Vec3d x = m_ray.at(root.t);
        const CellFrame frame = frameOf(m_complex, m_patch, x, root.axis);
        if (!frame.ok() || std::abs(dot(frame.axis, x - frame.centre)) > 1e-6 * frame.unit || frame.offCentre(x))
            return; // the frame jumped, or tells of other places
        if (isPast(m_complex, m_patch, x, frame))
            return;
        const Vec3d gradient = gradientOf(m_complex, m_patch, x, frame);
        if (!(dot(gradient, frame.axis) >= surface::minSlope))
            return;
        ComplexHit out1;
        out1.cell = m_patch;
        out1.hit.hit = true;
        out1.hit.t = root.t;
        out1.hit.position = x;
        out1.hit.outward = normalized(gradient);
        out1.hit.normal = dot(out1.hit.outward, m_ray.direction) > 0 ? -out1.hit.outward : out1.hit.outward;
        out1.hit.unit = frame.unit;
        out1.hit.agreement = frame.agreement;
        out1.hit.evaluations = m_evaluations;
        m_evaluations = 0;
        out.add(out1);
    }

    const Complex& m_complex;
    std::uint32_t m_patch;
    const Rayd& m_ray;
    double m_unit = 0; ///< of the last place that had one
    int m_evaluations = 0;
};

double leastUnit(const Complex& complex, std::uint32_t patch) {
    const Cell& cell = complex[patch];
    if (!cell.own.tree().empty())
        return static_cast<double>(surface::unitOf(complex.weight(), cell.own.tree().maxSupport()));
    double out = std::numeric_limits<double>::infinity();
    for (const std::uint32_t b : cell.boundary)
        out = std::min(out, static_cast<double>(surface::unitOf(complex.weight(), complex[b].own.tree().maxSupport())));
    return out;
}

// What is wanted of the hits of all patches; none is looked for beyond `until`.

bool isBefore(const ComplexHit& a, const ComplexHit& b) {
    return a.hit.t != b.hit.t ? a.hit.t < b.hit.t : a.cell < b.cell;
}

struct AllHits {
    std::vector<ComplexHit> hits;

    void add(const ComplexHit& hit) { hits.push_back(hit); }
    double until() const { return std::numeric_limits<double>::infinity(); }
};

struct FirstHit {
    ComplexHit best;

    void add(const ComplexHit& hit) {
        if (!best.hit.hit || isBefore(hit, best))
            best = hit;
    }
    double until() const { return best.hit.hit ? best.hit.t : std::numeric_limits<double>::infinity(); }
};

/// Not those that the ray begins on.
struct AnyHit {
    double from = 0;
    bool found = false;

    void add(const ComplexHit& hit) {
        found |= hit.hit.t - from > surface::secondaryEpsilon * hit.hit.unit * surface::spacingOfUnit;
    }
    double until() const { return (found ? -1 : 1) * std::numeric_limits<double>::infinity(); }
};

/// Patches in the order in which the ray may meet them: the first hit ends the others early.
template <class Wanted>
void addHits(const Complex& complex, const Rayd& ray, const surface::IntersectOptions& options, Wanted& out) {
    struct Candidate {
        std::uint32_t patch;
        std::vector<Interval> where;
    };
    std::vector<Candidate> candidates;
    for (std::uint32_t patch = 0; patch < complex.cells().size(); ++patch) {
        if (complex[patch].dimension != 2)
            continue;
        std::vector<Interval> where =
            intervalsOf(complex[patch], ray, static_cast<double>(options.tMin), static_cast<double>(options.tMax));
        if (!where.empty())
            candidates.push_back({patch, std::move(where)});
    }
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.where.front().first < b.where.front().first;
    });
    for (const Candidate& each : candidates) {
        PatchRay along(complex, each.patch, ray);
        along.setLeastUnit(leastUnit(complex, each.patch));
        for (const Interval& interval : each.where)
            if (!(interval.first > out.until()))
                along.addHits(interval, out);
    }
}

Rayd widened(const Rayf& ray) {
    return {base::cast<double>(ray.origin), normalized(base::cast<double>(ray.direction))};
}

constexpr std::size_t raysAtOnce = 16;

} // namespace

std::vector<ComplexHit> intersectAll(const Complex& complex, const Rayd& ray,
                                     const surface::IntersectOptions& options) {
    AllHits out;
    addHits(complex, ray, options, out);
    std::sort(out.hits.begin(), out.hits.end(), isBefore);
    return std::move(out.hits);
}

surface::RayHit<double> intersectReference(const Complex& complex, const Rayd& ray,
                                           const surface::IntersectOptions& options) {
    FirstHit out;
    addHits(complex, ray, options, out);
    return out.best.hit;
}

std::vector<surface::RayHit<double>> intersectAllReference(const Complex& complex, const Rayd& ray,
                                                           const surface::IntersectOptions& options) {
    std::vector<surface::RayHit<double>> out;
    for (const ComplexHit& each : intersectAll(complex, ray, options)) {
        // an edge, which two patches share, is met once
        const double same = surface::secondaryEpsilon * each.hit.unit * surface::spacingOfUnit;
        if (out.empty() || each.hit.t - out.back().t > same)
            out.push_back(each.hit);
    }
    return out;
}

bool intersectAnyReference(const Complex& complex, const Rayd& ray, const surface::IntersectOptions& options) {
    AnyHit out;
    out.from = static_cast<double>(options.tMin);
    addHits(complex, ray, options, out);
    return out.found;
}

void intersect(const Complex& complex, std::span<const Rayf> rays, const surface::IntersectOptions& options,
               std::span<surface::RayHit<float>> out) {
    base::parallelFor(rays.size(), raysAtOnce,
                      [&](std::size_t i) { out[i] = rounded(intersectReference(complex, widened(rays[i]), options)); });
}

void intersectAll(const Complex& complex, std::span<const Rayf> rays, const surface::IntersectOptions& options,
                  std::span<std::vector<surface::RayHit<float>>> out) {
    base::parallelFor(rays.size(), raysAtOnce, [&](std::size_t i) {
        out[i].clear();
        for (const surface::RayHit<double>& hit : intersectAllReference(complex, widened(rays[i]), options))
            out[i].push_back(rounded(hit));
    });
}

void intersectAny(const Complex& complex, std::span<const Rayf> rays, const surface::IntersectOptions& options,
                  std::span<std::uint8_t> out) {
    base::parallelFor(rays.size(), raysAtOnce, [&](std::size_t i) {
        out[i] = intersectAnyReference(complex, widened(rays[i]), options) ? 1 : 0;
    });
}

} // namespace complexes
