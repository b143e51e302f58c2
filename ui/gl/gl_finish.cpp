#include "ui/gl/gl_finish.h"

#include "ui/gl/gl_shaders.h"

namespace render {

void GlFinish::setTaps(const EffectRow& row, const EffectTaps& taps) const {
    const std::string word = row.word;
    std::vector<GLint> places;
    for (const EffectTap& tap : taps.all)
        places.insert(places.end(), {tap.x, tap.y});
    if (!places.empty())
        m_gl.uniform2iv(m_program->at((word + "Taps").c_str()), static_cast<GLsizei>(taps.all.size()), places.data());
    m_gl.uniform1i(m_program->at((word + "TapCount").c_str()), static_cast<GLint>(taps.all.size()));
    if (row.disc > 0)
        m_gl.uniform1f(m_program->at((word + "DiscSq").c_str()), taps.discSq);
}

void GlFinish::setGrid(const GridPlan& plan) const {
    const auto vector = [&](const char* name, const base::Vec3f& v) {
        m_gl.uniform3f(m_program->at(name), v.x, v.y, v.z);
    };
    vector("gridNormal", plan.normal);
    vector("gridAlong", plan.along);
    vector("gridAcross", plan.across);
    vector("gridInk", plan.ink);
    m_gl.uniform3f(m_program->at("gridStart"), plan.alongStart, plan.acrossStart, plan.offset);
    m_gl.uniform3f(m_program->at("gridShape"), plan.cell, plan.inverseRadiusSq, plan.width);
}

void GlFinish::draw(GlTargets& targets, const ViewFrame& view, const Camera& camera, const RenderOptions& options) {
    if (!m_program)
        m_program = std::make_unique<GlProgram>(m_gl, shadeVertexShader(), finishFragmentShader());
    m_program->use();
    const GLuint textures[] = {targets.shadedColour(), targets.geometry()};
    const char* names[] = {"shaded", "geometry"};
    for (GLint unit = 0; unit < 2; ++unit) {
        m_gl.activeTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        m_gl.bindTexture(GL_TEXTURE_2D, textures[unit]);
        m_gl.uniform1i(m_program->at(names[unit]), unit);
    }
    m_gl.uniform4f(m_program->at("image"), view.x0, view.y0, view.step, 0);
    m_gl.uniform2f(m_program->at("size"), static_cast<float>(view.width), static_cast<float>(view.height));
    m_gl.uniform1i(m_program->at("parallel"), view.parallel ? 1 : 0);
    const EffectPlan effects(options.effects, view, options.pixelScale);
    for (const EffectRow& row : effectTable())
        setTaps(row, effects.of(row.effect));
    m_gl.uniform1i(m_program->at("grid"), options.grid ? 1 : 0);
    if (options.grid)
        setGrid(GridPlan(*options.grid, camera, backdropRow(options.backdrop).ink, options.pixelScale));
    m_gl.drawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace render
