// A seam rounded by a ball that rolls along it and touches both surfaces, or cut flat from one touch to the other: a
// chamfer (solid/README 2.6).
//
//     Fillet fillet(model, operand, ...)     the way of the ball's middle, traced by heights; refused where none fits
//     fillet.cover(...)                      which surfels the ball takes away
//     fillet.places()                        samples of what it leaves instead
//
// Immutable after construction; any number of threads may ask.
#pragma once

#include "core/process/resampling/point_grid.h"
#include "core/solid/seam.h"

namespace solid {

/// Where the ball rolls: on the outside of a surface, or on its inside.
struct FilletSides {
    const Side &model, &operand;
    bool outsideModel = true, outsideOperand = true;
    bool flat = false; ///< a chamfer
    /// The solid's normals lead to the ball's middle, as in the corner of a union; else away from it.
    bool concave() const { return outsideModel && outsideOperand; }
};

struct FilletPlace {
    base::Vec3d position, normal;   ///< the solid's outward unit normal
    base::Vec3d onModel, onOperand; ///< where the ball touches them
    double across = 0;              ///< 0 at the model to 1 at the operand

    double chord() const { return base::distance(onModel, onOperand); }
    double spacing = 0;
};

class Fillet {
  public:
    /// `spacingAt`: of surfels about a place. Throws base::Error, naming a place, where no ball of that radius rolls
    /// along the whole seam: it does not close, turns a corner, or bends more sharply than the ball.
    Fillet(const FilletSides& sides, double radius, const std::vector<SeamCurve>& seams,
           const std::function<double(const base::Vec3d&)>& spacingAt);
    Fillet(const Fillet&) = delete;
    Fillet& operator=(const Fillet&) = delete;

    enum class Cover : std::uint8_t {
        Away, ///< not near the fillet
        Beside,
        Taken ///< between the seam and where the ball touches
    };
    /// `normal`: outwards, of that surface at x.
    Cover cover(bool ofOperand, const base::Vec3d& x, const base::Vec3d& normal) const;
    /// Is x so near to where the ball touches that surface that a chamfer's edge is beside it?
    bool besideEdge(bool ofOperand, const base::Vec3d& x, const base::Vec3d& normal) const;

    /// About one spacing apart, from where the ball touches one surface to where it touches the other.
    std::vector<FilletPlace> places() const;
    /// The places where it touches both.
    std::vector<FilletPlace> contacts() const;

  private:
    struct Station {
        SeamPoint middle;      ///< of the ball
        base::Vec3d touch[2];  ///< the model, the operand
        base::Vec3d toSeam[2]; ///< unit, along either surface
        double reach = 0;      ///< from a touch to the seam at most
        double spacing = 0;
    };
    using Way = std::vector<Station>; ///< closed

    /// The nearest place of the ball's way, for x on one of the surfaces; null where none is near.
    const Station* stationNear(bool ofOperand, const base::Vec3d& x, const base::Vec3d& normal) const;
    TwoSides heights() const;
    Station station(const SeamPoint& middle, double spacing) const;
    static double farthestTouch(const Station& station, const std::vector<SeamCurve>& seams);
    Way wayAlong(const SeamCurve& spine, const std::function<double(const base::Vec3d&)>& spacingAt) const;
    base::Vec3d towards(const SeamPoint& middle, double across) const;
    FilletPlace place(const Station& station, double across) const;
    void rows(const Way& way, std::vector<FilletPlace>& out) const;

    FilletSides m_sides;
    double m_radius;
    std::vector<Way> m_ways;
    std::vector<const Station*> m_stations;
    process::PointGrid m_touches[2];
    double m_reach = 0;
};

} // namespace solid
