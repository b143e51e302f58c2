// Small texts: JSON of one line, settings as `--view` reads them, definitions of surfaces, paths of sessions.
#include "core/io/ini_values.h"
#include "core/session/json_text.h"
#include "core/session/path_text.h"
#include "core/surface/definition_text.h"
#include "fuzz/fuzzed.h"

#include <nlohmann/json.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(data, data + size);
    static_cast<void>(io::iniValues(text, "view", "saved"));
    fuzz::require(session::pathOf(session::pathText(text)) == text || text.starts_with("file://"),
                  "a path comes back from its text");
    fuzz::tried([&] {
        const nlohmann::json value = session::jsonOf(text);
        fuzz::require(session::shortly(value).size() <= 60, "what a message quotes is short");
    });
    fuzz::tried([&] {
        const surface::SurfaceDefinition definition = surface::definitionFromWords(text.substr(0, text.find('\0')));
        fuzz::require(surface::definitionFromWords(surface::toWords(definition)) == definition,
                      "a definition comes back from its words");
    });
    return 0;
}
