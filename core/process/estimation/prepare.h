// From loaded points to a surface: everything a raw scan lacks is estimated, everything it brings is kept.
//
//     duplicates, where asked   merged                                                    duplicates.h
//     normals absent            estimated from 18 neighbours, then oriented consistently   normals.h
//                               (surfaces without two sides stay unoriented)
//     normals that disagree     turned, where asked                                       orientation/agreement.h
//     supports absent or asked  from neighbours or one radius, by the definition           supports.h
//     Boundary::Auto            limit from the model's own off-centre values, once         boundary_limit.h
//     normals given, inwards    turned, where asked and the surface is closed               outside.h
//     tree                      built                                                      tree/surfel_tree.h
#pragma once

#include "core/surface/surface.h"
#include "core/tree/tree_shape.h"

namespace process {

struct PrepareOptions {
    surface::SurfaceDefinition definition;
    bool keepSupports = true; ///< supports > 0 that came with the points stay as they are
    bool keepLimit = false;   ///< Boundary::Auto was resolved for this very model: definition.boundaryLimit stands
    /// Where not null, points that are duplicates of others are merged with them, and their number comes here.
    std::size_t* merged = nullptr;
    /// Where not null: oriented normals that came with the points are turned where these turn out to be a closed
    /// surface that is inside out, and whether they were comes here.
    bool* turned = nullptr;
    /// Where not null: oriented normals that came with the points and do not agree on a side are turned so that they do
    /// (orientation/agreement.h), and how many were comes here.
    std::size_t* disagreed = nullptr;
    /// Where not null, of a tree that these very points may come from: then it is that tree again.
    const tree::TreeShape* shape = nullptr;
    bool keepSides = false; ///< whether there are two sides was judged for this very model: unoriented normals stay so
    /// Shapes that came without supports stay: their ellipses have the area of the balls that are made.
    bool keepShapes = false;
};

/// Throws base::Error where fewer than 4 distinct points are left to make a surface of, base::Cancelled.
surface::Surface prepare(surfel::SurfelList points, const PrepareOptions& options, const base::Progress& progress = {});

/// The same surfels under another definition: supports and boundary limit are made anew, in the tree's own version.
surface::Surface redefine(const surface::Surface& surface, const surface::SurfaceDefinition& definition,
                          const base::Progress& progress = {});

} // namespace process
