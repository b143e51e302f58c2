// What the subcommands that trace curves on a surface have in common: `boundary`, `section`, `seams`.
#pragma once

#include "app/console.h"
#include "app/options/option_set.h"
#include "app/options/surface_options.h"
#include "core/session/document.h"
#include "core/surface/curves/boundary.h"

#include <string>

namespace app {

struct PolylineOptions {
    std::string model, out; ///< no `out`: only counted and measured
    double turn = 0.1, least = 0;
    bool planar = false;    ///< all in one plane: drawings serve, too
    bool complexes = false; ///< complexes have such curves
    bool turns = true;      ///< steps along the curves are asked for
    std::shared_ptr<SurfaceOptions> surface;

    surface::TraceOptions tracing() const;
};

/// Adds -o, --turn, --least and the surface options. `what` is traced ("boundary curve"), `columns` tells of CSV files.
void addPolylineOptions(OptionSet command, PolylineOptions& options, const std::string& what,
                        const std::string& columns);

/// Opens the model. Throws UsageError for a file that no row of the table of formats writes, base::Error with `fault`
/// for curves.
void openForPolylines(const PolylineOptions& options, session::Document& document, const base::Progress& progress,
                      Console& console, const char* fault);

} // namespace app
