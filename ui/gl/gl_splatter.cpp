#include "ui/gl/gl_splatter.h"

#include "core/base/error.h"

#include <cstddef>

namespace render {

struct GlSplatter::Frame {
    ViewFrame view;
    SplatStyle style;
    const ShadingStyle& shading;
    RenderOptions options;
    float nearest, inverseRange; ///< of the depth buffer, around the model
    bool depth;                  ///< wanted beside the colour
};

/// Loads the functions and refuses what is too old before any of it is used.
static GlFunctions loaded(const GetProcAddress& address) {
    GlFunctions gl = GlFunctions::load(address);
    GLint major = 0, minor = 0;
    gl.getIntegerv(GL_MAJOR_VERSION, &major);
    gl.getIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 33)
        throw base::Error("OpenGL " + std::to_string(major) + "." + std::to_string(minor) + " is older than 3.3", "",
                          "draw on the CPU (--backend cpu, POINTCLAY_RENDERER=cpu)");
    return gl;
}

GlSplatter::GlSplatter(const GetProcAddress& address)
    : m_gl(loaded(address)), m_slots(m_gl), m_targets(m_gl), m_shade(m_gl, shadeVertexShader(), shadeFragmentShader()),
      m_finish(m_gl) {
    for (const SplatShape shape : {SplatShape::Point, SplatShape::Quad})
        for (const SplatPass pass : {SplatPass::Visibility, SplatPass::Attributes})
            m_programs[static_cast<std::size_t>(shape) * 2 + static_cast<std::size_t>(pass)] =
                std::make_unique<GlProgram>(m_gl, splatVertexShader(shape), splatFragmentShader(pass));
    m_gl.genVertexArrays(1, &m_vertexArray);
    GLfloat range[2] = {1, 1};
    m_gl.getFloatv(GL_POINT_SIZE_RANGE, range);
    m_maxPointSize = range[1];
}

GlSplatter::~GlSplatter() {
    m_gl.deleteVertexArrays(1, &m_vertexArray);
}

static void setVector(const GlFunctions& gl, GLint at, const base::Vec3f& v) {
    gl.uniform3f(at, v.x, v.y, v.z);
}

void GlSplatter::setView(const GlProgram& program, const Frame& frame) const {
    program.use();
    const ViewFrame& view = frame.view;
    setVector(m_gl, program.at("right"), view.right);
    setVector(m_gl, program.at("down"), view.down);
    setVector(m_gl, program.at("forward"), view.forward);
    setVector(m_gl, program.at("eye"), view.eye);
    setVector(m_gl, program.at("rest"), view.rest);
    m_gl.uniform4f(program.at("image"), view.x0, view.y0, view.focalPx, frame.style.radiusOfSupport);
    m_gl.uniform2f(program.at("size"), static_cast<float>(view.width), static_cast<float>(view.height));
    m_gl.uniform2f(program.at("depthRange"), frame.nearest, frame.inverseRange);
    m_gl.uniform1i(program.at("oriented"), frame.style.oriented ? 1 : 0);
    m_gl.uniform1f(program.at("backsFarther"), frame.style.backsFarther);
    m_gl.uniform1i(program.at("parallel"), view.parallel ? 1 : 0);
    m_gl.uniform1i(program.at("clipCount"), view.clipCount);
    std::array<float, 4 * ClipPlanes::most> clips{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(view.clipCount); ++k) {
        const ViewClip& clip = view.clips[k];
        clips[4 * k] = clip.normal.x, clips[4 * k + 1] = clip.normal.y;
        clips[4 * k + 2] = clip.constant, clips[4 * k + 3] = clip.factor;
    }
    m_gl.uniform4fv(program.at("clips"), static_cast<GLsizei>(ClipPlanes::most), clips.data());
}

