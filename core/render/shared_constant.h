// Numbers of formulas that run twice, by vectors on the CPU and in a shader: stated once, with the name that the shader
// knows them by. The CPU side uses them as floats; ui/gl/glsl_text.h writes the shader's.
#pragma once

namespace render {

struct SharedConstant {
    const char* name;
    float value;
    constexpr operator float() const { return value; }
};

} // namespace render
