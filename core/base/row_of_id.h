// Rows of a table by their ids: found, or refused with an error that lists the ids there are.
//
//     const ToolRow& row = base::rowOf(toolTable(), id, {"there is no tool '%'", "tool", "choose one of %"});
//     const CommandRow* row = base::findRow(commandTable(), op, &CommandRow::op);
//
// A table is any range of rows. Its ids are members `id` unless the last argument names another member; they are
// compared as text.
#pragma once

#include <functional>
#include <iterator>
#include <string>
#include <string_view>

namespace base {

/// What an Error says about an id that a table lacks. The first `%` in `what` stands for the id, the first one in
/// `todo` for all ids of the table.
struct UnknownId {
    const char* what;
    const char* where;
    const char* todo;
};

/// Throws base::Error.
[[noreturn]] void refuseId(const UnknownId& text, std::string_view id, std::string_view known);

namespace detail {

struct RowId {
    template <class Row>
    const auto& operator()(const Row& row) const {
        return row.id;
    }
};

} // namespace detail

/// The row with that id, or null.
template <class Table, class Id = detail::RowId>
auto findRow(const Table& table, std::string_view id, const Id& idOf = {}) -> decltype(&*std::begin(table)) {
    for (const auto& row : table)
        if (std::string_view(std::invoke(idOf, row)) == id)
            return &row;
    return nullptr;
}

/// All ids of a table: "a, b, c".
template <class Table, class Id = detail::RowId>
std::string joinedIds(const Table& table, const Id& idOf = {}) {
    std::string out;
    for (const auto& row : table)
        out.append(out.empty() ? "" : ", ").append(std::invoke(idOf, row));
    return out;
}

/// The row with that id; throws base::Error.
template <class Table, class Id = detail::RowId>
const auto& rowOf(const Table& table, std::string_view id, const UnknownId& text, const Id& idOf = {}) {
    if (const auto* row = findRow(table, id, idOf))
        return *row;
    refuseId(text, id, joinedIds(table, idOf));
}

} // namespace base
