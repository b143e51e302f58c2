#include "core/base/up_axis.h"

namespace base {

static constexpr UpRow table[] = {
    {"y", UpAxis::Y, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},         {"z", UpAxis::Z, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {"-y", UpAxis::MinusY, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, {"-z", UpAxis::MinusZ, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
    {"x", UpAxis::X, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},        {"-x", UpAxis::MinusX, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
};

std::span<const UpRow> upTable() {
    return table;
}

const UpRow& upRow(UpAxis axis) {
    return table[static_cast<std::size_t>(axis)];
}

UpAxis nextUp(UpAxis axis) {
    return static_cast<UpAxis>((static_cast<std::size_t>(axis) + 1) % std::size(table));
}

} // namespace base
