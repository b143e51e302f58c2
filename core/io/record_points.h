// Points from records: the second half of every reader.
#pragma once

#include "core/base/progress.h"
#include "core/io/file_bytes.h"
#include "core/io/file_model.h"
#include "core/io/record_roles.h"

namespace io {

/// Share of the whole work that a step is, for the progress bar.
struct ProgressSpan {
    const base::Progress& progress;
    double from = 0, to = 1;
    const char* what = "Reading";

    void step(double done) const { progress.step(from + (to - from) * done, what); }
};

struct PointOptions {
    std::optional<base::Vec3d> origin; ///< as the file states it; else chosen by origin_choice.h
    bool oriented = true;              ///< signs of normals in the file agree
};

/// Fills `model.points`, `origin`, `hasSupports` and `dropped` from the table; messages tell what was left out.
/// `model.polygons` come with the numbers of the table's records and get those of the points.
///
///     position   missing z: 0; not finite, or not finite as float: the point is dropped and counted
///     normal     unit ones keep their bits, others are normalised; not finite or zero: zero
///     colour     8-bit as it is; 16-bit and larger integers over 255: 16-bit; reals up to 1: 0..1; else 0..255
///     support    kept when all are finite and > 0
///     mask       clamped to 0..1
///     attribute  its declared type, bit for bit
///
/// In parallel; the same at any thread count. Throws base::Error in the name of `file`
/// where no point is left.
void makePoints(FileModel& model, const FileBytes& file, const RecordTable& table, const RecordRoles& roles,
                const PointOptions& options, const ProgressSpan& progress);

} // namespace io
