// Material libraries of OBJ files.
#include "core/io/obj/obj_materials.h"
#include "fuzz/fuzzed.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::put("a.mtl", {reinterpret_cast<const char*>(data), size});
    std::vector<std::string> messages;
    const auto materials = io::readMaterials(fuzz::folder(), {"a.mtl"}, messages);
    for (const auto& [name, material] : materials) {
        const auto path = io::besideModel(fuzz::folder(), material.picture.file);
        fuzz::require(path.empty() || path.string().starts_with(fuzz::folder().string() + "/"),
                      "a model names pictures of its own folder only");
    }
    return 0;
}
