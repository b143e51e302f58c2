// The models of a document: one, or several beside each other, each with a name, a place, and what belongs to it.
//
// A model keeps its own coordinates, those of its file; its *pose* is the rigid motion that takes these to the scene's.
// So nothing that works on a model knows where it stands, and moving it costs nothing and loses nothing.
//
// Values: a copy shares surfels and provenance. Threads: any number may read one.
#pragma once

#include "core/io/file_model.h"
#include "core/layers/layer_edits.h"
#include "core/process/registering/rigid.h"
#include "core/surface/surface.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace session {

/// The part of a file that is not surfels, kept for saving; shared by all versions.
struct Provenance {
    std::filesystem::path path; ///< where it was opened from; empty for a new one
    base::Vec3d origin;
    std::size_t faces = 0;
    std::size_t dropped = 0;   ///< points that were not finite
    std::size_t merged = 0;    ///< points that opening merged with others in their place
    bool sampled = false;      ///< the surfels are samples of the file's faces
    bool closed = false;       ///< the file's faces have no boundary
    bool guessedSides = false; ///< opening estimated the normals, and which way they look
    std::string format;
    std::vector<std::string> comments;
    std::vector<io::OpaqueElement> elements;
};

struct SceneModel {
    std::uint32_t id = 0; ///< never used twice in a document; 0: none yet
    std::string name;     ///< no two of a scene have the same
    surface::Surface surface;
    base::UpAxis up = base::UpAxis::Y;
    layers::Stack layers;
    process::Rigid pose; ///< from the coordinates of its file to the scene's
    bool visible = true;
    bool locked = false; ///< nothing may change it
    std::shared_ptr<const Provenance> provenance = std::make_shared<Provenance>();

    const base::Vec3d& origin() const { return provenance->origin; }
};

struct Scene {
    std::vector<SceneModel> models = std::vector<SceneModel>(1);
    std::size_t active = 0;

    /// -1: none has that name, or that number.
    int indexOf(std::string_view name) const;
    int indexOf(std::uint32_t id) const;
    /// Throws base::Error that lists the models where none has that name.
    std::size_t find(const std::string& name) const;
    /// `wanted`, with a number behind it where another model has that name.
    std::string freshName(const std::string& wanted) const;
};

/// Throws base::Error that says why, where the model may not be changed: it is locked or hidden.
void refuseChange(const SceneModel& model);

/// A name for a model: 1 to 64 characters in one line, without blanks at its ends.
bool isModelName(const std::string& name);
/// That of a file without its extension, else "Model".
std::string nameOf(const std::filesystem::path& file);

bool isNothing(const process::Rigid& pose);
/// From the stored coordinates of one model to those of another.
process::Rigid between(const SceneModel& from, const SceneModel& to);
/// 16 numbers by row.
std::vector<double> matrixOf(const process::Rigid& pose);
/// Throws base::Error for what turns, mirrors or stretches otherwise than a rigid motion, or is no list of 16.
process::Rigid poseOf(const std::vector<double>& matrix);

/// The surface where its model stands, in another frame: surfels moved, normals and shapes turned along, rounded once.
/// The same surface for no motion. In parallel, O(size).
surface::Surface placed(const surface::Surface& surface, const process::Rigid& motion);

io::FileModel fileModel(const SceneModel& model); ///< as a writer wants it

/// The hash of a surface's content with its origin.
base::Hash128 contentHash(const tree::SurfelTree& tree, const base::Vec3d& origin, const layers::Stack& stack = {});
/// Of one model that stands where its file has it, its content's alone, so that a file has the hash of its model.
base::Hash128 contentHash(const Scene& scene);

/// Bytes that `version` holds and `other` does not share.
std::size_t unsharedBytes(const Scene& version, const Scene& other);

} // namespace session
