#include "ui/gl/gl_targets.h"

#include "core/base/error.h"

namespace render {

/// A texture that is read texel by texel.
static GLuint texture(const GlFunctions& gl, GLint format, int width, int height, GLenum order, GLenum type,
                      const void* pixels) {
    GLuint out = 0;
    gl.genTextures(1, &out);
    gl.bindTexture(GL_TEXTURE_2D, out);
    gl.texImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, order, type, pixels);
    gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return out;
}

GlTargets::~GlTargets() {
    discard();
    for (const auto& [shading, light] : m_lights)
        m_gl.deleteTextures(1, &light);
    m_gl.deleteTextures(1, &m_background);
}

void GlTargets::discard() {
    m_gl.deleteFramebuffers(1, &m_sums);
    m_gl.deleteFramebuffers(1, &m_output);
    m_gl.deleteFramebuffers(1, &m_shaded);
    m_gl.deleteTextures(Count, m_textures);
    m_sums = m_output = m_shaded = 0;
    std::fill(std::begin(m_textures), std::end(m_textures), 0u);
}

GLuint GlTargets::framebuffer(GLuint zBuffer, std::initializer_list<GLuint> colours) {
    GLuint out = 0;
    m_gl.genFramebuffers(1, &out);
    m_gl.bindFramebuffer(GL_FRAMEBUFFER, out);
    if (zBuffer)
        m_gl.framebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, zBuffer, 0);
    GLenum attachment = GL_COLOR_ATTACHMENT0;
    for (const GLuint colour : colours)
        m_gl.framebufferTexture2D(GL_FRAMEBUFFER, attachment++, GL_TEXTURE_2D, colour, 0);
    const bool complete = m_gl.checkFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (!complete) {
        m_gl.deleteFramebuffers(1, &out);
        throw base::Error("this OpenGL driver cannot draw into float images of this size", "",
                          "choose a smaller size, or draw on the CPU (--backend cpu, POINTCLAY_RENDERER=cpu)");
    }
    return out;
}

void GlTargets::resize(int width, int height) {
    if (width == m_width && height == m_height)
        return;
    GLint most = 0;
    m_gl.getIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (width > most || height > most)
        throw base::Error("this OpenGL draws at most " + std::to_string(most) + " pixels a side, not " +
                              std::to_string(width) + " x " + std::to_string(height),
                          "", "choose a smaller size, or draw on the CPU (--backend cpu)");
    discard();
    m_width = m_height = 0; // until all of it stands
    const auto make = [&](GLint format, GLenum order, GLenum type) {
        return texture(m_gl, format, width, height, order, type, nullptr);
    };
    m_textures[Normals] = make(GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT);
    m_textures[Colours] = make(GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT);
    m_textures[Depths] = make(GL_RG32F, GL_RG, GL_FLOAT);
    m_textures[ZBuffer] = make(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
    m_textures[OutColour] = make(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    m_textures[OutDepth] = make(GL_R32F, GL_RED, GL_FLOAT);
    m_sums = framebuffer(m_textures[ZBuffer], {m_textures[Normals], m_textures[Colours], m_textures[Depths]});
    m_output = framebuffer(0, {m_textures[OutColour], m_textures[OutDepth]});
    m_width = width, m_height = height;
}

GLuint GlTargets::shaded() {
    if (m_shaded)
        return m_shaded;
    m_textures[Shaded] = texture(m_gl, GL_RGBA8, m_width, m_height, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    m_textures[Geometry] = texture(m_gl, GL_RGBA32F, m_width, m_height, GL_RGBA, GL_FLOAT, nullptr);
    m_shaded = framebuffer(0, {m_textures[Shaded], m_textures[OutDepth], m_textures[Geometry]});
    return m_shaded;
}

GLuint GlTargets::light(Shading shading) {
    GLuint& out = m_lights[shading];
    if (!out)
        out = texture(m_gl, GL_RGBA8, lightSize, lightSize, GL_RGBA, GL_UNSIGNED_BYTE,
                      shadingStyle(shading).light.data());
    return out;
}

GLuint GlTargets::background(Backdrop backdrop, int height, bool transparent) {
    if (m_background && backdrop == m_backdrop && height == m_backgroundHeight &&
        transparent == m_backgroundTransparent)
        return m_background;
    std::vector<surfel::Colour> pixels(8 * static_cast<std::size_t>(height));
    for (int row = 0; row < height; ++row)
        backgroundRow(backdrop, row, height, transparent, pixels.data() + 8 * row);
    m_gl.deleteTextures(1, &m_background);
    m_background = texture(m_gl, GL_RGBA8, 8, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    m_backdrop = backdrop;
    m_backgroundHeight = height;
    m_backgroundTransparent = transparent;
    return m_background;
}

} // namespace render
