// The textures and framebuffers that the three passes draw into and read from, kept while the image's size stays.
#pragma once

#include "core/render/shading/shading.h"
#include "ui/gl/gl_functions.h"

#include <map>

namespace render {

class GlTargets {
  public:
    explicit GlTargets(const GlFunctions& gl) : m_gl(gl) {}
    ~GlTargets();
    GlTargets(const GlTargets&) = delete;
    GlTargets& operator=(const GlTargets&) = delete;

    void resize(int width, int height);

    GLuint sums() const { return m_sums; }     ///< framebuffer of passes 1 and 2
    GLuint output() const { return m_output; } ///< framebuffer for reading back: colour, and depth in a float
    /// Framebuffer of pass 3 where another follows: colour, depth as in `output`, normal and nearness. Made when asked.
    GLuint shaded();
    GLuint shadedColour() const { return m_textures[Shaded]; }
    GLuint geometry() const { return m_textures[Geometry]; }
    GLuint normals() const { return m_textures[Normals]; }
    GLuint colours() const { return m_textures[Colours]; }
    GLuint depths() const { return m_textures[Depths]; }
    /// The picture of the lit ball of a shading.
    GLuint light(Shading shading);
    /// Texture of 8 x height pixels.
    GLuint background(Backdrop backdrop, int height, bool transparent);

  private:
    enum Name { Normals, Colours, Depths, ZBuffer, OutColour, OutDepth, Shaded, Geometry, Count };
    void discard();
    GLuint framebuffer(GLuint zBuffer, std::initializer_list<GLuint> colours);

    const GlFunctions& m_gl;
    int m_width = 0, m_height = 0;
    GLuint m_textures[Count] = {};
    GLuint m_sums = 0, m_output = 0, m_shaded = 0;
    std::map<Shading, GLuint> m_lights;
    GLuint m_background = 0;
    Backdrop m_backdrop = Backdrop::Studio;
    int m_backgroundHeight = 0;
    bool m_backgroundTransparent = false;
};

} // namespace render
