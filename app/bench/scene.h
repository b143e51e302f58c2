// What workloads run on: a model, and positions and rays around it. Made when first asked for and kept.
//
// Used by one thread. Everything follows from the model and fixed seeds.
#pragma once

#include "core/surface/surface.h"

#include <memory>

namespace bench {

class NaiveRays;
class NaiveSurface;

struct SceneOptions {
    std::size_t points = 1'000'000;
    /// Standard deviation of every coordinate, in percent of the model's radius.
    double noisePercent = 0.02;
    bool operator==(const SceneOptions&) const = default;
};

class Scene {
  public:
    /// The cloud of all figures: a bumpy closed surface of about unit radius, evenly sampled, oriented, 20 neighbours
    /// in support.
    explicit Scene(const SceneOptions& options, const base::Progress& progress = {});
    /// A model's own points and supports, under the definition that the naive ways speak: summed normals, Wendland.
    explicit Scene(const surface::Surface& model);
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    const surface::Surface& surface() const { return m_surface; }
    std::size_t size() const { return m_surface.tree().size(); }
    /// The surfels in no order, as a file brings them.
    const surfel::SurfelList& unsorted();
    /// Positions up to 0.3 h away from surfels, along a space-filling curve or in no order.
    std::span<const base::Vec3f> coherent();
    std::span<const base::Vec3f> scattered();
    /// 256 x 256 rays of a view from outside that shows the whole model, row by row.
    std::span<const base::Rayf> cameraRays();
    /// As many from all sides to anywhere inside.
    std::span<const base::Rayf> randomRays();
    /// Places on the model for brushes: surfels spread over it.
    std::vector<surfel::Surfel> places(std::size_t count);
    /// nanoflann and Eigen over the same surfels; Embree with them.
    const NaiveSurface& naive();
    const NaiveRays& naiveRays();

    base::Vec3d centre() const;
    /// Half the longest edge of the model's box.
    double radius() const;

  private:
    surface::Surface m_surface;
    surfel::SurfelList m_unsorted;
    std::vector<base::Vec3f> m_coherent, m_scattered;
    std::vector<base::Rayf> m_camera, m_random;
    std::unique_ptr<NaiveSurface> m_naive;
    std::unique_ptr<NaiveRays> m_naiveRays;
};

/// Points of the bumpy surface, in an order that hops all over it.
surfel::SurfelList bumpyPoints(const SceneOptions& options, const base::Progress& progress = {});

} // namespace bench
