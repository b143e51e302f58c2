#include "ui/interaction/scene_pick.h"

namespace ui {

Seen seenAt(const Snapshot& now, const render::Camera& camera, const QPointF& pixel) {
    Seen out;
    const bool visible = now.scene.empty() || now.scene[now.active].visible;
    if (visible)
        out.contact = contactAt(now.surface, camera, pixel);
    const base::Rayd ray = camera.ray(pixel.x(), pixel.y());
    const auto along = [&](const BrushContact& contact) { return dot(contact.position - ray.origin, ray.direction); };
    double nearest = out.contact ? along(*out.contact) : std::numeric_limits<double>::infinity();
    for (const session::ShownModel& each : now.beside)
        if (const auto hit = contactAt(each.surface, camera, pixel); hit && along(*hit) < nearest) {
            nearest = along(*hit);
            out = {{}, &each};
        }
    return out;
}

} // namespace ui
