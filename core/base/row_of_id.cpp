#include "core/base/row_of_id.h"

#include "core/base/error.h"
#include "core/base/near_word.h"

namespace base {

static std::string filled(std::string text, std::string_view value) {
    const std::size_t at = text.find('%');
    return at == std::string::npos ? text : text.replace(at, 1, value);
}

void refuseId(const UnknownId& text, std::string_view id, std::string_view known) {
    throw Error(filled(text.what, id), text.where, didYouMeanOr(id, known, filled(text.todo, known)));
}

} // namespace base
