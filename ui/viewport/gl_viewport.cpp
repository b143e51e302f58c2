#include "ui/gl/gl_splatter.h" // before Qt's headers: it brings the GL declarations

#include "ui/viewport/gl_viewport.h"

#include <chrono>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>

namespace ui {

/// As long as nothing new came, the view rests.
constexpr int restMs = 120;

static QSurfaceFormat wantedFormat() {
    QSurfaceFormat out;
    out.setRenderableType(QSurfaceFormat::OpenGL);
    out.setProfile(QSurfaceFormat::CoreProfile);
    out.setVersion(3, 3);
    return out;
}

static render::GetProcAddress addresses(QOpenGLContext* context) {
    return [context](const char* name) { return reinterpret_cast<void*>(context->getProcAddress(name)); };
}

static QString driverOf(QOpenGLContext& context) {
    return QString::fromUtf8(reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER)));
}

static bool isSoftware(const QString& driver) {
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SwiftShader"})
        if (driver.contains(name, Qt::CaseInsensitive))
            return true;
    return false;
}

/// With the context current: builds a splatter and drops it. Throws where it does not work.
static bool tryContext(QOpenGLContext& context, bool software, QString& why) {
    const QSurfaceFormat got = context.format();
    if (got.version() < qMakePair(3, 3) || got.profile() != QSurfaceFormat::CoreProfile) {
        why = QString("OpenGL %1.%2 is too old").arg(got.majorVersion()).arg(got.minorVersion());
        return false;
    }
    why = driverOf(context);
    if (!software && isSoftware(why)) {
        why += ": a software driver, the CPU renderer is faster";
        return false;
    }
    const render::GlSplatter trial(addresses(&context));
    return true;
}

bool glUsable(bool software, QString& why) {
    for (const char* platform : {"offscreen", "minimal", "vnc"})
        if (QGuiApplication::platformName().startsWith(platform)) {
            why = QString("platform %1 has no OpenGL widgets").arg(platform);
            return false;
        }
    QOpenGLContext context;
    context.setFormat(wantedFormat());
    QOffscreenSurface surface;
    surface.setFormat(wantedFormat());
    surface.create();
    if (!context.create() || !surface.isValid() || !context.makeCurrent(&surface)) {
        why = "no OpenGL context could be made";
        return false;
    }
    bool usable = false;
    try {
        usable = tryContext(context, software, why);
    } catch (const std::exception& error) {
        why = QString::fromUtf8(error.what());
    }
    context.doneCurrent();
    return usable;
}

GlViewport::GlViewport(QWidget* parent) : QOpenGLWidget(parent) {
    setFormat(wantedFormat());
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        m_settling = true;
        update();
    });
}

GlViewport::~GlViewport() {
    dropSplatter();
}

void GlViewport::dropSplatter() {
    if (!m_splatter)
        return;
    makeCurrent();
    m_splatter.reset();
    doneCurrent();
}

void GlViewport::show(const Frame& frame) {
    m_frame = frame;
    m_settling = false;
    m_rest.stop();
    if (!frame.truth) {
        m_truth.reset();
        if (refined)
            refined({});
    } else {
        if (!m_truth)
            m_truth = std::make_unique<ThreadPicture>(*this, *this);
        m_truth->show(frame);
    }
    update();
}

float GlViewport::detailPx() const {
    if (!m_withOverlay) // for keeping
        return m_frame.options.detailPx;
    if (m_settling)
        return std::max(m_frame.options.detailPx, m_pacer.settling(m_lastDetail));
    return m_frame.moving ? m_pacer.moving() : m_frame.options.detailPx;
}

void GlViewport::initializeGL() {
    // Moving to another screen or window gives another context; the splatter goes with the old one.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlViewport::dropSplatter, Qt::UniqueConnection);
    m_name = "OpenGL, " + driverOf(*context());
    try {
        m_splatter = std::make_unique<render::GlSplatter>(addresses(context()));
    } catch (const std::exception& error) {
        m_splatter.reset();
        if (troubled)
            troubled(QString::fromUtf8(error.what()));
    }
}

void GlViewport::drawSplats() {
    const auto start = std::chrono::steady_clock::now();
    render::RenderOptions options = m_frame.options;
    options.detailPx = detailPx();
    if (m_splatter)
        m_splatter->drawTo(defaultFramebufferObject(), m_frame.model, m_frame.camera, options);
    context()->functions()->glFinish();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    m_lastDetail = options.detailPx;
    m_pacer.drew(options.detailPx, seconds);
    if (options.detailPx > m_frame.options.detailPx)
        m_rest.start(m_settling ? 0 : restMs);
    if (framePainted)
        framePainted(seconds);
}

void GlViewport::paintGL() {
    const bool truth = showsTruth();
    if (!truth)
        drawSplats();
    QPainter painter(this);
    if (truth)
        m_truth->paint(painter);
    if (paintOverlay && m_withOverlay)
        paintOverlay(painter);
    if (shown)
        shown(truth ? m_truth->input() : m_frame.input);
}

QImage GlViewport::picture() {
    m_withOverlay = false;
    const QImage out = grabFramebuffer();
    m_withOverlay = true;
    return out;
}

} // namespace ui
