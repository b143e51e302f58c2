#include "ui/gl/gl_context.h"

#include "core/base/error.h"
#include "ui/gl/shared_library.h"

// Without this the header pulls in X11's macros.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <string_view>
#include <vector>

namespace render {

namespace {

/// The functions of libEGL that we call.
struct Egl {
    SharedLibrary library{"libEGL.so.1"};
    decltype(&eglGetProcAddress) getProcAddress = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglTerminate) terminate = nullptr;
    decltype(&eglBindAPI) bindApi = nullptr;
    decltype(&eglQueryString) queryString = nullptr;
    decltype(&eglCreateContext) createContext = nullptr;
    decltype(&eglDestroyContext) destroyContext = nullptr;
    decltype(&eglMakeCurrent) makeCurrent = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay = nullptr;
    PFNEGLQUERYDEVICESEXTPROC queryDevices = nullptr;

    Egl() {
        library.find(getProcAddress, "eglGetProcAddress");
        library.find(initialize, "eglInitialize");
        library.find(terminate, "eglTerminate");
        library.find(bindApi, "eglBindAPI");
        library.find(queryString, "eglQueryString");
        library.find(createContext, "eglCreateContext");
        library.find(destroyContext, "eglDestroyContext");
        library.find(makeCurrent, "eglMakeCurrent");
        if (!getProcAddress || !initialize || !terminate || !bindApi || !queryString || !createContext ||
            !destroyContext || !makeCurrent)
            throw base::Error("libEGL.so.1 was not found", "egl",
                              "install the packages libegl1 and libegl-mesa0, or use --backend cpu");
        getPlatformDisplay =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(getProcAddress("eglGetPlatformDisplayEXT"));
        queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(getProcAddress("eglQueryDevicesEXT"));
    }
};

class EglContext : public GlContext {
  public:
    EglContext() {
        if (m_egl.getPlatformDisplay && !tryDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY))
            for (EGLDeviceEXT device : devices())
                if (tryDisplay(EGL_PLATFORM_DEVICE_EXT, device))
                    break;
        if (!m_context)
            throw base::Error("EGL offers no OpenGL 3.3 core context without a window", "egl",
                              "install the package libegl-mesa0 or your GPU's driver, or use --backend cpu");
    }
    ~EglContext() override {
        m_egl.destroyContext(m_display, m_context);
        m_egl.terminate(m_display);
    }

    const char* name() const override { return "egl"; }
    void makeCurrent() override {
        if (!m_egl.bindApi(EGL_OPENGL_API) || !m_egl.makeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context))
            throw base::Error("EGL could not make its context current", "egl", "use --backend cpu");
    }
    void release() override { m_egl.makeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
    void* procAddress(const char* name) const override { return reinterpret_cast<void*>(m_egl.getProcAddress(name)); }

  private:
    std::vector<EGLDeviceEXT> devices() const {
        EGLint count = 0;
        if (!m_egl.queryDevices || !m_egl.queryDevices(0, nullptr, &count) || count <= 0)
            return {};
        std::vector<EGLDeviceEXT> out(static_cast<std::size_t>(count));
        m_egl.queryDevices(count, out.data(), &count);
        out.resize(static_cast<std::size_t>(count));
        return out;
    }

    bool tryDisplay(EGLenum platform, void* native) {
        EGLDisplay display = m_egl.getPlatformDisplay(platform, native, nullptr);
        if (display == EGL_NO_DISPLAY || !m_egl.initialize(display, nullptr, nullptr))
            return false;
        const char* extensions = m_egl.queryString(display, EGL_EXTENSIONS);
        const std::string_view known = extensions ? extensions : "";
        const bool bare = known.find("EGL_KHR_surfaceless_context") != known.npos &&
                          known.find("EGL_KHR_no_config_context") != known.npos;
        const EGLint wanted[] = {
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        if (bare && m_egl.bindApi(EGL_OPENGL_API))
            m_context = m_egl.createContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
        if (!m_context) {
            m_egl.terminate(display);
            return false;
        }
        m_display = display;
        return true;
    }

    Egl m_egl;
    EGLDisplay m_display = EGL_NO_DISPLAY;
    EGLContext m_context = EGL_NO_CONTEXT;
};

} // namespace

std::unique_ptr<GlContext> makeEglContext() {
    return std::make_unique<EglContext>();
}

} // namespace render
