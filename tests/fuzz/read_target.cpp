// A reader: POINTCLAY_FORMAT is the id of its row. Which of the format's extensions the file has follows from its
// length.
#include "core/base/row_of_id.h"
#include "core/io/file_bytes.h"
#include "core/io/formats.h"
#include "fuzz/fuzzed.h"

/// What holds for every model that was read (tests/io/mutation_test.cpp has the same).
static void checkModel(const io::FileModel& model, std::size_t bytes) {
    const surfel::SurfelList& points = model.points;
    fuzz::require(points.size() > 0, "a model has points");
    // What is packed can be far more than its bytes, but not without end.
    fuzz::require(points.size() <= 2048 * bytes, "no more points than the bytes can tell of");
    fuzz::require(points.extra.size() == points.size() * points.layout->words(), "attributes of all points");
    for (const surfel::Surfel& s : points.items) {
        fuzz::require(base::isFinite(s.position) && base::isFinite(s.normal), "finite positions and normals");
        fuzz::require(s.mask >= 0 && s.mask <= 1, "masks are 0 to 1");
        fuzz::require(!model.hasSupports || (s.support > 0 && std::isfinite(s.support)), "supports are positive");
    }
    const mesh::Polygons& faces = model.polygons;
    for (const std::uint32_t corner : faces.corners)
        fuzz::require(corner < points.size(), "corners are points");
    fuzz::require(faces.places.empty() || faces.places.size() == faces.corners.size(), "a place for every corner");
    fuzz::require(faces.pictureOf.empty() || faces.pictureOf.size() == faces.size(), "a picture for every face");
    for (const std::string& message : model.messages)
        fuzz::require(!message.empty(), "messages are sentences");
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    static const io::FormatRow& row = *base::findRow(io::formatTable(), POINTCLAY_FORMAT);
    const io::FileBytes file("a." + fuzz::oneOf(row.extensions, size), std::string(data, data + size));
    const fuzz::Deadline deadline;
    fuzz::tried([&] { checkModel(io::read(file, deadline.progress(), fuzz::folder()), size); });
    fuzz::require(!deadline.passed(), "reading takes a moment");
    return 0;
}
