// Polylines on the surface in a file. OBJ: `v` and `vn` for every point, then one `l`, which a closed one ends where it
// began. CSV: a row for every point, lines counted from 0, in the order along them. Numbers carry 17 digits, since such
// curves are traced in float64.
#pragma once

#include "app/csv_writer.h"
#include "core/io/safe_file.h"

#include <charconv>
#include <string>
#include <vector>

namespace app {

constexpr int curveDigits = 17;

/// A Point has position and normal. `before`: vertices in the file so far; `origin` is added to positions.
template <class Point>
std::string objPolyline(const std::vector<Point>& points, bool closed, std::size_t before, const base::Vec3d& origin) {
    const auto row = [](const char* key, const base::Vec3d& v) {
        std::string text = key;
        for (std::size_t k = 0; k < 3; ++k) {
            char number[40];
            const auto end =
                std::to_chars(number, number + sizeof number, v[k], std::chars_format::general, curveDigits);
            text.append(1, ' ').append(number, end.ptr);
        }
        return text + '\n';
    };
    std::string out;
    for (const Point& p : points)
        out += row("v", p.position + origin) + row("vn", p.normal);
    out += 'l';
    for (std::size_t i = 1; i <= points.size(); ++i)
        out += ' ' + std::to_string(before + i);
    if (closed)
        out += ' ' + std::to_string(before + 1);
    return out + '\n';
}

/// OBJ where the file's name ends so, else CSV with this head line: number, closed, position, normal, and what `more`
/// appends of a point. A Line has points and closed.
template <class Line, class More>
void writePolylines(const std::string& target, const std::vector<Line>& all, const base::Vec3d& origin,
                    const char* head, const More& more) {
    io::SafeFile file(target);
    if (target.ends_with(".obj")) {
        std::size_t before = 0;
        for (const Line& line : all) {
            file.write(objPolyline(line.points, line.closed, before, origin));
            before += line.points.size();
        }
    } else {
        CsvWriter csv(curveDigits);
        file.write(head);
        for (std::size_t i = 0; i < all.size(); ++i)
            for (const auto& p : all[i].points) {
                csv.integer(static_cast<long long>(i)).integer(all[i].closed ? 1 : 0);
                csv.vector(p.position + origin).vector(p.normal);
                more(csv, p);
                csv.endRow();
            }
        file.write(csv.take());
    }
    file.commit();
}

} // namespace app
