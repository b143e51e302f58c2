// What `query --what` can ask for, as a table in the order of the columns (app/README 2.3).
#pragma once

#include "app/csv_writer.h"
#include "core/cells/cell_projection.h"
#include "core/surface/curvature.h"
#include "core/surface/projection/project.h"

#include <optional>
#include <string>
#include <vector>

namespace app {

/// All that is known at one position, in float64; float32 answers are widened.
struct Answer {
    surface::Evaluationd at; ///< of the position
    surface::Curvature curvature;
    surface::Projection<double> projection;
    base::Vec3d tangent, curvatureVector; ///< of a curve
    std::uint32_t cell = cells::noCell;   ///< 0 of a model without cells
    cells::Feature feature = cells::Feature::None;
};

/// BeyondBoundary is a valid answer to a question asked there.
bool valid(surface::Status status);

/// What a question makes sense on; cells are those of surfaces and of complexes.
enum class Asks { Both, Surface, Curve, Cells };

struct WhatRow {
    const char* id;
    const char* columns; ///< header, separated by commas
    const char* tip;
    std::optional<surface::Projector> projector; ///< for projections
    surface::Need need;                          ///< at the position, for the others
    /// Writes the columns; `valid` is false where there is no answer.
    void (*write)(CsvWriter& out, const Answer& answer, const base::Vec3d& origin);
    Asks of = Asks::Both;
};

std::span<const WhatRow> whatTable();

/// What a query asks for, from its comma list, in the order of the table.
struct Question {
    std::vector<const WhatRow*> rows;
    bool evaluates = false; ///< something at the position itself
    surface::Need need = surface::Need::Value;
    bool curvature = false;
    std::optional<surface::Projector> projector;
    bool feature = false;

    std::string header() const;
    /// Throws UsageError where something makes no sense on this kind of model.
    void check(surface::Manifold manifold, bool complex) const;
    /// The first of evaluation and projection that is not all right.
    surface::Status status(const Answer& answer) const;
};

/// Throws UsageError for unknown names and for two projections.
Question parseQuestion(const std::string& list);

} // namespace app
