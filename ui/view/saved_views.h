// Views that a person has named, kept with the settings: `render --view NAME` finds them too. What comes back is the
// same camera bit for bit; for a model with another origin it is the same place of the file's coordinates.
#pragma once

#include "ui/view/view.h"

#include <string>
#include <vector>

namespace ui {

struct SavedView {
    std::string name; ///< not empty, one line
    View view;
    base::Vec3d origin; ///< of the model that it was taken of

    bool operator==(const SavedView&) const = default;

    /// For a model of this origin.
    View forOrigin(const base::Vec3d& of) const;
};

/// One line: numbers that read back to the same bits, then the name.
std::string textOf(const SavedView& view);
std::optional<SavedView> savedViewOf(const std::string& text);

/// Replaces the one of the same name, or appends.
void keep(std::vector<SavedView>& views, const SavedView& view);
const SavedView* findView(std::span<const SavedView> views, std::string_view name);

} // namespace ui
