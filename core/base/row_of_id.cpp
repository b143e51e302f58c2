#include "core/base/row_of_id.h"

#include "core/base/error.h"

namespace base {

static std::string filled(std::string text, std::string_view value) {
    const std::size_t at = text.find('%');
    return at == std::string::npos ? text : text.replace(at, 1, value);
}

void refuseId(const UnknownId& text, std::string_view id, std::string_view known) {
    throw Error(filled(text.what, id), text.where, filled(text.todo, known));
}

} // namespace base
