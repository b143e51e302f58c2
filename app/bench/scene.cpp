#include "app/bench/scene.h"

#include "app/bench/naive/naive_rays.h"
#include "core/base/random.h"

namespace bench {

using base::Rayf;
using base::Vec3d;
using base::Vec3f;

constexpr std::size_t raysPerEdge = 256;
/// Models up to this size have a query at every surfel, larger ones at every fourth.
constexpr std::size_t fewSurfels = 65536;

template <class T>
static void shuffle(std::vector<T>& list, std::uint64_t seed) {
    base::Random random(seed);
    for (std::size_t i = list.size(); i > 1; --i)
        std::swap(list[i - 1], list[random.below(i)]);
}

static surface::Surface bumpySurface(const SceneOptions& options, const base::Progress& progress) {
    surface::SurfaceDefinition definition;
    definition.neighbours = 20;
    const surfel::SurfelList points = bumpyPoints(options, progress);
    progress.step(1, "Building the tree");
    return {tree::SurfelTree::build(points), definition};
}

static surface::Surface plainlyDefined(const surface::Surface& model) {
    surface::SurfaceDefinition definition;
    definition.support = model.definition().support;
    definition.neighbours = model.definition().neighbours;
    definition.boundaryLimit = model.definition().boundaryLimit;
    return {model.tree(), definition};
}

Scene::Scene(const SceneOptions& options, const base::Progress& progress)
    : m_surface(bumpySurface(options, progress)) {}
Scene::Scene(const surface::Surface& model) : m_surface(plainlyDefined(model)) {}
Scene::~Scene() = default;

Vec3d Scene::centre() const {
    return base::cast<double>(m_surface.tree().bounds().centre());
}

double Scene::radius() const {
    const Vec3f size = m_surface.tree().bounds().size();
    return 0.5 * static_cast<double>(std::max({size.x, size.y, size.z}));
}

const surfel::SurfelList& Scene::unsorted() {
    if (m_unsorted.items.empty()) {
        m_unsorted = m_surface.tree().surfels();
        if (m_unsorted.extra.empty())
            shuffle(m_unsorted.items, 1);
    }
    return m_unsorted;
}

std::span<const Vec3f> Scene::coherent() {
    if (m_coherent.empty()) {
        base::Random random(2);
        const std::size_t stride = size() > fewSurfels ? 4 : 1;
        std::size_t i = 0;
        m_surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                if (i++ % stride == 0) {
                    const double reach = 0.3 * static_cast<double>(block.support(slot));
                    m_coherent.push_back(block.position(slot) + base::cast<float>(random.unitVector() * reach));
                }
        });
    }
    return m_coherent;
}

std::span<const Vec3f> Scene::scattered() {
    if (m_scattered.empty()) {
        const auto all = coherent();
        m_scattered.assign(all.begin(), all.end());
        shuffle(m_scattered, 3);
    }
    return m_scattered;
}

std::span<const Rayf> Scene::cameraRays() {
    const Vec3d eye = centre() + Vec3d{0, 0, 4 * radius()};
    if (m_camera.empty())
        for (std::size_t y = 0; y < raysPerEdge; ++y)
            for (std::size_t x = 0; x < raysPerEdge; ++x) {
                const auto slope = [](std::size_t i) { return (static_cast<double>(i) - 127.5) / 450; };
                m_camera.push_back(
                    {base::cast<float>(eye), base::cast<float>(base::normalized(Vec3d{slope(x), slope(y), -1}))});
            }
    return m_camera;
}

std::span<const Rayf> Scene::randomRays() {
    base::Random random(4);
    if (m_random.empty())
        for (std::size_t i = 0; i < raysPerEdge * raysPerEdge; ++i) {
            const Vec3d from = random.unitVector() * 3, to = random.unitVector() * std::cbrt(random.uniform());
            m_random.push_back(
                {base::cast<float>(centre() + from * radius()), base::cast<float>(base::normalized(to - from))});
        }
    return m_random;
}

std::vector<surfel::Surfel> Scene::places(std::size_t count) {
    std::vector<surfel::Surfel> out;
    base::Random random(5);
    for (std::size_t i = 0; i < count; ++i) {
        const surfel::BlockPtr block =
            m_surface.tree().block(static_cast<std::uint32_t>(random.below(m_surface.tree().blockCount())));
        out.push_back(block->surfel(static_cast<int>(random.below(static_cast<std::size_t>(block->size())))));
    }
    return out;
}

const NaiveSurface& Scene::naive() {
    if (!m_naive)
        m_naive = std::make_unique<NaiveSurface>(m_surface);
    return *m_naive;
}

const NaiveRays& Scene::naiveRays() {
    if (!m_naiveRays)
        m_naiveRays = std::make_unique<NaiveRays>(naive());
    return *m_naiveRays;
}

} // namespace bench
