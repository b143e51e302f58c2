#include "core/process/measuring/detect_shapes.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/measuring/shape_cloud.h"

#include <algorithm>
#include <cmath>

namespace process {

using base::Vec3d;

namespace {

/// Starts of a round; judges of a start; starts of each kind that are looked at in full; rounds without a shape.
constexpr std::size_t startsOfRound = 1500, judgesOfRound = 500, followed = 3, idleRounds = 4;

class Detector {
  public:
    Detector(const ShapeCloud& cloud, const DetectWish& wish, std::size_t fewest, const base::Progress& progress)
        : m_cloud(cloud), m_wish(wish), m_fewest(fewest), m_progress(progress), m_shapeOf(cloud.size(), 0),
          m_left(cloud.size(), 1) {}

    void run();
    /// Points beside each other exchange the shape that one of them fits better.
    void settle();
    DetectedShapes result(std::size_t listed) const;

  private:
    struct Candidate {
        Primitive primitive;
        std::size_t score = 0, start = 0;
    };
    struct Taken {
        Primitive primitive;
        std::vector<std::uint32_t> points;
    };

    std::vector<std::uint32_t> open() const;
    double done(std::span<const std::uint32_t> open) const {
        return 1 - static_cast<double>(open.size()) / static_cast<double>(m_cloud.size());
    }
    std::uint32_t walked(std::uint32_t from, int steps, base::Random& random) const;
    void tryStart(std::span<const std::uint32_t> open, std::span<const std::uint32_t> judges, std::size_t number,
                  std::span<Candidate> out) const;
    std::vector<Candidate> candidates(std::span<const std::uint32_t> open) const;
    Taken followUp(const Primitive& start, std::span<const std::uint32_t> open) const;
    Taken bestOf(const std::vector<Candidate>& found, std::span<const std::uint32_t> open) const;

    const ShapeCloud& m_cloud;
    const DetectWish& m_wish;
    const std::size_t m_fewest;
    const base::Progress& m_progress;
    std::vector<std::uint32_t> m_shapeOf;
    std::vector<std::uint8_t> m_left;
    std::vector<Primitive> m_found;
    std::size_t m_round = 0;
};

std::vector<std::uint32_t> Detector::open() const {
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < m_left.size(); ++i)
        if (m_left[i])
            out.push_back(i);
    return out;
}

/// Over open neighbours, always those farthest along one way: as many steps as wanted, fewer at an end.
std::uint32_t Detector::walked(std::uint32_t from, int steps, base::Random& random) const {
    const Vec3d way = random.unitVector();
    NeighbourTable::Row row;
    for (int step = 0; step < steps; ++step) {
        std::uint32_t next = from;
        double most = 0;
        for (const std::uint32_t j : m_cloud.near(from, row)) {
            const double along = dot(m_cloud.point(j).position - m_cloud.point(from).position, way);
            if (m_left[j] && along > most)
                next = j, most = along;
        }
        if (next == from)
            break;
        from = next;
    }
    return from;
}

/// A shape of each kind through points that are as near to each other as chance decides.
void Detector::tryStart(std::span<const std::uint32_t> open, std::span<const std::uint32_t> judges, std::size_t number,
                        std::span<Candidate> out) const {
    constexpr int scales = 7; // to 64 steps
    base::Random random(m_round * startsOfRound + number + 1);
    const std::uint32_t first = open[random.below(open.size())];
    const int steps = 1 << random.below(scales);
    std::vector<std::uint32_t> chosen{first};
    for (int k = 1; k < 7; ++k)
        chosen.push_back(walked(first, 1 + static_cast<int>(random.below(static_cast<std::size_t>(steps))), random));
    std::vector<OrientedPoint> points;
    for (const std::uint32_t i : chosen)
        points.push_back(m_cloud.point(i));
    for (std::size_t k = 0; k < m_wish.shapes.size(); ++k) {
        const Shape shape = m_wish.shapes[k];
        const std::size_t needed = startPoints(shape);
        const auto made = startFrom(shape, std::span(points).first(needed));
        if (!made || !std::isfinite(made->radius) || !std::isfinite(lengthSq(made->place)))
            continue;
        const bool fits = std::all_of(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(needed),
                                      [&](std::uint32_t i) { return m_cloud.misfit(*made, i) < 1; });
        if (!fits)
            continue;
        Candidate& each = out[k];
        each.primitive = *made;
        each.start = first;
        for (const std::uint32_t i : judges)
            each.score += m_cloud.misfit(*made, i) < 1;
    }
}

std::vector<Detector::Candidate> Detector::candidates(std::span<const std::uint32_t> open) const {
    base::Random random(~m_round);
    std::vector<std::uint32_t> judges;
    for (std::size_t k = 0; k < std::min(judgesOfRound, open.size()); ++k)
        judges.push_back(open[random.below(open.size())]);
    const std::size_t kinds = m_wish.shapes.size();
    std::vector<Candidate> all(startsOfRound * kinds), out;
    constexpr std::size_t batch = 250; // between two looks at the flag
    for (std::size_t from = 0; from < startsOfRound; from += batch) {
        m_progress.step(done(open), "Looking for shapes");
        base::parallelFor(batch, 16, [&](std::size_t k) {
            tryStart(open, judges, from + k, std::span(all).subspan((from + k) * kinds, kinds));
        });
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) { // the best ones of each
        std::vector<Candidate> own;
        for (std::size_t k = kind; k < all.size(); k += kinds)
            if (all[k].score > 0)
                own.push_back(all[k]);
        std::stable_sort(own.begin(), own.end(), [](const auto& a, const auto& b) { return a.score > b.score; });
        own.resize(std::min(own.size(), followed));
        out.insert(out.end(), own.begin(), own.end());
    }
    return out;
}

/// Fitted to what is on it, until that grows no more.
Detector::Taken Detector::followUp(const Primitive& start, std::span<const std::uint32_t> open) const {
    constexpr int rounds = 3;
    Taken out{start, m_cloud.pieceOn(start, open)};
    for (int round = 0; round < rounds && out.points.size() >= 10; ++round) {
        const Primitive next = m_cloud.fitted(out.primitive, out.points);
        std::vector<std::uint32_t> points = m_cloud.pieceOn(next, open);
        const bool grows = points.size() > out.points.size() + out.points.size() / 50;
        if (points.size() >= out.points.size())
            out = {next, std::move(points)};
        if (!grows)
            break;
    }
    return out;
}

/// The one of most points; of those that have nearly as many the simplest kind, as a flat patch is on large spheres,
/// too.
Detector::Taken Detector::bestOf(const std::vector<Candidate>& found, std::span<const std::uint32_t> open) const {
    constexpr double nearly = 0.92;
    std::vector<Taken> taken;
    std::size_t most = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        m_progress.step(done(open), "Looking for shapes");
        Taken each = followUp(found[k].primitive, open);
        if (each.primitive.shape != Shape::Plane && !m_cloud.bends(each.primitive, each.points))
            continue;
        taken.push_back(std::move(each));
        most = std::max(most, taken.back().points.size());
    }
    const Taken* best = nullptr;
    for (const Taken& each : taken) {
        if (each.points.empty() || static_cast<double>(each.points.size()) < nearly * static_cast<double>(most))
            continue;
        const bool simpler = best && each.primitive.shape < best->primitive.shape;
        const bool larger =
            best && each.primitive.shape == best->primitive.shape && each.points.size() > best->points.size();
        if (!best || simpler || larger)
            best = &each;
    }
    return best ? *best : Taken{};
}