void GlSplatter::bindAttributes(std::size_t page, GLint firstSurfel, GLuint divisor) const {
    const auto at = [&](std::size_t offset) {
        return reinterpret_cast<const void*>(static_cast<std::size_t>(firstSurfel) * sizeof(GlSurfel) + offset);
    };
    m_gl.bindBuffer(GL_ARRAY_BUFFER, m_slots.buffer(page));
    m_gl.vertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(GlSurfel), at(offsetof(GlSurfel, position)));
    m_gl.vertexAttribPointer(1, 4, GL_INT_2_10_10_10_REV, GL_TRUE, sizeof(GlSurfel), at(offsetof(GlSurfel, normal)));
    m_gl.vertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, sizeof(GlSurfel), at(offsetof(GlSurfel, support)));
    m_gl.vertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(GlSurfel), at(offsetof(GlSurfel, colourAndMask)));
    constexpr GLuint shape = 4;
    if (m_slots.shaped()) {
        m_gl.bindBuffer(GL_ARRAY_BUFFER, m_slots.shapes(page));
        m_gl.vertexAttribPointer(
            shape, 4, GL_INT_2_10_10_10_REV, GL_TRUE, sizeof(GlShape),
            reinterpret_cast<const void*>(static_cast<std::size_t>(firstSurfel) * sizeof(GlShape)));
    } else {
        m_gl.disableVertexAttribArray(shape);
        m_gl.vertexAttrib4f(shape, 0, 0, 0, 0); // other painters of the context leave theirs
    }
    for (GLuint k = 0; k < (m_slots.shaped() ? 5u : 4u); ++k) {
        m_gl.enableVertexAttribArray(k);
        m_gl.vertexAttribDivisor(k, divisor);
    }
}

void GlSplatter::drawPass(const Frame& frame, SplatPass pass) {
    setView(program(SplatShape::Point, pass), frame);
    for (std::size_t page = 0; page < m_points.size(); ++page) {
        const Points& points = m_points[page];
        if (points.firsts.empty())
            continue;
        bindAttributes(page, 0, 0);
        m_gl.multiDrawArrays(GL_POINTS, points.firsts.data(), points.counts.data(),
                             static_cast<GLsizei>(points.firsts.size()));
    }
    if (!m_large.empty())
        setView(program(SplatShape::Quad, pass), frame);
    for (const surfel::SurfelBlock* block : m_large) {
        bindAttributes(m_slots.page(block), m_slots.first(block), 1);
        m_gl.drawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, block->size());
    }
}

/// Upper bound of the sprites' sizes in a block: see screenBounds for the extent, and the shader for the shift of
/// sprites whose centre lies outside, which at most doubles it.
static float pointSize(const VisibleBlock& visible, const ViewFrame& view, float reachOfSupport) {
    const float reach = reachOfSupport * visible.block->maxSupport();
    if (view.parallel)
        return 4 * std::max(filterPx, view.focalPx * reach) + 1;
    if (visible.bounds.nearest <= 0)
        return std::numeric_limits<float>::infinity();
    const float widest = 2 * std::max(std::abs(view.x0), std::abs(view.y0));
    return 4 * std::max(filterPx, view.focalPx * reach * (1 + widest) / visible.bounds.nearest) + 1;
}

void GlSplatter::splats(const Frame& frame) {
    m_points.assign(m_slots.pages(), {});
    m_large.clear();
    for (const VisibleBlock& visible : m_visible)
        if (pointSize(visible, frame.view, frame.style.radiusOfSupport) <= m_maxPointSize) {
            Points& points = m_points[m_slots.page(visible.block)];
            points.firsts.push_back(m_slots.first(visible.block));
            points.counts.push_back(visible.block->size());
        } else {
            m_large.push_back(visible.block);
        }

    const GLenum attachments[] = {
        GL_COLOR_ATTACHMENT0, static_cast<GLenum>(frame.style.colours ? GL_COLOR_ATTACHMENT1 : GL_NONE),
        static_cast<GLenum>(frame.depth || GlFinish::wanted(frame.options) ? GL_COLOR_ATTACHMENT2 : GL_NONE)};
    const GLfloat zero[4] = {}, far = 1;
    m_gl.bindFramebuffer(GL_FRAMEBUFFER, m_targets.sums());
    m_gl.drawBuffers(3, attachments);
    m_gl.viewport(0, 0, frame.view.width, frame.view.height);
    for (GLint k = 0; k < 3; ++k)
        m_gl.clearBufferfv(GL_COLOR, k, zero);
    m_gl.depthMask(GL_TRUE);
    m_gl.clearBufferfv(GL_DEPTH, 0, &far);
    m_gl.bindVertexArray(m_vertexArray);
    m_gl.enable(GL_PROGRAM_POINT_SIZE);
    m_gl.enable(GL_DEPTH_TEST);
    m_gl.depthFunc(GL_LEQUAL);

    m_gl.colorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawPass(frame, SplatPass::Visibility);
    m_gl.colorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

    m_gl.depthMask(GL_FALSE);
    m_gl.enable(GL_BLEND);
    m_gl.blendEquation(GL_FUNC_ADD);
    m_gl.blendFunc(GL_ONE, GL_ONE);
    drawPass(frame, SplatPass::Attributes);
    m_gl.disable(GL_BLEND);
    m_gl.depthMask(GL_TRUE);
    m_gl.depthFunc(GL_LESS);
    m_gl.disable(GL_DEPTH_TEST);
    m_gl.disable(GL_PROGRAM_POINT_SIZE);
}

