#include "app/bench/naive_file.h"

#include "app/bench/naive_cloud.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>

namespace bench {

std::vector<surfel::Surfel> naiveLoad(const PointFile& file) {
    std::ifstream in(file.path, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(file.header));
    std::vector<char> bytes(file.points * PointFile::bytesPerPoint);
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    std::vector<surfel::Surfel> out(file.points);
    const char* at = bytes.data();
    for (surfel::Surfel& s : out) {
        unsigned char rgb[3];
        std::memcpy(&s.position, at, 12);
        std::memcpy(&s.normal, at + 12, 12);
        std::memcpy(rgb, at + 24, 3);
        s.colour = surfel::rgba(rgb[0], rgb[1], rgb[2]);
        at += PointFile::bytesPerPoint;
    }
    return out;
}

std::vector<surfel::Surfel> naiveOpen(const PointFile& file, double neighbours) {
    constexpr std::size_t ring = 6;
    const std::vector<surfel::Surfel> loaded = naiveLoad(file);
    std::vector<surfel::Surfel> sorted;
    NaivePoints points;
    for (const std::uint32_t i : mortonOrder(loaded)) {
        sorted.push_back(loaded[i]);
        points.at.push_back(loaded[i].position);
    }
    const NaiveStaticIndex index(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(naiveLeaf));
    for (surfel::Surfel& s : sorted) {
        std::uint32_t found[ring + 1];
        float distanceSq[ring + 1];
        const std::size_t count = index.knnSearch(&s.position.x, ring + 1, found, distanceSq);
        double sum = 0;
        for (std::size_t k = 1; k < count; ++k)
            sum += std::sqrt(static_cast<double>(distanceSq[k]));
        const double spacing = 0.93 * sum / static_cast<double>(ring);
        s.support = static_cast<float>(spacing * std::sqrt(neighbours / std::numbers::pi));
    }
    const NaiveCloud cloud(sorted);
    return sorted;
}

} // namespace bench
