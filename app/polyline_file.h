// Polylines on the surface in a file: a row of the table of formats, or CSV with a row for every point, lines counted
// from 0, in the order along them.
#pragma once

#include "app/csv_writer.h"
#include "app/polyline_formats.h"
#include "core/io/safe_file.h"

namespace app {

/// CSV has this head line: number, closed, position, normal, and what `more` appends of a point. A Line has points,
/// with position and normal, and closed; `origin` is added to positions. REQUIRES: the file's ending is in the table.
template <class Line, class More>
void writePolylines(const std::string& target, const std::vector<Line>& all, const base::Vec3d& origin,
                    const DrawingFrame& frame, const char* head, const More& more) {
    io::SafeFile file(target);
    if (const PolylineFormat* format = polylineFormatOf(target, true); format->text) {
        std::vector<Polyline> lines;
        for (const Line& line : all) {
            Polyline& out = lines.emplace_back();
            out.closed = line.closed;
            for (const auto& p : line.points) {
                out.positions.push_back(p.position + origin);
                out.normals.push_back(p.normal);
            }
        }
        file.write(format->text(lines, frame));
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
