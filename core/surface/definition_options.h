// The options of a surface definition: one table. The words of PLY comments, the session's commands, the command line,
// the window's dialog, the help and the tests are loops over it; a new option is a field of SurfaceDefinition and a
// row.
#pragma once

#include "core/surface/definition.h"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace surface {

/// `boundary` and `boundaryLimit` as one value: auto, none or the limit.
struct BoundaryField {};

using DefinitionField =
    std::variant<Manifold SurfaceDefinition::*, Frame SurfaceDefinition::*, Weight SurfaceDefinition::*, BoundaryField,
                 float SurfaceDefinition::*, int SurfaceDefinition::*, bool SurfaceDefinition::*>;

/// Of numbers; both ends belong to it. `orZero`: 0, too, which stands for "none" and is what a definition is told by
/// leaving the option out.
struct DefinitionRange {
    static constexpr double aboveZero = std::numeric_limits<float>::min();
    static constexpr double largest = std::numeric_limits<float>::max();
    double min = 0, max = 0;
    bool orZero = false;
};

/// Who chooses a value.
enum class ChosenBy {
    Person,
    Estimate ///< found for a model and kept with it; no parameter of commands
};

struct DefinitionOption {
    const char* id;   ///< "curvature-spacings"
    const char* unit; ///< "" for a plain number
    const char* tip;
    DefinitionField field;
    DefinitionRange range = {};
    const char* wish = nullptr; ///< what to give instead of a refused word; null: told by the range
    ChosenBy chosenBy = ChosenBy::Person;
    const char* excludes = nullptr; ///< id of an option that cannot be given together with this one
};

/// In the order of PLY words and of the help.
std::span<const DefinitionOption> definitionOptionTable();
/// Throws base::Error naming the known options.
const DefinitionOption& definitionOption(std::string_view id);

/// The names to choose from, separated by blanks; "" where the option is a number or on or off.
std::string choicesOf(const DefinitionOption& option);

/// The value as a word; numbers have as many digits as bring back the same bits.
std::string textOf(const DefinitionOption& option, const SurfaceDefinition& definition);
/// Throws base::Error for a word that is no value of the option.
void setText(const DefinitionOption& option, SurfaceDefinition& definition, std::string_view word);

} // namespace surface
