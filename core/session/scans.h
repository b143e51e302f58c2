// Scans brought together, the same for the command `register` and the subcommand: models opened beside each other,
// moved onto the surfaces of the others (process/README 13), and made one list of points.
//
//     Scans scans;    add(scans, name, document)...      the first stays where it is
//     bring(scans, ...)                                  fills placed[m].pose, rms and overlap
//     together(scans, shift)                             all of their points
#pragma once

#include "core/process/registering/align.h"
#include "core/session/document.h"

#include <string>
#include <vector>

namespace session {

/// The one that stays first.
struct Scans {
    std::vector<std::string> names; ///< for messages
    std::vector<Document> documents;
    std::vector<process::Placed> placed; ///< in the first one's coordinates, relative to its origin

    base::Vec3d origin() const { return documents[0].provenance().origin; }
};

/// Throws base::Error for a curve, or where there is no model.
void add(Scans& scans, const std::string& name, const Document& document);

/// All but the first to their places, from where they are or, `anywhere`, by what their surfaces look like. Sentences
/// with their figures are appended to `messages`. The same bits at any thread count. Throws base::Error where a scan
/// has no place, base::Cancelled.
void bring(Scans& scans, bool anywhere, std::vector<std::string>& messages, const base::Progress& progress = {});

/// From the file coordinates of one scan to those of the first.
process::Rigid betweenFiles(const Scans& scans, std::size_t m);

/// One sentence that names what not all of them have alike, so that `together` leaves it out. Empty where nothing is.
std::string lossOf(const Scans& scans);

/// All of their points with the attributes that they have alike and `scan`, the number of each one's scan: the first
/// one's is 0, or what it has already where it was put together like this; the others' follow. Relative to the first
/// one's origin, moved by `shift`. Supports are 0: where scans overlap there are more points than in each of them.
surfel::SurfelList together(const Scans& scans, const base::Vec3d& shift = {});

} // namespace session
