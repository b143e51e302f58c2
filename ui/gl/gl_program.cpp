#include "ui/gl/gl_program.h"

#include "core/base/error.h"

namespace render {

static GLuint compile(const GlFunctions& gl, GLenum kind, const std::string& source) {
    const GLuint shader = gl.createShader(kind);
    const char* text = source.c_str();
    gl.shaderSource(shader, 1, &text, nullptr);
    gl.compileShader(shader);
    GLint good = 0;
    gl.getShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good)
        return shader;
    char log[1024] = "";
    gl.getShaderInfoLog(shader, sizeof log, nullptr, log);
    gl.deleteShader(shader);
    throw base::Error(std::string("the OpenGL driver refused a shader: ") + log, "", "draw on the CPU instead");
}

GlProgram::GlProgram(const GlFunctions& gl, const std::string& vertex, const std::string& fragment) : m_gl(gl) {
    const GLuint v = compile(gl, GL_VERTEX_SHADER, vertex), f = compile(gl, GL_FRAGMENT_SHADER, fragment);
    m_program = gl.createProgram();
    gl.attachShader(m_program, v);
    gl.attachShader(m_program, f);
    gl.linkProgram(m_program);
    gl.deleteShader(v);
    gl.deleteShader(f);
    GLint good = 0;
    gl.getProgramiv(m_program, GL_LINK_STATUS, &good);
    if (good)
        return;
    char log[1024] = "";
    gl.getProgramInfoLog(m_program, sizeof log, nullptr, log);
    gl.deleteProgram(m_program);
    throw base::Error(std::string("the OpenGL driver could not link a shader: ") + log, "", "draw on the CPU instead");
}

GlProgram::~GlProgram() {
    m_gl.deleteProgram(m_program);
}

} // namespace render
