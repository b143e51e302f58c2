#include "app/force_picture.h"

#include "core/render/overlay/annotation_canvas.h"
#include "core/render/shading/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

using base::Vec3f;

namespace {

constexpr int width = 1000, height = 500;
constexpr float left = 90, right = 970, top = 40, bottom = 430, bar = 462;
constexpr Vec3f ink{0.1f, 0.1f, 0.12f}, pale{0.8f, 0.8f, 0.82f};
constexpr std::array<Vec3f, 3> axes{Vec3f{0.8f, 0.2f, 0.15f}, {0.15f, 0.55f, 0.15f}, {0.15f, 0.3f, 0.8f}};

double sizeOf(const FeltForce& each) {
    return length(each.force);
}

class Plot {
  public:
    explicit Plot(const std::vector<FeltForce>& felt) : m_felt(felt) {
        m_time.low = static_cast<float>(felt.front().seconds);
        m_time.high = static_cast<float>(felt.back().seconds);
        if (!(m_time.high > m_time.low))
            m_time.high = m_time.low + 1;
        m_force.low = m_force.high = 0;
        for (const FeltForce& each : felt) {
            m_force.high = std::max(m_force.high, static_cast<float>(sizeOf(each)));
            for (std::size_t k = 0; k < 3; ++k)
                m_force.low = std::min(m_force.low, static_cast<float>(each.force[k]));
        }
        if (!(m_force.high > m_force.low))
            m_force.high = m_force.low + 1;
    }

    void draw(render::Image& out) {
        m_image = &out;
        frame();
        for (std::size_t k = 0; k < 3; ++k)
            curve([k](const FeltForce& each) { return each.force[k]; }, axes[k], 1.2f);
        curve(sizeOf, ink, 2);
        contacts();
        const char* names[] = {"x", "y", "z"};
        for (std::size_t k = 0; k < 3; ++k)
            m_texts.push_back({{right - 20 * static_cast<float>(3 - k), top - 14}, 0, 10, names[k], axes[k]});
        m_texts.push_back({{left, top - 14}, 0, 10, "Force, most " + render::numberLabel(m_force.high), ink});
        m_texts.push_back({{right, bar + 26}, 1, 10, "s", ink});
        render::paint({{}, std::move(m_texts), {}}, out);
    }

  private:
    float across(double seconds) const {
        return left + (right - left) * (static_cast<float>(seconds) - m_time.low) / (m_time.high - m_time.low);
    }
    float up(double force) const {
        return bottom - (bottom - top) * (static_cast<float>(force) - m_force.low) / (m_force.high - m_force.low);
    }

    void frame() {
        std::vector<render::PenLine> grid;
        for (const double force : render::ticks(m_force)) {
            grid.push_back({{left, up(force)}, {right, up(force)}});
            m_texts.push_back({{left - 8, up(force) + 4}, 1, 9, render::numberLabel(force), ink});
        }
        for (const double seconds : render::ticks(m_time)) {
            grid.push_back({{across(seconds), top}, {across(seconds), bottom}});
            m_texts.push_back({{across(seconds), bottom + 18}, 0.5f, 9, render::numberLabel(seconds), ink});
        }
        rule(grid, pale, 1);
        rule(std::vector<render::PenLine>{{{left, up(0)}, {right, up(0)}}}, ink, 1);
    }

    /// What stays within half a pixel needs no line of its own.
    template <class Of>
    void curve(const Of& of, const Vec3f& colour, float thick) {
        std::vector<render::PenLine> lines;
        render::ImagePoint last{across(m_felt.front().seconds), up(of(m_felt.front()))};
        for (const FeltForce& each : m_felt) {
            const render::ImagePoint next{across(each.seconds), up(of(each))};
            if (std::abs(next.x - last.x) < 0.5f && std::abs(next.y - last.y) < 0.5f)
                continue;
            lines.push_back({last, next});
            last = next;
        }
        rule(lines, colour, thick);
    }

    void contacts() {
        std::vector<render::PenLine> lines;
        for (std::size_t i = 0; i < m_felt.size();) {
            std::size_t end = i;
            while (end < m_felt.size() && m_felt[end].contact == m_felt[i].contact)
                ++end;
            if (m_felt[i].contact)
                lines.push_back({{across(m_felt[i].seconds), bar}, {across(m_felt[end - 1].seconds), bar}});
            i = end;
        }
        rule(lines, ink, 4);
        m_texts.push_back({{left - 8, bar + 4}, 1, 9, "contact", ink});
    }

    void rule(const std::vector<render::PenLine>& lines, const Vec3f& colour, float thick) {
        render::draw(
            lines, 0.5f * thick + 1,
            [&](surfel::Colour under, float away) {
                return render::inked(under, colour, render::covered(thick, away));
            },
            *m_image);
    }

    const std::vector<FeltForce>& m_felt;
    render::ColourScale m_time, m_force;
    std::vector<render::DrawnText> m_texts;
    render::Image* m_image = nullptr;
};

} // namespace

render::Image forcePicture(const std::vector<FeltForce>& felt) {
    render::Image out;
    out.resize(width, height);
    out.colour.assign(out.colour.size(), surfel::white);
    if (!felt.empty())
        Plot(felt).draw(out);
    return out;
}

} // namespace app
