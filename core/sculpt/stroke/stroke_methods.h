// The ways of making dabs from samples, one class each behind one small interface.
//
//     Space      dabs `spacing` radii apart, measured between contacts on the surface. Between two samples the rays are
//                interpolated and each dab's ray is intersected with the version that the dab works on; rays that miss
//                make none.
//     Dots       a dab at the contact of every sample.
//     Airbrush   the first dab at the first contact; dab k is k / rate seconds later, where the pointer was then.
//     Anchored   every sample begins anew: one dab at the first contact on the straight way from the first sample to
//                this one, whose radius reaches to the pointer in the plane through the contact that faces the viewer.
//     Line       every sample begins anew: Space from the first sample straight to this one.
//     Drag       the first contact is held and carried along in the plane through it that faces the viewer, in steps of
//                a tenth of the radius or less; pressure has no say (tools that hold, whatever the method). A pointer
//                that has a place in space (StrokeSample::reach) is followed there instead.
//     Turn       the first contact is held; the angle by which the pointer goes around it, as the viewer sees it, comes
//                in steps of a tenth of a radian.
//
// All depend on the samples alone, so that a recorded stroke replays bit for bit.
#pragma once

#include "core/sculpt/stroke/stroke_dabs.h"

namespace sculpt {

class Method {
  public:
    virtual ~Method() = default;
    /// REQUIRES: a checked sample, direction of unit length. `moved`: false where the stabiliser's rope hung slack.
    virtual void add(const StrokeSample& sample, bool moved) = 0;
    /// Whether the stroke would make dabs if it ended here.
    virtual bool waits() const { return false; }
    /// These dabs, to be shown until then; none where nothing waits.
    virtual std::vector<Dab> waiting() const { return {}; }
    /// Dabs that were waiting for more.
    virtual void finish() {}
};

/// `dabs` outlives the method.
std::unique_ptr<Method> makeMethod(Dabs& dabs, Motion motion);

std::unique_ptr<Method> makeSpace(Dabs& dabs);
/// The same, begun with a dab at a sample whose contact is known.
std::unique_ptr<Method> makeSpace(Dabs& dabs, const StrokeSample& first, const Contact& at);
std::unique_ptr<Method> makeDots(Dabs& dabs);
std::unique_ptr<Method> makeAirbrush(Dabs& dabs);
std::unique_ptr<Method> makeAnchored(Dabs& dabs);
std::unique_ptr<Method> makeLine(Dabs& dabs);
std::unique_ptr<Method> makeDrag(Dabs& dabs);
std::unique_ptr<Method> makeTurn(Dabs& dabs);

/// Steps between two samples: a bound for rays that sweep far beyond the model.
constexpr int mostProbes = 4096;

} // namespace sculpt