void GlSplatter::shade(const Frame& frame, const Camera& camera, GLuint framebuffer, bool depth) {
    const bool finish = GlFinish::wanted(frame.options);
    m_gl.bindFramebuffer(GL_FRAMEBUFFER, finish ? m_targets.shaded() : framebuffer);
    if (finish) {
        const GLenum all[] = {GL_COLOR_ATTACHMENT0, static_cast<GLenum>(depth ? GL_COLOR_ATTACHMENT1 : GL_NONE),
                              GL_COLOR_ATTACHMENT2};
        m_gl.drawBuffers(3, all);
    } else if (depth) {
        const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
        m_gl.drawBuffers(2, both);
    }
    m_gl.viewport(0, 0, frame.view.width, frame.view.height);
    setView(m_shade, frame);
    const GLuint textures[] = {
        m_targets.normals(), m_targets.colours(), m_targets.depths(), m_targets.light(frame.options.shading),
        m_targets.background(frame.options.backdrop, frame.view.height, frame.options.transparent)};
    const char* names[] = {"normalSums", "colourSums", "depthSums", "light", "background"};
    for (GLint unit = 0; unit < 5; ++unit) {
        m_gl.activeTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        m_gl.bindTexture(GL_TEXTURE_2D, textures[unit]);
        m_gl.uniform1i(m_shade.at(names[unit]), unit);
    }
    setVector(m_gl, m_shade.at("maskTint"), frame.shading.maskTint);
    setVector(m_gl, m_shade.at("backTint"), frame.shading.backTint);
    m_gl.uniform1i(m_shade.at("useColour"), frame.style.coloured ? 1 : 0);
    m_gl.uniform1i(m_shade.at("useAttributes"), frame.style.colours ? 1 : 0);
    m_gl.uniform1i(m_shade.at("useDepth"), depth || finish ? 1 : 0);
    m_gl.bindVertexArray(m_vertexArray);
    m_gl.drawArrays(GL_TRIANGLES, 0, 3);
    if (finish) {
        m_gl.bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        if (depth) {
            const GLenum colour = GL_COLOR_ATTACHMENT0;
            m_gl.drawBuffers(1, &colour);
        }
        m_finish.draw(m_targets, frame.view, camera, frame.options);
    }

    m_gl.bindVertexArray(0);
    m_gl.useProgram(0);
    for (GLenum unit = 5; unit-- > 0;) {
        m_gl.activeTexture(GL_TEXTURE0 + unit);
        m_gl.bindTexture(GL_TEXTURE_2D, 0);
    }
    m_gl.bindBuffer(GL_ARRAY_BUFFER, 0);
}

