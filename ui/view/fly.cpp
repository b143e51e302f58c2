#include "ui/view/fly.h"

#include "ui/view/navigation.h"

namespace ui {

using base::Vec3d;

Fly::Fly(const View& view, double speed) : m_view(view.upright()), m_speed(speed) {
    m_view.parallel = false;
    m_view.pick({});
}

void Fly::accelerate(double steps) {
    m_speed *= std::pow(1.25, steps);
}

/// The scene goes against the pointer: the pointer is where the eye looks.
void Fly::look(double dx, double dy, int height) {
    constexpr double haste = 2.5;
    navigation("fly").drag(m_view, {0, 0}, {-dx * haste, -dy * haste}, 1, height);
}

Vec3d Fly::wanted() const {
    const auto axis = [&](Key more, Key less) { return double((m_keys & more) != 0) - double((m_keys & less) != 0); };
    const Vec3d way =
        m_view.turn({axis(Right, Left), 0, axis(Back, Forward)}) + upRow(m_view.upAxis).up * axis(Up, Down);
    constexpr double fast = 4;
    return base::normalized(way) * (m_speed * (m_keys & Fast ? fast : 1));
}

void Fly::step(double seconds) {
    const Vec3d goal = wanted(), lag = m_velocity - goal;
    const double left = std::exp(-seconds / tau);
    m_view.target += goal * seconds + lag * (tau * (1 - left));
    m_velocity = goal + lag * left;
}

bool Fly::moving() const {
    return (m_keys & ~unsigned(Fast)) != 0 || length(m_velocity) > 1e-3 * m_speed;
}

} // namespace ui
