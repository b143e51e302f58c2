// A linked GLSL program with its uniforms. The context that made it must be current wherever it is used.
#pragma once

#include "ui/gl/gl_functions.h"

#include <string>

namespace render {

class GlProgram {
  public:
    /// Throws base::Error with the compiler's own words.
    GlProgram(const GlFunctions& gl, const std::string& vertex, const std::string& fragment);
    ~GlProgram();
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;

    void use() const { m_gl.useProgram(m_program); }
    /// Place of a uniform; -1, which GL ignores, where the compiler dropped it.
    GLint at(const char* name) const { return m_gl.getUniformLocation(m_program, name); }

  private:
    const GlFunctions& m_gl;
    GLuint m_program = 0;
};

} // namespace render
