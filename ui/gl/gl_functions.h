// The OpenGL 3.3 core functions that the splatter calls, loaded from whichever context is current: no GL library is
// linked when the program is built, and none is needed where none is used.
//
// Include it before Qt's headers, or in files without Qt.
#pragma once

#include <functional>
#include <GL/glcorearb.h>

namespace render {

/// Address of a GL function by its name, or null.
using GetProcAddress = std::function<void*(const char* name)>;

struct GlFunctions {
    PFNGLACTIVETEXTUREPROC activeTexture = nullptr;
    PFNGLATTACHSHADERPROC attachShader = nullptr;
    PFNGLBINDBUFFERPROC bindBuffer = nullptr;
    PFNGLBINDFRAMEBUFFERPROC bindFramebuffer = nullptr;
    PFNGLBINDTEXTUREPROC bindTexture = nullptr;
    PFNGLBINDVERTEXARRAYPROC bindVertexArray = nullptr;
    PFNGLBLENDEQUATIONPROC blendEquation = nullptr;
    PFNGLBLENDFUNCPROC blendFunc = nullptr;
    PFNGLBUFFERDATAPROC bufferData = nullptr;
    PFNGLBUFFERSUBDATAPROC bufferSubData = nullptr;
    PFNGLCHECKFRAMEBUFFERSTATUSPROC checkFramebufferStatus = nullptr;
    PFNGLCLEARBUFFERFVPROC clearBufferfv = nullptr;
    PFNGLCOLORMASKPROC colorMask = nullptr;
    PFNGLCOMPILESHADERPROC compileShader = nullptr;
    PFNGLCOPYBUFFERSUBDATAPROC copyBufferSubData = nullptr;
    PFNGLCREATEPROGRAMPROC createProgram = nullptr;
    PFNGLCREATESHADERPROC createShader = nullptr;
    PFNGLDELETEBUFFERSPROC deleteBuffers = nullptr;
    PFNGLDELETEFRAMEBUFFERSPROC deleteFramebuffers = nullptr;
    PFNGLDELETEPROGRAMPROC deleteProgram = nullptr;
    PFNGLDELETESHADERPROC deleteShader = nullptr;
    PFNGLDELETETEXTURESPROC deleteTextures = nullptr;
    PFNGLDELETEVERTEXARRAYSPROC deleteVertexArrays = nullptr;
    PFNGLDEPTHFUNCPROC depthFunc = nullptr;
    PFNGLDEPTHMASKPROC depthMask = nullptr;
    PFNGLDISABLEPROC disable = nullptr;
    PFNGLDISABLEVERTEXATTRIBARRAYPROC disableVertexAttribArray = nullptr;
    PFNGLDRAWARRAYSPROC drawArrays = nullptr;
    PFNGLDRAWARRAYSINSTANCEDPROC drawArraysInstanced = nullptr;
    PFNGLDRAWBUFFERSPROC drawBuffers = nullptr;
    PFNGLENABLEPROC enable = nullptr;
    PFNGLENABLEVERTEXATTRIBARRAYPROC enableVertexAttribArray = nullptr;
    PFNGLFRAMEBUFFERTEXTURE2DPROC framebufferTexture2D = nullptr;
    PFNGLGENBUFFERSPROC genBuffers = nullptr;
    PFNGLGENFRAMEBUFFERSPROC genFramebuffers = nullptr;
    PFNGLGENTEXTURESPROC genTextures = nullptr;
    PFNGLGENVERTEXARRAYSPROC genVertexArrays = nullptr;
    PFNGLGETERRORPROC getError = nullptr;
    PFNGLGETFLOATVPROC getFloatv = nullptr;
    PFNGLGETINTEGERVPROC getIntegerv = nullptr;
    PFNGLGETPROGRAMINFOLOGPROC getProgramInfoLog = nullptr;
    PFNGLGETPROGRAMIVPROC getProgramiv = nullptr;
    PFNGLGETSHADERINFOLOGPROC getShaderInfoLog = nullptr;
    PFNGLGETSHADERIVPROC getShaderiv = nullptr;
    PFNGLGETSTRINGPROC getString = nullptr;
    PFNGLGETUNIFORMLOCATIONPROC getUniformLocation = nullptr;
    PFNGLLINKPROGRAMPROC linkProgram = nullptr;
    PFNGLMULTIDRAWARRAYSPROC multiDrawArrays = nullptr;
    PFNGLPIXELSTOREIPROC pixelStorei = nullptr;
    PFNGLREADBUFFERPROC readBuffer = nullptr;
    PFNGLREADPIXELSPROC readPixels = nullptr;
    PFNGLSHADERSOURCEPROC shaderSource = nullptr;
    PFNGLTEXIMAGE2DPROC texImage2D = nullptr;
    PFNGLTEXPARAMETERIPROC texParameteri = nullptr;
    PFNGLUNIFORM1FPROC uniform1f = nullptr;
    PFNGLUNIFORM1IPROC uniform1i = nullptr;
    PFNGLUNIFORM2FPROC uniform2f = nullptr;
    PFNGLUNIFORM2IVPROC uniform2iv = nullptr;
    PFNGLUNIFORM3FPROC uniform3f = nullptr;
    PFNGLUNIFORM4FPROC uniform4f = nullptr;
    PFNGLUNIFORM4FVPROC uniform4fv = nullptr;
    PFNGLUSEPROGRAMPROC useProgram = nullptr;
    PFNGLVERTEXATTRIB4FPROC vertexAttrib4f = nullptr;
    PFNGLVERTEXATTRIBDIVISORPROC vertexAttribDivisor = nullptr;
    PFNGLVERTEXATTRIBPOINTERPROC vertexAttribPointer = nullptr;
    PFNGLVIEWPORTPROC viewport = nullptr;

    /// Throws base::Error naming the first function that the driver lacks.
    static GlFunctions load(const GetProcAddress& address);
};

} // namespace render
