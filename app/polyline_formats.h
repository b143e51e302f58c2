// The files that polylines on a surface are written to, a row each. All numbers carry 17 digits, since such curves are
// traced in float64, and never depend on the locale.
#pragma once

#include "core/base/up_axis.h"
#include "core/base/vec.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

constexpr int curveDigits = 17;

/// In file coordinates.
struct Polyline {
    std::vector<base::Vec3d> positions, normals; ///< as many of each
    bool closed = false;                         ///< the last point is joined to the first
};

/// How a drawing lies in space: seen from the side that right x up points to. Unit vectors.
struct DrawingFrame {
    base::Vec3d right{1, 0, 0}, up{0, 1, 0};
};

/// For a plane with that unit normal: upright where the plane is not level.
DrawingFrame drawingFrame(const base::Vec3d& normal, base::UpAxis up);

struct PolylineFormat {
    std::string_view ending; ///< ".obj"
    bool planar;             ///< a drawing in a plane; the others hold curves in space
    const char* tip;         ///< how `-o` tells of it
    /// The whole file; nothing for CSV, whose columns are the caller's. The frame is asked for only where planar.
    std::string (*text)(const std::vector<Polyline>& lines, const DrawingFrame& frame);
};

std::span<const PolylineFormat> polylineFormats();
/// Of the file's name; none where no row knows its ending, or where it is planar and `planar` is not.
const PolylineFormat* polylineFormatOf(std::string_view file, bool planar);
/// ".csv, .obj or .dxf"
std::string polylineEndings(bool planar);

} // namespace app
