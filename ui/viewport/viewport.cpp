#include "ui/viewport/viewport.h"

#include "ui/viewport/cpu_viewport.h"
#include "ui/viewport/gl_viewport.h"

namespace ui {

Viewport* makeViewport(QWidget* parent, QString* why) {
    const QByteArray wish = qgetenv("POINTCLAY_RENDERER");
    QString reason = "chosen by POINTCLAY_RENDERER";
    const bool gl = wish != "cpu" && glUsable(wish == "gl", reason);
    if (why)
        *why = reason;
    if (gl)
        return new GlViewport(parent);
    return new CpuViewport(parent);
}

} // namespace ui
