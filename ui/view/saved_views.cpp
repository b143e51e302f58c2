#include "ui/view/saved_views.h"

#include <array>
#include <charconv>

namespace ui {

using base::Vec3d;

View SavedView::forOrigin(const Vec3d& of) const {
    View out = view;
    if (of == origin)
        return out;
    const Vec3d shift = origin - of;
    out.target += shift;
    if (out.pivot)
        *out.pivot += shift;
    return out;
}

/// target, distance, turn, angle of view, parallel, origin, has a pivot (1: picked, 2: from framing), pivot
using Numbers = std::array<double, 17>;

std::string textOf(const SavedView& saved) {
    const View& v = saved.view;
    const Vec3d pivot = v.pivot.value_or(Vec3d{});
    const Numbers numbers{v.target.x,     v.target.y,
                          v.target.z,     v.distance,
                          v.turn.w,       v.turn.v.x,
                          v.turn.v.y,     v.turn.v.z,
                          v.fovDeg,       v.parallel ? 1.0 : 0.0,
                          saved.origin.x, saved.origin.y,
                          saved.origin.z, !v.pivot ? 0.0 : v.picked ? 1.0 : 2.0,
                          pivot.x,        pivot.y,
                          pivot.z};
    std::string out;
    for (const double number : numbers) {
        char text[40];
        out.append(text, std::to_chars(text, text + sizeof text, number).ptr); // the shortest that reads back
        out += ' ';
    }
    return out + saved.name;
}

std::optional<SavedView> savedViewOf(const std::string& text) {
    Numbers n;
    const char *at = text.data(), *end = at + text.size();
    for (double& number : n) {
        const auto [next, error] = std::from_chars(at, end, number);
        if (error != std::errc{} || next == end || *next != ' ' || !std::isfinite(number))
            return {};
        at = next + 1;
    }
    SavedView out;
    out.name.assign(at, end);
    out.view.target = {n[0], n[1], n[2]};
    out.view.distance = n[3];
    out.view.turn = {n[4], {n[5], n[6], n[7]}};
    out.view.fovDeg = n[8];
    out.view.parallel = n[9] != 0;
    out.origin = {n[10], n[11], n[12]};
    if (n[13] != 0)
        out.view.pivot = Vec3d{n[14], n[15], n[16]}, out.view.picked = n[13] == 1;
    const double size = out.view.turn.w * out.view.turn.w + lengthSq(out.view.turn.v);
    if (out.name.empty() || !(n[3] > 0) || !(n[8] > 0 && n[8] < 180) || std::abs(size - 1) > 1e-6)
        return {};
    return out;
}

void keep(std::vector<SavedView>& views, const SavedView& view) {
    for (SavedView& each : views)
        if (each.name == view.name) {
            each = view;
            return;
        }
    views.push_back(view);
}

const SavedView* findView(std::span<const SavedView> views, std::string_view name) {
    for (const SavedView& each : views)
        if (each.name == name)
            return &each;
    return nullptr;
}

} // namespace ui
