// A curve through control points, as a person draws it for a falloff or for the pressure of a pen.
//
// Monotone piecewise cubic ([Fritsch80], with the harmonic slopes of [Fritsch84]): through
// all points, with a continuous slope, and between two points never above or below both of them. Two points make a
// straight line. Beyond the first and the last point the curve is constant.
#pragma once

#include <span>
#include <vector>

namespace sculpt {

struct CurvePoint {
    float x = 0, y = 0; ///< both 0 to 1
    bool operator==(const CurvePoint&) const = default;
};
using CurvePoints = std::vector<CurvePoint>;

class BrushCurve {
  public:
    static constexpr std::size_t maxPoints = 16;
    static constexpr float minGap = 1e-3f; ///< of two points' x

    /// Throws base::Error naming the curve `name` for fewer than 2 or more than 16 points, numbers outside 0 to 1, or
    /// an x that is not at least `minGap` beyond the one before.
    explicit BrushCurve(std::span<const CurvePoint> points, const char* name = "curve");

    float value(float x) const;
    /// The exact derivative of `value`; 0 beyond the ends.
    float slope(float x) const;

  private:
    /// y + b t + c t^2 + d t^3 with t = x - from, up to the next piece's `from`.
    struct Piece {
        float from, y, b, c, d;
    };
    const Piece& piece(float x) const;
    std::vector<Piece> m_pieces; ///< the last one is the constant beyond the end
    float m_first, m_last;       ///< x of the first and the last point
};

} // namespace sculpt
