#include "ui/work/mesher.h"

#include "core/io/mesh_formats.h"
#include "core/mesh/check/topology.h"
#include "core/mesh/delaunay/delaunay.h"
#include "core/mesh/marching/marching_cubes.h"
#include "ui/work/post.h"

#include <algorithm>
#include <chrono>

namespace ui {

/// Triangles of a grid's cubes for one square of a cube's side, on average over all directions; measured, after the
/// smallest have been merged.
constexpr double cubeTriangles = 2.9;
/// Of Delaunay triangles with balls up to a radius, for a square of that radius; measured.
constexpr double delaunayTriangles = 1.6;

double estimatedArea(const tree::SurfelTree& model, double spacing) {
    std::vector<float> supports;
    supports.reserve(model.size());
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            supports.push_back(block.support(slot));
    });
    if (supports.empty())
        return 0;
    const auto middle = supports.begin() + static_cast<std::ptrdiff_t>(supports.size() / 2);
    std::nth_element(supports.begin(), middle, supports.end());
    const double scale = spacing / static_cast<double>(*middle);
    double out = 0; // the spacing is defined so that a surfel stands for the square of it
    for (const float support : supports)
        out += scale * static_cast<double>(support) * scale * static_cast<double>(support);
    return out;
}

std::size_t estimatedTriangles(double area, double spacing, const MeshChoice& choice) {
    const double side = choice.cell * spacing;
    return side > 0
               ? static_cast<std::size_t>((choice.delaunay ? delaunayTriangles : cubeTriangles) * area / (side * side))
               : 0;
}

Mesher::Mesher(QObject* parent)
    : QObject(parent), m_worker([this](const Wish& wish, const base::Progress& progress) { work(wish, progress); },
                                [this](const std::exception& error) {
                                    post(this, [this, text = textOf(error)] { Q_EMIT failed(text); });
                                },
                                [this] {
                                    postRest(
                                        this, [this] { return m_worker.busy(); }, [this] { rest(); });
                                }) {}

Mesher::~Mesher() = default;

static bool fits(const MadeMesh* made, const MeshChoice& choice, const tree::SurfelTree& model) {
    return made && made->choice.sameMesh(choice) && made->model == model;
}

void Mesher::want(const MeshChoice& choice, const Snapshot& snapshot) {
    if (fits(m_made.get(), choice, snapshot.surface.tree()))
        return;
    Wish wish{choice, snapshot.surface, snapshot.spacing, snapshot.origin, {}, nullptr};
    if (m_saving)
        m_after = std::move(wish);
    else
        m_worker.request(std::move(wish), true);
}

void Mesher::save(const MeshChoice& choice, const Snapshot& snapshot, const std::filesystem::path& path) {
    if (m_saving) {
        Q_EMIT failed(tr("Another mesh is being written; wait for it, or stop it with Esc."));
        return;
    }
    m_saving = true;
    m_after.reset();
    m_worker.request({choice, snapshot.surface, snapshot.spacing, snapshot.origin, path, m_made}, true);
}

void Mesher::cancel() {
    m_after.reset();
    m_worker.cancel();
}

void Mesher::rest() {
    m_saving = false;
    if (m_after)
        m_worker.request(*std::exchange(m_after, std::nullopt), true);
    else
        Q_EMIT idled();
}

static mesh::Mesh meshOf(const surface::Surface& surface, double spacing, const MeshChoice& choice,
                         const base::Progress& progress) {
    mesh::Finishing finishing;
    finishing.closeFolds = choice.closeFolds;
    finishing.dropSmall = choice.dropSmall;
    if (choice.delaunay) {
        mesh::DelaunayOptions options;
        mesh::DelaunayReport report;
        options.size = choice.cell * spacing;
        options.distance = 0.1 * choice.cell * spacing;
        options.finishing = finishing;
        return mesh::restrictedDelaunay(surface, options, report, progress);
    }
    mesh::MarchingOptions options;
    mesh::MarchingReport report;
    options.cell = choice.cell * spacing;
    options.finishing = finishing;
    return mesh::marchingCubes(surface, options, report, progress);
}

void Mesher::work(const Wish& wish, const base::Progress& cancel) {
    const base::Progress progress =
        postedProgress(cancel, this, [this](double share, const QString& doing) { Q_EMIT progressed(share, doing); });
    std::shared_ptr<const MadeMesh> made = wish.made;
    if (!fits(made.get(), wish.choice, wish.surface.tree())) {
        const auto start = std::chrono::steady_clock::now();
        auto fresh = std::make_shared<MadeMesh>(MadeMesh{wish.choice, wish.surface.tree(), nullptr, 0, 0, 0});
        fresh->mesh = std::make_shared<const mesh::Mesh>(meshOf(wish.surface, wish.spacing, wish.choice, progress));
        const mesh::Topology topology =
            mesh::topologyOf(fresh->mesh->triangles, fresh->mesh->positions.size(), fresh->mesh->kinds);
        fresh->foldLoops = topology.foldLoops;
        fresh->limitLoops = topology.boundaryLoops - topology.foldLoops;
        fresh->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        made = fresh;
        post(this, [this, made] {
            m_made = made;
            Q_EMIT changed();
        });
    }
    if (wish.path.empty())
        return;
    io::writeMesh(wish.path, *made->mesh, wish.origin, progress);
    post(this, [this, path = QString::fromStdString(wish.path.string())] { Q_EMIT saved(path); });
}

} // namespace ui
