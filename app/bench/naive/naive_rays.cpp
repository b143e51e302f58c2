#include "app/bench/naive/naive_rays.h"

#include "app/bench/naive/naive_cloud.h"
#include "core/base/error.h"

#include <embree3/rtcore.h>

namespace bench {

namespace {

/// Of discs, in units of h: cover the surface between neighbours 0.4 h apart, with room for uneven spacing.
constexpr float discRadius = 0.4f;
/// A Newton step of so many h leaves an error of about its square: 1e-5 h.
constexpr double lastStep = 3e-3;
/// Beyond a disc without a root, in units of h.
constexpr double skip = 0.25;
/// Slopes below are grazing; ours asks for as much of the frame.
constexpr double leastSlope = 0.05;
constexpr int mostDiscs = 12, mostSteps = 8;

/// Null where the steps leave the surface.
NaiveHit settle(const NaiveSurface& surface, const base::Rayd& ray, double start, double from) {
    double t = start;
    for (int i = 0; i < mostSteps; ++i) {
        const NaiveEvaluation at = surface.evaluate(ray.at(t), surface::Need::Gradient);
        const double slope = dot(at.gradient, ray.direction);
        if (!at.valid || std::abs(slope) < leastSlope)
            break;
        const double step = -at.value / slope;
        t += step;
        if (std::abs(t - start) > at.unit || t < from)
            break;
        if (std::abs(step) < lastStep * at.unit)
            return {t, base::normalized(at.gradient)};
    }
    return {};
}

} // namespace

struct NaiveRays::Discs {
    // No "threads=1": Embree would hold all of oneTBB to one thread, ours too, as long as the device lives.
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = nullptr;
    std::vector<float> supports;

    explicit Discs(const NaiveCloud& cloud) {
        if (!device)
            throw base::Error("Embree cannot be started", "bench", "use a machine that it supports");
        const std::size_t count = cloud.size();
        RTCGeometry discs = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT);
        auto* at = static_cast<float*>(
            rtcSetNewGeometryBuffer(discs, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), count));
        auto* up = static_cast<float*>(
            rtcSetNewGeometryBuffer(discs, RTC_BUFFER_TYPE_NORMAL, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), count));
        for (const NaiveCloud::Bucket& bucket : cloud.buckets())
            for (const surfel::Surfel& s : bucket.surfels) {
                for (const float v : {s.position.x, s.position.y, s.position.z, discRadius * s.support})
                    *at++ = v;
                for (const float v : {s.normal.x, s.normal.y, s.normal.z})
                    *up++ = v;
                supports.push_back(s.support);
            }
        rtcCommitGeometry(discs);
        scene = rtcNewScene(device);
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
        rtcAttachGeometry(scene, discs);
        rtcReleaseGeometry(discs);
        rtcCommitScene(scene);
    }
    ~Discs() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    /// The first disc beyond `from`: where, and its h; none where the distance is infinite.
    std::pair<double, double> first(const base::Rayd& ray, double from) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query{};
        query.ray.org_x = static_cast<float>(ray.origin.x), query.ray.dir_x = static_cast<float>(ray.direction.x);
        query.ray.org_y = static_cast<float>(ray.origin.y), query.ray.dir_y = static_cast<float>(ray.direction.y);
        query.ray.org_z = static_cast<float>(ray.origin.z), query.ray.dir_z = static_cast<float>(ray.direction.z);
        query.ray.tnear = static_cast<float>(from), query.ray.tfar = std::numeric_limits<float>::infinity();
        query.ray.mask = ~0u;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
            return {std::numeric_limits<double>::infinity(), 0};
        return {static_cast<double>(query.ray.tfar), static_cast<double>(supports[query.hit.primID])};
    }
};

NaiveRays::NaiveRays(const NaiveSurface& surface)
    : m_surface(surface), m_discs(std::make_unique<Discs>(surface.cloud())) {}
NaiveRays::~NaiveRays() = default;

NaiveHit NaiveRays::intersect(const base::Rayd& ray) const {
    double from = 0;
    for (int i = 0; i < mostDiscs; ++i) {
        const auto [start, h] = m_discs->first(ray, from);
        if (!(start < std::numeric_limits<double>::infinity()))
            return {};
        if (const NaiveHit hit = settle(m_surface, ray, start, 0); hit.t < std::numeric_limits<double>::infinity())
            return hit;
        from = start + skip * h;
    }
    return {};
}

} // namespace bench
