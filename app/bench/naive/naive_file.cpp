#include "app/bench/naive/naive_file.h"

#include "app/bench/naive/naive_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <Eigen/Eigenvalues>
#include <fstream>
#include <numbers>
#include <numeric>
#include <queue>

namespace bench {

std::vector<surfel::Surfel> naiveLoad(const PointFile& file) {
    std::ifstream in(file.path, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(file.header));
    std::vector<char> bytes(file.points * file.bytesPerPoint());
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    std::vector<surfel::Surfel> out(file.points);
    const char* at = bytes.data();
    for (surfel::Surfel& s : out) {
        unsigned char rgb[3];
        std::memcpy(&s.position, at, 12);
        if (file.normals)
            std::memcpy(&s.normal, at + 12, 12);
        std::memcpy(rgb, at + file.bytesPerPoint() - 3, 3);
        s.colour = surfel::rgba(rgb[0], rgb[1], rgb[2]);
        at += file.bytesPerPoint();
    }
    return out;
}

/// Points along the curve, and an index of them.
struct NaiveSorted {
    std::vector<surfel::Surfel> surfels;
    NaivePoints points;
    std::unique_ptr<NaiveStaticIndex> index;

    explicit NaiveSorted(const std::vector<surfel::Surfel>& loaded) {
        for (const std::uint32_t i : mortonOrder(loaded)) {
            surfels.push_back(loaded[i]);
            points.at.push_back(loaded[i].position);
        }
        index = std::make_unique<NaiveStaticIndex>(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(naiveLeaf));
    }
};

static float naiveSupport(const float* distanceSq, std::size_t ring, double neighbours) {
    double sum = 0;
    for (std::size_t k = 1; k <= ring; ++k)
        sum += std::sqrt(static_cast<double>(distanceSq[k]));
    const double spacing = 0.93 * sum / static_cast<double>(ring);
    return static_cast<float>(spacing * std::sqrt(neighbours / std::numbers::pi));
}

std::vector<surfel::Surfel> naiveOpen(const PointFile& file, double neighbours) {
    constexpr std::size_t ring = 6;
    NaiveSorted sorted(naiveLoad(file));
    for (surfel::Surfel& s : sorted.surfels) {
        std::uint32_t found[ring + 1];
        float distanceSq[ring + 1];
        const std::size_t count = sorted.index->knnSearch(&s.position.x, ring + 1, found, distanceSq);
        s.support = naiveSupport(distanceSq, std::min(ring, count - 1), neighbours);
    }
    const NaiveCloud cloud(sorted.surfels);
    return sorted.surfels;
}

/// Prim's tree: from the topmost point on, always along the edge with the most alike normals.
static void naiveOrient(std::vector<surfel::Surfel>& surfels, const std::vector<std::uint32_t>& links, std::size_t k) {
    struct Entry {
        float alike;
        std::uint32_t from, to;
        bool operator<(const Entry& other) const { return alike < other.alike; }
    };
    // Sparse places see dense ones that do not see them: links go both ways.
    std::vector<std::uint32_t> begin(surfels.size() + 1), back(links.size());
    for (const std::uint32_t j : links)
        ++begin[j];
    for (std::size_t i = 0; i < surfels.size(); ++i)
        begin[i + 1] += begin[i];
    for (std::size_t e = links.size(); e-- > 0;)
        back[--begin[links[e]]] = static_cast<std::uint32_t>(e / k);
    std::vector<bool> done(surfels.size());
    std::priority_queue<Entry> open;
    const auto leave = [&](std::uint32_t i) {
        done[i] = true;
        const auto push = [&](std::uint32_t j) {
            if (!done[j])
                open.push({std::abs(dot(surfels[i].normal, surfels[j].normal)), i, j});
        };
        std::for_each_n(links.begin() + static_cast<std::ptrdiff_t>(i * k), k, push);
        std::for_each(back.begin() + begin[i], back.begin() + begin[i + 1], push);
    };
    std::vector<std::uint32_t> order(surfels.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return surfels[a].position.z > surfels[b].position.z; });
    for (const std::uint32_t top : order) {
        if (done[top])
            continue;
        if (surfels[top].normal.z < 0)
            surfels[top].normal = -surfels[top].normal;
        leave(top);
        while (!open.empty()) {
            const Entry next = open.top();
            open.pop();
            if (done[next.to])
                continue;
            if (dot(surfels[next.from].normal, surfels[next.to].normal) < 0)
                surfels[next.to].normal = -surfels[next.to].normal;
            leave(next.to);
        }
    }
}

std::vector<surfel::Surfel> naiveOpenRaw(const PointFile& file, double neighbours) {
    constexpr std::size_t wanted = 19, linked = 12, ring = 6;
    NaiveSorted sorted(naiveLoad(file));
    const std::size_t k = std::min(linked, sorted.surfels.size() - 1);
    std::vector<std::uint32_t> links;
    links.reserve(sorted.surfels.size() * k);
    for (surfel::Surfel& s : sorted.surfels) {
        std::uint32_t found[wanted];
        float distanceSq[wanted];
        const std::size_t count = sorted.index->knnSearch(&s.position.x, wanted, found, distanceSq);
        links.insert(links.end(), found + 1, found + 1 + k);
        s.support = naiveSupport(distanceSq, std::min(ring, count - 1), neighbours);
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
        for (std::size_t n = 0; n < count; ++n) {
            const base::Vec3f p = sorted.points.at[found[n]] - s.position;
            const Eigen::Vector3d v(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
            mean += v;
            square += v * v.transpose();
        }
        square -= mean * mean.transpose() / static_cast<double>(count);
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
        solver.computeDirect(square);
        const Eigen::Vector3f normal = solver.eigenvectors().col(0).cast<float>();
        s.normal = {normal.x(), normal.y(), normal.z()};
    }
    naiveOrient(sorted.surfels, links, k);
    const NaiveCloud cloud(sorted.surfels);
    return sorted.surfels;
}

} // namespace bench
