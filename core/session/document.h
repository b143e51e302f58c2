// The document: the model as it is now, how it came to be, and how to go back.
//
// All changes go through commands (command.h). A command either completes and becomes one step of history, or throws
// and leaves the document as it was. History keeps older roots; what they share with the present costs nothing, and the
// byte budget drops the oldest steps first.
//
// Threads: one at a time. `surface()` may be handed to other threads; it is a value and never changes.
#pragma once

#include "core/io/file_model.h"
#include "core/surface/surface.h"

#include <deque>
#include <filesystem>

namespace session {

/// The part of a file that is not surfels, kept for saving; shared by all versions.
struct Provenance {
    std::filesystem::path path; ///< where it was opened from or last saved to; empty for a new one
    base::Vec3d origin;
    std::size_t faces = 0;
    std::size_t dropped = 0;
    std::string format;
    std::vector<std::string> comments;
    std::vector<io::OpaqueElement> elements;
};

class Document {
  public:
    const surface::Surface& surface() const { return m_surface; }
    const Provenance& provenance() const { return m_provenance; }
    /// Hash of the content: surfels, layout names and origin (base/hash.h); equal after save and open.
    base::Hash128 hash() const;
    bool modified() const; ///< since it was opened or saved

    /// One step forward: `label` is what the undo menu shows. Drops redo steps.
    void commit(surface::Surface next, const std::string& label);
    /// Replaces everything: a model was opened or made. Clears the history.
    void reset(surface::Surface surface, Provenance provenance);
    void saved(const std::filesystem::path& path);

    bool canUndo() const { return !m_past.empty(); }
    bool canRedo() const { return !m_future.empty(); }
    const std::string& undoLabel() const { return m_past.back().label; }
    const std::string& redoLabel() const { return m_future.back().label; }
    void undo(); ///< REQUIRES: canUndo()
    void redo(); ///< REQUIRES: canRedo()

    /// Bytes that history may hold beside the present; oldest steps go first. At least one step is always kept.
    void setHistoryBudget(std::size_t bytes);
    std::size_t historyBytes() const;

    io::FileModel fileModel() const; ///< as a writer wants it

  private:
    struct Step {
        surface::Surface surface;
        std::string label;
        std::size_t bytes = 0;
    };
    void enforceBudget();
    surface::Surface m_surface;
    Provenance m_provenance;
    std::deque<Step> m_past, m_future; ///< nearest step at the back
    std::size_t m_budget = std::size_t(1) << 30;
    tree::SurfelTree m_savedTree;
};

} // namespace session
