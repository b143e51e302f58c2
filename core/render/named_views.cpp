#include "core/render/named_views.h"

#include "core/base/row_of_id.h"

namespace render {

std::span<const NamedView> namedViews() {
    static const NamedView table[] = {
        {"front", "Front", "1", {0, 0, 1}, {0, 1, 0}}, {"back", "Back", "Ctrl+1", {0, 0, -1}, {0, 1, 0}},
        {"right", "Right", "3", {1, 0, 0}, {0, 1, 0}}, {"left", "Left", "Ctrl+3", {-1, 0, 0}, {0, 1, 0}},
        {"top", "Top", "7", {0, 1, 0}, {0, 0, -1}},    {"bottom", "Bottom", "Ctrl+7", {0, -1, 0}, {0, 0, 1}},
    };
    return table;
}

const NamedView* namedView(std::string_view id) {
    return base::findRow(namedViews(), id);
}

} // namespace render
