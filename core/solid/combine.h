// A model and a solid put together: union, difference, intersection (solid/README 2). What is outside or inside of the
// other one stays; the seam is a crease between cells of its two sides (cells/README).
#pragma once

#include "core/base/progress.h"
#include "core/solid/seam.h"

#include <optional>
#include <string_view>

namespace solid {

enum class Operation { Union, Difference, Intersection };

struct OperationRow {
    const char* id;
    const char* label;
    Operation operation;
};
std::span<const OperationRow> operationTable();
/// Throws base::Error naming the known ones.
Operation operation(std::string_view id);

/// The second solid: a side, and surfels on it. REQUIRES of the surfels: oriented normals, supports.
struct Operand {
    const Side& side;
    surfel::SurfelList surfels;
    std::vector<std::int8_t> sides = {}; ///< of the model's surfels, as sidesOf tells them; empty: to be asked
    bool trimmed = false;                ///< of its surfels only those are there that stay
};

struct CombineOptions {
    bool creases = true; ///< label both sides of the seam, so that it stays sharp
    double fillet = 0;   ///< radius of a ball that rounds the seam; 0: it stays sharp
    double chamfer = 0;  ///< the seam is cut flat between where a ball of that radius touches both; 0: it is not
    bool seams = false;  ///< trace them
    bool parts = false;  ///< count those that go as a whole

    /// Of the ball that rolls along the seam; 0: there is none.
    double ball() const { return std::max(fillet, chamfer); }
};

struct Combined {
    surface::Surface surface;
    std::size_t removed = 0;         ///< surfels of the model that went
    std::size_t inserted = 0;        ///< of the operand that came
    std::size_t atSeam = 0;          ///< surfels beside the seam, where it is a crease
    std::size_t rounded = 0;         ///< surfels of the fillet or chamfer
    std::size_t finer = 0;           ///< more on the coarser one's own surface, beside the seam; counted as inserted
    std::optional<base::Vec3d> open; ///< caps only: where the model is open as it is cut
    std::size_t partsGone = 0;       ///< parts of the model of which nothing is left; counted where asked for
    std::size_t otherPartsGone = 0;  ///< of the operand
    std::vector<SeamCurve> seams;    ///< where both surfaces cross; traced where asked for, or for a fillet
};

/// Throws base::Error where a model has no oriented normals or is a curve: it bounds no solid.
void requireSolid(const surface::Surface& model);

/// The model's surfels that stay keep every bit but their labels. Throws as requireSolid does, and base::Error where
/// nothing would be left, and where no ball of that radius fits; base::Cancelled.
Combined combine(const surface::Surface& model, const Operand& operand, Operation operation,
                 const CombineOptions& options = {}, const base::Progress& progress = {});

} // namespace solid
