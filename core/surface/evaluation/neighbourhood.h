// What a frame is computed from: the surfels around a position, their sums, the centroid, and the sheet that they are
// kept to. Filled by the assembler; frames read it. Internal to the room.
#pragma once

#include "core/surface/evaluation/near_sheets.h"
#include "core/surface/evaluation/source.h"
#include "core/surface/frames/frame_table.h"
#include "core/surfel/shape.h"

namespace surface {

template <class T, int O>
struct Neighbourhood {
    const Source& source;
    ClusterSpan clusters;
    base::Vec3<T> x;
    base::Vec3d side; ///< the hint's direction, unit, or zero for none
    const FrameRow& frame;
    bool normals, oriented; ///< do the surfels have normals, and those a common sign?
    SumOptions options;     ///< of the sums at x
    Moments<T, O> moments{};
    KeptSheet<T> sheet{};
    Jet<T, O> inverseWeight{};
    JetVec<T, O> centroid{}, d{}; ///< c relative to where x is; x - c
    T agreement = 1;              ///< |m|/w; 1 without normals

    Neighbourhood(const Source& source_, ClusterSpan clusters_, const base::Vec3<T>& x_, const OrientationHint& hint)
        : source(source_), clusters(clusters_), x(x_), side(base::normalized(base::cast<double>(hint.direction))),
          frame(rowOf(source_.surface().effectiveFrame())), normals(source_.surface().tree().layout()->normals),
          oriented(normals && source_.surface().tree().layout()->oriented) {
        options.weight = definition().weight;
        options.interpolating = definition().interpolating;
        options.scale = source.surface().supportScale();
        options.shape = surfel::shapeChannel(*source.surface().tree().layout());
        options.outer = frame.outer;
    }

    const SurfaceDefinition& definition() const { return source.surface().definition(); }
    base::Vec3<T> centroidPosition() const { return x + valueOf(centroid); }

    /// Are near sheets put together as two solids?
    bool tellsSolids() const { return oriented && definition().oneSheet && frame.solids; }
    /// Tells near sheets apart. REQUIRES: sums of some weight.
    void keepOneSheet() {
        agreement = normals ? agreementOf(moments) : T(1);
        if (!oriented || !definition().oneSheet || tellsSolids())
            return;
        sheet = surface::keepOneSheet(clusters, x, side, options, moments);
        if (sheet.another)
            agreement = agreementOf(moments);
    }
    /// c = sum theta p / w and d = x - c.
    void centre() {
        inverseWeight = inverse(moments.one);
        centroid = moments.q * inverseWeight;
        for (std::size_t a = 0; a < 3; ++a) {
            d[a] = -centroid[a];
            if constexpr (O >= 1)
                d[a] += coordinate<T, O>(int(a));
        }
    }
};

} // namespace surface
