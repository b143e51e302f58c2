#include "core/session/files_read.h"

#include "core/base/row_of_id.h"
#include "core/session/command.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

/// "source", "sources", or null for commands that have neither.
static const char* sourceOf(const CommandRow& row) {
    for (const char* id : {"source", "sources"})
        if (base::findRow(row.parameters, id))
            return id;
    return nullptr;
}

static std::vector<std::string> textsOf(const json& value) {
    return value.is_array() ? value.get<std::vector<std::string>>() : std::vector{value.get<std::string>()};
}

std::vector<std::string> filesNamed(const json& complete) {
    const CommandRow& row = command(complete.at("op").get_ref<const std::string&>());
    const char* source = sourceOf(row);
    for (const CommandParameter& p : row.parameters)
        if (source && p.id != std::string_view(source) && std::string_view(p.type).starts_with("path") &&
            complete.contains(p.id))
            return textsOf(complete.at(p.id));
    return {};
}

std::vector<std::string> filesRead(const json& complete) {
    std::vector<std::string> out = filesNamed(complete);
    const char* source = sourceOf(command(complete.at("op").get_ref<const std::string&>()));
    if (source && complete.contains(source)) {
        const std::vector<std::string> kept = textsOf(complete.at(source));
        std::copy_n(kept.begin(), std::min(kept.size(), out.size()), out.begin());
    }
    return out;
}

void readInstead(json& complete, std::size_t number, const std::string& file) {
    std::vector<std::string> files = filesRead(complete);
    files.at(number) = file;
    const std::string source = sourceOf(command(complete.at("op").get_ref<const std::string&>()));
    complete[source] = source == "source" ? json(file) : json(files);
}

} // namespace session