/// Brings the version and what is drawn of it into slots, and finds what that is.
void GlSplatter::look(const tree::SurfelTree& model, const Frame& frame) {
    const auto colours = frame.style.table ? frame.options.colours : nullptr;
    m_details.use(frame.style.radiusOfSupport, frame.style.oriented);
    m_details.colourBy(model, colours);
    const bool details = frame.options.detailPx > 0 || frame.options.closed;
    const bool finer = FinerBlocks::any(model, frame.options);
    const Sight sight{frame.view,
                      frame.style.radiusOfSupport,
                      details ? &m_details : nullptr,
                      frame.options.detailPx,
                      frame.options.closed && frame.style.oriented,
                      finer ? finerReach : 1,
                      frame.options.pixelScale};
    visibleBlocks(model, sight, m_visible);
    m_slots.show(model, colours);
    const bool bounded = DiscCuts::any(frame.options.definition);
    if (bounded) {
        m_discCuts.use(frame.options.definition, frame.style.radiusOfSupport);
        m_discCuts.follow(model);
        findCuts(sight, m_discCuts, m_visible);
    }
    if (finer)
        m_finer.use(frame.options.definition, frame.style.radiusOfSupport);
    m_finer.follow(model);
    m_slots.drop(m_finer.takeDropped());
    if (finer)
        findFiner(sight, m_finer, m_visible);
    std::vector<const surfel::SurfelBlock*> proxies;
    for (const VisibleBlock& visible : m_visible)
        if (!m_slots.holds(visible.block))
            proxies.push_back(visible.block);
    m_slots.hold(proxies);
    std::vector<std::pair<const surfel::SurfelBlock*, const CutCodes*>> cuts;
    for (const VisibleBlock& visible : m_visible)
        if (visible.large || (!bounded && m_slots.cutBlocks() > 0 && !visible.proxy))
            cuts.emplace_back(visible.block, visible.cuts);
    m_slots.cut(cuts);
}

void GlSplatter::drawTo(GLuint framebuffer, const tree::SurfelTree& model, const Camera& camera,
                        const RenderOptions& options) {
    const SplatStyle style = splatStyle(model, options, camera);
    Frame frame{ViewFrame(camera),
                style,
                shadingStyle(options.shading),
                options,
                0,
                1,
                framebuffer != 0 && framebuffer == m_targets.output()};
    m_targets.resize(camera.width, camera.height);
    look(model, frame);
    if (!model.empty()) {
        // Depths from the nearest to the farthest splat with the bias of both passes, without any fixed planes.
        const base::Box3f box = model.bounds();
        float support = model.maxSupport();
        for (const VisibleBlock& visible : m_visible)
            support = std::max(support, visible.block->maxSupport());
        const float reach = style.radiusOfSupport * support * (2 + layerDepth);
        const float middle = frame.view.toView(box.centre()).z, toCorner = 0.5f * box.diagonal();
        const float pixels =
            (filterDepth + 2 * layerDepth) * filterPx * frame.view.pixelSize(std::max(middle + toCorner, 0.0f));
        const float half = toCorner + reach + pixels;
        frame.nearest = std::max(0.0f, middle - half);
        frame.inverseRange =
            1 / std::max(middle + half + style.backsFarther - frame.nearest, std::numeric_limits<float>::min());
    }
    splats(frame);
    shade(frame, camera, framebuffer, frame.depth);
    m_details.forget(m_shown, model);
    m_slots.drop(m_details.takeDropped());
    m_shown = model;
}

/// GL's lowest row comes first; ours is the top one.
template <class T>
static void flipRows(std::vector<T>& pixels, int width, int height) {
    const auto row = [&](int y) { return pixels.begin() + static_cast<std::ptrdiff_t>(y) * width; };
    for (int y = 0; y < height / 2; ++y)
        std::swap_ranges(row(y), row(y) + width, row(height - 1 - y));
}

void GlSplatter::drawTo(Image& out, const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options) {
    m_targets.resize(camera.width, camera.height);
    drawTo(m_targets.output(), model, camera, options);
    if (out.width != camera.width || out.height != camera.height)
        out.resize(camera.width, camera.height);
    m_gl.bindFramebuffer(GL_FRAMEBUFFER, m_targets.output());
    m_gl.pixelStorei(GL_PACK_ALIGNMENT, 4);
    m_gl.readBuffer(GL_COLOR_ATTACHMENT0);
    m_gl.readPixels(0, 0, out.width, out.height, GL_RGBA, GL_UNSIGNED_BYTE, out.colour.data());
    m_gl.readBuffer(GL_COLOR_ATTACHMENT1);
    m_gl.readPixels(0, 0, out.width, out.height, GL_RED, GL_FLOAT, out.depth.data());
    m_gl.bindFramebuffer(GL_FRAMEBUFFER, 0);
    flipRows(out.colour, out.width, out.height);
    flipRows(out.depth, out.width, out.height);
}

} // namespace render
