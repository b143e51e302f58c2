#include "core/surface/surface.h"

#include "core/surface/evaluation/packets.h"
#include "core/surface/frames/frame_table.h"

#include <cassert>

namespace surface {

const char* statusName(Status status) {
    switch (status) {
    case Status::Ok:
        return "ok";
    case Status::Outside:
        return "outside";
    case Status::Degenerate:
        return "degenerate";
    case Status::NotConverged:
        return "not-converged";
    case Status::BeyondBoundary:
        return "beyond-boundary";
    }
    return "";
}

const char* causeName(Cause cause) {
    switch (cause) {
    case Cause::None:
        return "none";
    case Cause::NoSupport:
        return "no-support";
    case Cause::OnePoint:
        return "one-point";
    case Cause::TooFew:
        return "too-few";
    case Cause::Coincident:
        return "coincident";
    case Cause::Collinear:
        return "collinear";
    case Cause::CancellingNormals:
        return "cancelling-normals";
    case Cause::ClosedGap:
        return "closed-gap";
    case Cause::NoGradient:
        return "no-gradient";
    }
    return "";
}

Surface Surface::withSupportScale(float scale) const {
    assert(scale >= 1);
    Surface out = *this;
    out.m_supportScale = scale;
    return out;
}

Frame Surface::effectiveFrame() const {
    const auto& layout = *m_tree.layout();
    const NormalsRead reads = rowOf(m_definition.frame).reads;
    if (reads != NormalsRead::None && !layout.normals)
        return Frame::CovarianceAtCentroid;
    return reads == NormalsRead::Oriented && !layout.oriented ? Frame::Hyperplanes : m_definition.frame;
}

Evaluationf Surface::evaluate(const base::Vec3f& x, Need need, const OrientationHint& hint) const {
    return Source(*this, Steps::Apart).evaluate(x, need, hint);
}

Evaluationd Surface::evaluateReference(const base::Vec3d& x, Need need, const OrientationHint& hint) const {
    return Source(*this, Steps::Apart).evaluate(x, need, hint);
}

void Surface::evaluate(std::span<const base::Vec3f> x, Need need, std::span<Evaluationf> out) const {
    assert(x.size() == out.size());
    forPackets(*this, x, 0, [&](Source& source, std::size_t i) { source.evaluate(x[i], need, {}, out[i]); });
}

} // namespace surface
