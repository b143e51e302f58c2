#include "core/surface/projection/project.h"

#include "core/surface/evaluation/packets.h"
#include "core/surface/projection/projecting.h"

#include <cassert>

namespace surface {

namespace {

/// One thread's part of a batch.
class Feet {
  public:
    Feet(const Surface& surface, std::span<const base::Vec3f> x, const ProjectOptions& options,
         const OrientationHint& hint, std::span<Projection<float>> out)
        : m_x(x), m_options(options), m_hint(hint), m_out(out), m_together(surface, options, x) {}

    void project(Source& source, std::size_t i) {
        if (!m_together.applies()) {
            m_out[i] = Projecting<float>(source, m_x[i], m_options, m_hint).run();
            return;
        }
        m_together.add(source, i);
        if (m_together.full())
            finish();
    }
    /// What was put off, while its sources are as they were.
    void finish() {
        if (!m_together.empty())
            m_together.run([&](const LaneFoot& foot) {
                m_out[foot.index] = Projecting<float>(foot.source, m_x[foot.index], m_options, m_hint).run(foot);
            });
    }

  private:
    std::span<const base::Vec3f> m_x;
    const ProjectOptions& m_options;
    const OrientationHint& m_hint;
    std::span<Projection<float>> m_out;
    FeetTogether m_together;
};

} // namespace

Projection<float> project(const Surface& surface, const base::Vec3f& x, const ProjectOptions& options,
                          const OrientationHint& hint) {
    Source source(surface);
    source.expect({x, x}, packetSlack, 1);
    Projection<float> out;
    Feet feet(surface, {&x, 1}, options, hint, {&out, 1});
    feet.project(source, 0);
    feet.finish();
    return out;
}

Projection<double> projectReference(const Surface& surface, const base::Vec3d& x, const ProjectOptions& options,
                                    const OrientationHint& hint) {
    Source source(surface);
    return Projecting<double>(source, x, options, hint).run();
}

void project(const Surface& surface, std::span<const base::Vec3f> x, const ProjectOptions& options,
             std::span<Projection<float>> out) {
    assert(x.size() == out.size());
    const OrientationHint none;
    forPacketGroups(surface, x, packetSlack, [&](std::span<Source> sources, std::span<const Packet> packets) {
        Feet feet(surface, x, options, none, out);
        for (std::size_t k = 0; k < packets.size(); ++k)
            for (const std::uint32_t i : packets[k])
                feet.project(sources[k], i);
        feet.finish();
    });
}

} // namespace surface
