// Which submenu of the Model menu a command stands in. A list of forty is no menu; what somebody comes for is.
#pragma once

#include <span>
#include <string_view>

namespace ui {

struct ModelGroup {
    const char* id;       ///< its submenu's object name
    const char* title;    ///< with a key
    std::string_view ops; ///< of commands, separated by blanks, in their order
};

/// The last one holds all commands that no other one names.
std::span<const ModelGroup> modelGroups();
/// Among those that the group names; npos: it does not.
std::size_t placeIn(const ModelGroup& group, std::string_view op);
/// The group that a command belongs to.
const ModelGroup& groupOf(std::string_view op);

} // namespace ui
