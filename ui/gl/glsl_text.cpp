#include "ui/gl/glsl_text.h"

#include "core/io/number_text.h"

namespace render {

std::string glslFloat(float value) {
    std::string out;
    io::appendNumber(out, value);
    return out.find_first_of(".e") == std::string::npos ? out + ".0" : out;
}

std::string glslConstant(const SharedConstant& constant) {
    return std::string("const float ") + constant.name + " = " + glslFloat(constant.value) + ";\n";
}

std::string glslConstants(std::span<const SharedConstant> constants) {
    std::string out;
    for (const SharedConstant& constant : constants)
        out += glslConstant(constant);
    return out;
}

std::string glslConstant(const char* name, const float (&colour)[3]) {
    return std::string("const vec3 ") + name + " = vec3(" + glslFloat(colour[0]) + ", " + glslFloat(colour[1]) + ", " +
           glslFloat(colour[2]) + ");\n";
}

} // namespace render
