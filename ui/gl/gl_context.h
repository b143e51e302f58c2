// An OpenGL 3.3 core context without a window, from a library that is looked for when the program runs.
//
// Contexts of Mesa's libraries share one dispatch table per thread: use none of these on a thread where a Qt context is
// current. Every call of `makeCurrent` must be followed by `release` on the same thread.
#pragma once

#include <memory>

namespace render {

class GlContext {
  public:
    virtual ~GlContext() = default;
    virtual const char* name() const = 0;
    virtual void makeCurrent() = 0;
    virtual void release() = 0;
    /// Address of a GL function, or null. REQUIRES: current.
    virtual void* procAddress(const char* name) const = 0;
};

/// Software rendering by Mesa into memory. Throws base::Error where libOSMesa is missing or too old.
std::unique_ptr<GlContext> makeOsMesaContext();
/// A GPU or Mesa without a window system: EGL on the surfaceless platform, then on the first device that works. Throws
/// base::Error where there is none.
std::unique_ptr<GlContext> makeEglContext();

/// Makes a context current for a scope.
class Current {
  public:
    explicit Current(GlContext& context) : m_context(context) { m_context.makeCurrent(); }
    ~Current() { m_context.release(); }
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

  private:
    GlContext& m_context;
};

} // namespace render
