#include "app/polyline_formats.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace app {

using base::Vec3d;

namespace {

void appendNumber(std::string& out, double value) {
    char number[40];
    const auto end = std::to_chars(number, number + sizeof number, value, std::chars_format::general, curveDigits);
    out.append(number, end.ptr);
}

/// `v` and `vn` for every point, then one `l`, which a closed line ends where it began.
std::string objText(const std::vector<Polyline>& lines, const DrawingFrame&) {
    std::string out;
    const auto row = [&](const char* key, const Vec3d& v) {
        out += key;
        for (std::size_t k = 0; k < 3; ++k)
            appendNumber(out += ' ', v[k]);
        out += '\n';
    };
    std::size_t before = 0;
    for (const Polyline& line : lines) {
        const std::size_t n = line.positions.size();
        for (std::size_t i = 0; i < n; ++i) {
            row("v", line.positions[i]);
            row("vn", line.normals[i]);
        }
        out += 'l';
        for (std::size_t i = 1; i <= n; ++i)
            out += ' ' + std::to_string(before + i);
        if (line.closed)
            out += ' ' + std::to_string(before + 1);
        out += '\n';
        before += n;
    }
    return out;
}

/// Pairs of a group code and its value, a line each: release 12, which every CAD program reads. A line is a 3D
/// POLYLINE.
std::string dxfText(const std::vector<Polyline>& lines, const DrawingFrame&) {
    constexpr int closedLine = 1, lineInSpace = 8, pointInSpace = 32;
    std::string out = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
    for (const Polyline& line : lines) {
        out += "0\nPOLYLINE\n8\n0\n66\n1\n10\n0\n20\n0\n30\n0\n70\n";
        out += std::to_string(lineInSpace | (line.closed ? closedLine : 0)) + '\n';
        for (const Vec3d& p : line.positions) {
            appendNumber(out += "0\nVERTEX\n8\n0\n10\n", p.x);
            appendNumber(out += "\n20\n", p.y);
            appendNumber(out += "\n30\n", p.z);
            out += "\n70\n" + std::to_string(pointInSpace) + '\n';
        }
        out += "0\nSEQEND\n8\n0\n";
    }
    return out + "0\nENDSEC\n0\nEOF\n";
}

/// One unit of the drawing is one of the model. Its corner is its zero, since viewers count in float32: far coordinates
/// stand in the description.
std::string svgText(const std::vector<Polyline>& lines, const DrawingFrame& frame) {
    constexpr double margin = 0.02, stroke = 0.002; // of the diagonal
    double left = 0, right = 0, top = 0, bottom = 0;
    bool first = true;
    for (const Polyline& line : lines)
        for (const Vec3d& p : line.positions) {
            const double x = dot(p, frame.right), y = -dot(p, frame.up); // down, as pictures count
            left = first ? x : std::min(left, x);
            right = first ? x : std::max(right, x);
            top = first ? y : std::min(top, y);
            bottom = first ? y : std::max(bottom, y);
            first = false;
        }
    const double width = right - left, height = bottom - top;
    const double diagonal = width + height > 0 ? std::hypot(width, height) : 1; // no curves: an empty sheet
    const double edge = margin * diagonal;
    std::string out =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
    for (const double value : {-edge, -edge, width + 2 * edge, height + 2 * edge}) {
        appendNumber(out, value);
        out += ' ';
    }
    out.back() = '"';
    out += ">\n<desc>A unit is a unit of the model. Zero is where the products with";
    const auto vector = [&](const Vec3d& v) {
        for (std::size_t k = 0; k < 3; ++k)
            appendNumber(out += k == 0 ? " (" : ", ", v[k]);
        out += ')';
    };
    vector(frame.right);
    out += " and";
    vector(-frame.up);
    appendNumber(out += " are ", left);
    appendNumber(out += " and ", top);
    out += ".</desc>\n<g fill=\"none\" stroke=\"black\" stroke-linejoin=\"round\" stroke-width=\"";
    appendNumber(out, stroke * diagonal);
    out += "\">\n";
    for (const Polyline& line : lines) {
        out += "<path d=\"";
        char step = 'M';
        for (const Vec3d& p : line.positions) {
            appendNumber(out += step, dot(p, frame.right) - left);
            appendNumber(out += ' ', -dot(p, frame.up) - top);
            step = 'L';
        }
        out += line.closed ? "Z\"/>\n" : "\"/>\n";
    }
    return out + "</g>\n</svg>\n";
}

constexpr PolylineFormat formats[] = {
    {".csv", false, "CSV rows", nullptr},
    {".obj", false, "polylines in OBJ", objText},
    {".dxf", false, "3D polylines in DXF (release 12)", dxfText},
    {".svg", true, "a drawing of the plane in SVG, a unit of the model each", svgText},
};

} // namespace

DrawingFrame drawingFrame(const Vec3d& normal, base::UpAxis up) {
    constexpr double level = 0.999; // the product of normal and up from which on the plane has no upright direction
    const base::UpRow& axes = base::upRow(up);
    const Vec3d upright = std::abs(dot(normal, axes.up)) < level ? axes.up : -axes.front;
    const Vec3d drawn = base::normalized(upright - normal * dot(normal, upright));
    return {cross(drawn, normal), drawn};
}

std::span<const PolylineFormat> polylineFormats() {
    return formats;
}

const PolylineFormat* polylineFormatOf(std::string_view file, bool planar) {
    for (const PolylineFormat& row : formats)
        if (file.ends_with(row.ending) && (planar || !row.planar))
            return &row;
    return nullptr;
}

std::string polylineEndings(bool planar) {
    std::string out;
    std::vector<std::string_view> endings;
    for (const PolylineFormat& row : formats)
        if (planar || !row.planar)
            endings.push_back(row.ending);
    for (std::size_t i = 0; i < endings.size(); ++i) {
        if (i > 0)
            out += i + 1 == endings.size() ? " or " : ", ";
        out += endings[i];
    }
    return out;
}

} // namespace app
