// Real scans for the surface tests, from the folder that POINTCLAY_DATA names.
#pragma once

#include "core/surfel/surfel.h"
#include "support/registry.h"

#include <fstream>
#include <limits>
#include <QString>
#include <sstream>

namespace scans {

/// Positions of plain text, or of an ascii PLY whose vertices begin with x y z; none where there is no such file.
inline surfel::SurfelList positionsOf(const std::string& path) {
    std::ifstream in(path);
    std::string line;
    std::size_t count = std::numeric_limits<std::size_t>::max();
    if (in.peek() == 'p')
        while (std::getline(in, line) && line.rfind("end_header", 0) != 0)
            if (line.rfind("element vertex ", 0) == 0)
                count = std::stoul(line.substr(15));
    surfel::SurfelList out;
    while (out.size() < count && std::getline(in, line)) {
        std::istringstream words(line);
        surfel::Surfel s;
        if (words >> s.position.x >> s.position.y >> s.position.z)
            out.items.push_back(s);
    }
    return out;
}

/// Reads a scan of the folder; where there is none says why, for the test to skip with, else returns nullptr.
inline const char* load(const QString& file, surfel::SurfelList& out) {
    if (test::dataFolder().empty())
        return "POINTCLAY_DATA names no folder of scans";
    out = positionsOf(test::dataFolder() + "/" + file.toStdString());
    return out.items.empty() ? "no such scan in the folder" : nullptr;
}

/// What lies within `radius` of the position at `index`.
inline surfel::SurfelList patch(const surfel::SurfelList& list, std::size_t index, float radius) {
    surfel::SurfelList out;
    out.layout = list.layout;
    const base::Vec3f centre = list.items[index % list.size()].position;
    for (const surfel::Surfel& s : list.items)
        if (distance(s.position, centre) <= radius)
            out.items.push_back(s);
    return out;
}

} // namespace scans
