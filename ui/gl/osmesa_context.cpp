#include "ui/gl/gl_context.h"

#include "core/base/error.h"
#include "ui/gl/shared_library.h"

#include <array>
#include <GL/osmesa.h>

namespace render {

namespace {

class OsMesaContext : public GlContext {
  public:
    OsMesaContext() {
        m_library.find(m_create, "OSMesaCreateContextAttribs");
        m_library.find(m_destroy, "OSMesaDestroyContext");
        m_library.find(m_makeCurrent, "OSMesaMakeCurrent");
        m_library.find(m_procAddress, "OSMesaGetProcAddress");
        if (!m_create || !m_destroy || !m_makeCurrent || !m_procAddress)
            throw base::Error("libOSMesa.so.8 was not found", "osmesa",
                              "install the package libosmesa6, or use --backend cpu");
        const int wanted[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
        m_context = m_create(wanted, nullptr);
        if (!m_context)
            throw base::Error("this libOSMesa has no OpenGL 3.3 core profile", "osmesa",
                              "install a newer libosmesa6, or use --backend cpu");
    }
    ~OsMesaContext() override { m_destroy(m_context); }

    const char* name() const override { return "osmesa"; }
    void makeCurrent() override {
        if (!m_makeCurrent(m_context, m_pixels.data(), GL_UNSIGNED_BYTE, side, side))
            throw base::Error("OSMesa could not make its context current", "osmesa", "use --backend cpu");
    }
    void release() override { m_makeCurrent(nullptr, nullptr, 0, 0, 0); }
    void* procAddress(const char* name) const override { return reinterpret_cast<void*>(m_procAddress(name)); }

  private:
    /// OSMesa wants a default framebuffer in our memory; we draw into our own ones.
    static constexpr int side = 16;
    std::array<unsigned char, side * side * 4> m_pixels{};
    SharedLibrary m_library{"libOSMesa.so.8"};
    decltype(&OSMesaCreateContextAttribs) m_create = nullptr;
    decltype(&OSMesaDestroyContext) m_destroy = nullptr;
    decltype(&OSMesaMakeCurrent) m_makeCurrent = nullptr;
    decltype(&OSMesaGetProcAddress) m_procAddress = nullptr;
    OSMesaContext m_context = nullptr;
};

} // namespace

std::unique_ptr<GlContext> makeOsMesaContext() {
    return std::make_unique<OsMesaContext>();
}

} // namespace render
