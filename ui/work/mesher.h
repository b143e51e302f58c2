// Meshes for preview and export, made off the interface's thread and off the model's: strokes go on.
//
//     interface                              meshing thread
//     want(choice, snapshot)        -->      marching cubes or Delaunay       --> made()
//     save(path)                    -->      the same where it is not made yet, then the file --> saved(path)
//
// A newer wish stops the one that runs, except while a file is being written: that is finished first. Interface's
// thread only.
#pragma once

#include "core/mesh/mesh.h"
#include "ui/work/latest_worker.h"
#include "ui/work/mesh_choice.h"
#include "ui/work/snapshot.h"

#include <QObject>

namespace ui {

/// What has been made, and of what.
struct MadeMesh {
    MeshChoice choice;
    tree::SurfelTree model;
    std::shared_ptr<const mesh::Mesh> mesh;
    std::size_t limitLoops = 0, foldLoops = 0; ///< of the boundary: at its limit, at folds
    double seconds = 0;
};

/// Of the surface, roughly: supports grow with the distances between surfels, of which `spacing` is the typical one.
double estimatedArea(const tree::SurfelTree& model, double spacing);
/// Triangles that a choice leads to, roughly.
std::size_t estimatedTriangles(double area, double spacing, const MeshChoice& choice);

class Mesher : public QObject {
    Q_OBJECT
  public:
    explicit Mesher(QObject* parent = nullptr);
    ~Mesher() override;

    void want(const MeshChoice& choice, const Snapshot& snapshot);
    /// Of the same, into a file of io::meshFormatTable(). While one is being written another fails.
    void save(const MeshChoice& choice, const Snapshot& snapshot, const std::filesystem::path& path);
    void cancel();
    bool busy() const { return m_saving || m_worker.busy(); }
    /// The last one made; null before.
    const std::shared_ptr<const MadeMesh>& made() const { return m_made; }

  Q_SIGNALS:
    void changed(); ///< made() is new
    void saved(QString path);
    void failed(QString message);                 ///< what is wrong, where, what to do
    void progressed(double share, QString doing); ///< 0 to 1
    void idled();                                 ///< nothing is being made any more

  private:
    struct Wish {
        MeshChoice choice;
        surface::Surface surface;
        double spacing = 0;
        base::Vec3d origin;
        std::filesystem::path path; ///< empty: no file
        std::shared_ptr<const MadeMesh> made;
    };
    void rest();
    void work(const Wish& wish, const base::Progress& progress);

    std::shared_ptr<const MadeMesh> m_made;
    bool m_saving = false;
    std::optional<Wish> m_after; ///< wanted while a file was being written
    LatestWorker<Wish> m_worker; ///< last: it calls back
};

} // namespace ui
