// Samples of primitives: rows of rings about the axis, and of rectangles (solid/README 3).
#include "core/base/error.h"
#include "core/cells/crease_labels.h"
#include "core/process/resampling/resample.h"
#include "core/solid/hexagonal.h"
#include "core/solid/primitive.h"

#include <numbers>

namespace solid {

using base::Vec3d;
using std::numbers::pi;

namespace {

constexpr std::size_t mostSurfels = 20'000'000;

/// A piece of a profile in the half-plane of (r, z), as a function of the way along it.
struct Profile {
    double length = 0;
    std::function<std::array<double, 4>(double way)> at; ///< r, z and the normal in r and z
};

Profile line(double r0, double z0, double r1, double z1, double nr, double nz) {
    const double way = std::hypot(r1 - r0, z1 - z0);
    return {way, [=](double t) { return std::array{r0 + (r1 - r0) * t / way, z0 + (z1 - z0) * t / way, nr, nz}; }};
}

/// About (r, z), from one angle to another; 0 points away from the axis.
Profile arc(double r, double z, double radius, double from, double to) {
    return {radius * (to - from), [=](double t) {
                const double angle = from + t / radius;
                return std::array{r + radius * std::cos(angle), z + radius * std::sin(angle), std::cos(angle),
                                  std::sin(angle)};
            }};
}

class Sampler {
  public:
    Sampler(double spacing, const surface::SurfaceDefinition& definition)
        : m_spacing(spacing), m_support(process::supportOf(definition, static_cast<float>(spacing))) {
        auto layout = std::make_shared<surfel::AttributeLayout>();
        layout->normals = layout->oriented = true;
        m_out.layout = layout;
    }

    void revolve(const Profile& profile, std::uint32_t cell) {
        const auto rows = static_cast<int>(std::max(1.0, std::round(profile.length / (rowStep * m_spacing))));
        for (int row = 0; row < rows; ++row) {
            const auto [r, z, nr, nz] = profile.at(profile.length * (row + 0.5) / rows);
            const auto count = static_cast<int>(std::max(3.0, std::round(2 * pi * r / (alongStep * m_spacing))));
            for (int k = 0; k < count; ++k) {
                const double angle = 2 * pi * (k + 0.618 * m_rows) / count;
                add({r * std::cos(angle), r * std::sin(angle), z}, {nr * std::cos(angle), nr * std::sin(angle), nz},
                    cell);
            }
            ++m_rows;
        }
    }
    /// u and v from the middle to the middles of two sides.
    void rectangle(const Vec3d& middle, const Vec3d& u, const Vec3d& v, std::uint32_t cell) {
        const auto steps = [&](const Vec3d& half, double step) {
            return static_cast<int>(std::max(1.0, std::round(2 * length(half) / (step * m_spacing))));
        };
        const int rows = steps(v, rowStep), count = steps(u, alongStep);
        const Vec3d normal = normalized(cross(u, v));
        for (int row = 0; row < rows; ++row)
            for (int k = 0; k < count; ++k)
                add(middle + u * (2 * (k + 0.25 + 0.5 * (row & 1)) / count - 1) + v * (2 * (row + 0.5) / rows - 1),
                    normal, cell);
    }
    void crease(const Vec3d& from, const Vec3d& to, std::uint32_t left, std::uint32_t right) {
        m_creases.push_back({from, to, left, right, cells::Meeting::Convex});
    }
    void rim(double r, double z, std::uint32_t left, std::uint32_t right) {
        const auto count = static_cast<int>(std::max(12.0, std::ceil(2 * pi * r / m_spacing)));
        const auto at = [&](int k) {
            const double angle = 2 * pi * k / count;
            return Vec3d{r * std::cos(angle), r * std::sin(angle), z};
        };
        for (int k = 0; k < count; ++k)
            crease(at(k), at(k + 1), left, right);
    }
    surfel::SurfelList result() {
        if (!m_creases.empty()) {
            const std::vector<cells::Label> labels = cells::labelsByCreases(m_out.items, m_cells, m_creases, m_spacing);
            cells::setLabels(m_out, labels);
        }
        return std::move(m_out);
    }

  private:
    void add(const Vec3d& p, const Vec3d& n, std::uint32_t cell) {
        if (m_cells.size() >= mostSurfels)
            throw base::Error("a shape of that size with points so close would have more than 20 million of them", "",
                              "choose a larger spacing or a smaller size");
        surfel::Surfel s;
        s.position = base::cast<float>(p);
        s.normal = base::cast<float>(normalized(n));
        s.support = m_support;
        m_out.append(s, {});
        m_cells.push_back(cell);
    }

    double m_spacing;
    float m_support;
    int m_rows = 0;
    surfel::SurfelList m_out;
    std::vector<std::uint32_t> m_cells;
    std::vector<cells::CreasePiece> m_creases;
};

void sampleBox(Sampler& sampler, const Size& size) {
    const auto faceOf = [](std::size_t axis, int sign) { return static_cast<std::uint32_t>(2 * axis + (sign > 0)); };
    const auto along = [&](std::size_t axis, double part) {
        Vec3d out;
        out[axis] = 0.5 * part * size[axis];
        return out;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
        for (const int sign : {-1, 1}) {
            sampler.rectangle(along(axis, sign), along(j, sign), along(k, 1), faceOf(axis, sign));
            for (const int other : {-1, 1}) // edges along k
                sampler.crease(along(axis, sign) + along(j, other) + along(k, -1),
                               along(axis, sign) + along(j, other) + along(k, 1), faceOf(axis, sign), faceOf(j, other));
        }
    }
}

} // namespace

surfel::SurfelList surfelsOf(const PrimitiveRow& row, const Size& size, double spacing,
                             const surface::SurfaceDefinition& definition) {
    Sampler sampler(spacing, definition);
    const std::string_view id = row.id;
    const double half = 0.5 * size[1];
    if (id == "ball") {
        sampler.revolve(arc(0, 0, size[0], -pi / 2, pi / 2), 0);
    } else if (id == "torus") {
        sampler.revolve(arc(size[0], 0, size[1], -pi, pi), 0);
    } else if (id == "box") {
        sampleBox(sampler, size);
    } else if (id == "cylinder") {
        sampler.revolve(line(0, -half, size[0], -half, 0, -1), 0);
        sampler.revolve(line(size[0], -half, size[0], half, 1, 0), 1);
        sampler.revolve(line(size[0], half, 0, half, 0, 1), 2);
        sampler.rim(size[0], -half, 0, 1);
        sampler.rim(size[0], half, 1, 2);
    } else if (id == "cone") {
        const double slant = std::hypot(size[0], size[1]);
        sampler.revolve(line(0, -half, size[0], -half, 0, -1), 0);
        sampler.revolve(line(size[0], -half, 0, half, size[1] / slant, size[0] / slant), 1);
        sampler.rim(size[0], -half, 0, 1);
    } else {
        sampler.revolve(arc(0, -half, size[0], -pi / 2, 0), 0);
        if (half > 0)
            sampler.revolve(line(size[0], -half, size[0], half, 1, 0), 0);
        sampler.revolve(arc(0, half, size[0], 0, pi / 2), 0);
    }
    return sampler.result();
}

} // namespace solid
