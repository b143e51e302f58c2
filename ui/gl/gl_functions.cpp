#include "ui/gl/gl_functions.h"

#include "core/base/error.h"

#include <string>

namespace render {

template <class Function>
static void find(Function& out, const GetProcAddress& address, const char* name) {
    out = reinterpret_cast<Function>(address(name));
    if (!out)
        throw base::Error(
            std::string("this OpenGL driver lacks ") + name, "",
            "install a driver with OpenGL 3.3, or draw on the CPU (--backend cpu, POINTCLAY_RENDERER=cpu)");
}

GlFunctions GlFunctions::load(const GetProcAddress& address) {
    GlFunctions gl;
    find(gl.activeTexture, address, "glActiveTexture");
    find(gl.attachShader, address, "glAttachShader");
    find(gl.bindBuffer, address, "glBindBuffer");
    find(gl.bindFramebuffer, address, "glBindFramebuffer");
    find(gl.bindTexture, address, "glBindTexture");
    find(gl.bindVertexArray, address, "glBindVertexArray");
    find(gl.blendEquation, address, "glBlendEquation");
    find(gl.blendFunc, address, "glBlendFunc");
    find(gl.bufferData, address, "glBufferData");
    find(gl.bufferSubData, address, "glBufferSubData");
    find(gl.checkFramebufferStatus, address, "glCheckFramebufferStatus");
    find(gl.clearBufferfv, address, "glClearBufferfv");
    find(gl.colorMask, address, "glColorMask");
    find(gl.compileShader, address, "glCompileShader");
    find(gl.copyBufferSubData, address, "glCopyBufferSubData");
    find(gl.createProgram, address, "glCreateProgram");
    find(gl.createShader, address, "glCreateShader");
    find(gl.deleteBuffers, address, "glDeleteBuffers");
    find(gl.deleteFramebuffers, address, "glDeleteFramebuffers");
    find(gl.deleteProgram, address, "glDeleteProgram");
    find(gl.deleteShader, address, "glDeleteShader");
    find(gl.deleteTextures, address, "glDeleteTextures");
    find(gl.deleteVertexArrays, address, "glDeleteVertexArrays");
    find(gl.depthFunc, address, "glDepthFunc");
    find(gl.depthMask, address, "glDepthMask");
    find(gl.disable, address, "glDisable");
    find(gl.disableVertexAttribArray, address, "glDisableVertexAttribArray");
    find(gl.drawArrays, address, "glDrawArrays");
    find(gl.drawArraysInstanced, address, "glDrawArraysInstanced");
    find(gl.drawBuffers, address, "glDrawBuffers");
    find(gl.enable, address, "glEnable");
    find(gl.enableVertexAttribArray, address, "glEnableVertexAttribArray");
    find(gl.framebufferTexture2D, address, "glFramebufferTexture2D");
    find(gl.genBuffers, address, "glGenBuffers");
    find(gl.genFramebuffers, address, "glGenFramebuffers");
    find(gl.genTextures, address, "glGenTextures");
    find(gl.genVertexArrays, address, "glGenVertexArrays");
    find(gl.getError, address, "glGetError");
    find(gl.getFloatv, address, "glGetFloatv");
    find(gl.getIntegerv, address, "glGetIntegerv");
    find(gl.getProgramInfoLog, address, "glGetProgramInfoLog");
    find(gl.getProgramiv, address, "glGetProgramiv");
    find(gl.getShaderInfoLog, address, "glGetShaderInfoLog");
    find(gl.getShaderiv, address, "glGetShaderiv");
    find(gl.getString, address, "glGetString");
    find(gl.getUniformLocation, address, "glGetUniformLocation");
    find(gl.linkProgram, address, "glLinkProgram");
    find(gl.multiDrawArrays, address, "glMultiDrawArrays");
    find(gl.pixelStorei, address, "glPixelStorei");
    find(gl.readBuffer, address, "glReadBuffer");
    find(gl.readPixels, address, "glReadPixels");
    find(gl.shaderSource, address, "glShaderSource");
    find(gl.texImage2D, address, "glTexImage2D");
    find(gl.texParameteri, address, "glTexParameteri");
    find(gl.uniform1f, address, "glUniform1f");
    find(gl.uniform1i, address, "glUniform1i");
    find(gl.uniform2f, address, "glUniform2f");
    find(gl.uniform2iv, address, "glUniform2iv");
    find(gl.uniform3f, address, "glUniform3f");
    find(gl.uniform4f, address, "glUniform4f");
    find(gl.uniform4fv, address, "glUniform4fv");
    find(gl.useProgram, address, "glUseProgram");
    find(gl.vertexAttrib4f, address, "glVertexAttrib4f");
    find(gl.vertexAttribDivisor, address, "glVertexAttribDivisor");
    find(gl.vertexAttribPointer, address, "glVertexAttribPointer");
    find(gl.viewport, address, "glViewport");
    return gl;
}

} // namespace render
