// The document: the model as it is now, how it came to be, and how to go back.
//
// All changes go through commands (command.h). A command either completes and becomes one step of history, or throws
// and leaves the document as it was. History keeps older roots; what they share with the present costs nothing, and the
// byte budget drops the oldest steps first.
//
// A document holds a scene (scene.h) of one model or several. One of them is active: commands and tools work on it, and
// whoever knows nothing of scenes finds it here as the model. History is one, of all of them.
//
// A document is a value: a copy shares all roots and costs a few words per step, which is how commands roll back.
//
// Threads: one at a time. `surface()` may be handed to other threads; it is a value and never changes.
#pragma once

#include "core/io/file_model.h"
#include "core/session/scene/scene.h"

#include <deque>
#include <filesystem>

namespace session {

class Document {
  public:
    Document() = default;
    /// Of one model alone, where it stands.
    explicit Document(SceneModel model);
    const Scene& scene() const { return m_scene; }
    const surface::Surface& surface() const { return active().surface; }
    const Provenance& provenance() const { return *active().provenance; }
    /// The file that it was opened from or last saved to; empty for a new one.
    const std::filesystem::path& path() const { return m_path; }
    /// The axis that is upwards: part of the model, and of its history, but not of its hash.
    base::UpAxis up() const { return active().up; }
    /// The layers: part of the model, of its history and, where there are any, of its hash (layers/README).
    const layers::Stack& layers() const { return active().layers; }
    /// Hash of the content: surfels in any order, names and types of what they carry, and origin (base/hash.h); of
    /// several models also their names, poses, and which are hidden or locked. Equal after save and open in a format
    /// that holds all of them. In parallel, O(size).
    base::Hash128 hash() const;
    bool modified() const { return m_revision != m_savedRevision; } ///< since it was opened, made or saved

    /// One step forward: `label` is what the undo menu shows. Drops redo steps. What the layers hold follows, as `how`
    /// says; a version without their attributes has no layers.
    void commit(surface::Surface next, const std::string& label, layers::How how = layers::How::Carry);
    /// Likewise: all of the model was moved, with what its layers hold, and its stored coordinates count from `origin`.
    void commitMoved(surface::Surface next, const base::Vec3d& origin, const std::string& label);
    /// Likewise: other layers, and the surface that they show.
    void restack(surface::Surface next, layers::Stack layers, const std::string& label);
    /// Likewise: the same surface with another axis upwards.
    void turnUp(base::UpAxis up, const std::string& label);
    /// Likewise: other models, or other places of them. Those that are new get numbers of their own.
    /// REQUIRES: at least one model, one of them active.
    void rearrange(Scene next, const std::string& label);
    /// The last step did this, too: other places and states of the models that are there. REQUIRES: canUndo().
    void amend(Scene now);
    /// Replaces everything: one model was opened or made. Clears the history.
    void reset(surface::Surface surface, Provenance provenance, base::UpAxis up = base::UpAxis::Y,
               layers::Stack layers = {});
    /// Likewise: all that a file holds, which is called `path`.
    void reset(Scene scene, const std::filesystem::path& path);
    void saved(const std::filesystem::path& path);

    bool canUndo() const { return !m_past.empty(); }
    bool canRedo() const { return !m_future.empty(); }
    const std::string& undoLabel() const { return m_past.back().label; }   ///< REQUIRES: canUndo()
    const std::string& redoLabel() const { return m_future.back().label; } ///< REQUIRES: canRedo()
    /// Of all steps back, the oldest first, and of all that undo has left, the next first.
    std::vector<std::string> pastLabels() const, futureLabels() const;
    void undo(); ///< REQUIRES: canUndo()
    void redo(); ///< REQUIRES: canRedo()

    /// Bytes that history may hold beside the present; oldest steps go first. At least one step is always kept.
    void setHistoryBudget(std::size_t bytes);
    /// Bytes that the steps back and forward hold and the present does not share.
    std::size_t historyBytes() const;

    io::FileModel fileModel() const; ///< the active model, as a writer wants it

  private:
    /// A version that is not shown now. `label` names the command between it and its neighbour towards the present.
    struct Step {
        Scene scene;
        std::string label;
        std::size_t bytes = 0; ///< not shared with that neighbour
        std::uint64_t revision = 0;
    };
    SceneModel& active() { return m_scene.models[m_scene.active]; }
    const SceneModel& active() const { return m_scene.models[m_scene.active]; }
    void number(Scene& scene); ///< those of its models that are new
    void step(Scene next, const std::string& label);
    void shift(std::deque<Step>& from, std::deque<Step>& to);
    void enforceBudget();

    Scene m_scene;
    std::filesystem::path m_path;
    std::uint32_t m_lastModel = 0;     ///< the largest number that a model had
    std::deque<Step> m_past, m_future; ///< nearest step at the back
    std::size_t m_budget = std::size_t(1) << 30;
    /// Versions by number, never used twice: what was saved is known without holding it.
    std::uint64_t m_revision = 0, m_savedRevision = 0, m_lastRevision = 0;
};

} // namespace session