void Detector::run() {
    std::size_t idle = 0;
    for (; idle < idleRounds; ++m_round) {
        const std::vector<std::uint32_t> open = this->open();
        if (open.size() < m_fewest)
            return;
        Taken best = bestOf(candidates(open), open);
        if (best.points.size() < m_fewest) {
            ++idle;
            continue;
        }
        idle = 0;
        m_found.push_back(best.primitive);
        for (const std::uint32_t i : best.points) {
            m_left[i] = 0;
            m_shapeOf[i] = static_cast<std::uint32_t>(m_found.size());
        }
    }
}

void Detector::settle() {
    constexpr int passes = 3;
    for (int pass = 0; pass < passes; ++pass) {
        const std::vector<std::uint32_t> before = m_shapeOf;
        base::parallelFor(m_cloud.size(), 1024, [&](std::size_t i) {
            NeighbourTable::Row row;
            const auto misfitTo = [&](std::uint32_t shape) {
                return shape == 0 ? 1 : m_cloud.misfit(m_found[shape - 1], i);
            };
            double least = std::min(misfitTo(before[i]), 1.0);
            for (const std::uint32_t j : m_cloud.near(i, row))
                if (before[j] != before[i])
                    if (const double other = misfitTo(before[j]); other < least)
                        least = other, m_shapeOf[i] = before[j];
        });
    }
}

DetectedShapes Detector::result(std::size_t listed) const {
    DetectedShapes out;
    out.fewest = m_fewest;
    std::vector<std::vector<std::uint32_t>> points(m_found.size());
    for (std::uint32_t i = 0; i < m_shapeOf.size(); ++i)
        if (m_shapeOf[i] > 0)
            points[m_shapeOf[i] - 1].push_back(i);
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (points[k].size() * 2 >= m_fewest) // the rest of what went to others
            order.push_back(k);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return points[a].size() > points[b].size(); });
    std::vector<std::uint32_t> number(m_found.size() + 1, 0);
    for (const std::size_t k : order) {
        out.shapes.push_back(m_cloud.told(m_cloud.fitted(m_found[k], points[k]), points[k]));
        out.shapes.back().points = 0; // counted among all that are listed
        number[k + 1] = static_cast<std::uint32_t>(out.shapes.size());
    }
    for (std::size_t k = 0; k < listed; ++k) {
        out.shapeOf.push_back(number[m_shapeOf[m_cloud.placeOf(k)]]);
        if (out.shapeOf.back() > 0)
            ++out.shapes[out.shapeOf.back() - 1].points;
    }
    return out;
}

} // namespace

DetectedShapes detectShapes(const surfel::SurfelList& points, const DetectWish& wish, const base::Progress& progress) {
    constexpr std::size_t least = 50, share = 100;
    const ShapeCloud cloud(points, wish, part(progress, 0, 0.3));
    const std::size_t fewest = wish.fewest > 0 ? wish.fewest : std::max(least, cloud.size() / share);
    const base::Progress looking = part(progress, 0.3, 1);
    Detector detector(cloud, wish, fewest, looking);
    detector.run();
    detector.settle();
    return detector.result(points.size());
}

} // namespace process
