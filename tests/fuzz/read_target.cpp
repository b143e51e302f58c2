// A reader: POINTCLAY_FORMAT is the id of its row. Which of the format's extensions the file has follows from its
// length.
#include "core/base/row_of_id.h"
#include "core/io/e57/paged_bytes.h"
#include "core/io/file_bytes.h"
#include "core/io/formats.h"
#include "fuzz/fuzzed.h"
#include "support/crc32.h"

#include <cstring>

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

/// Pages of E57 end in checksums, which no mutation meets: they are set right, so that what lies behind them is tried.
static void mendChecksums(std::string& bytes) {
    std::uint64_t size = 0;
    if (bytes.size() >= 48)
        std::memcpy(&size, bytes.data() + 40, sizeof size);
    for (std::size_t at = 0; size >= 64 && size <= bytes.size() - at; at += size) {
        const std::uint32_t sum = io::e57::checksum(std::string_view(bytes).substr(at, size - 4));
        for (std::size_t k = 0; k < 4; ++k)
            bytes[at + size - 4 + k] = static_cast<char>(sum >> (24 - 8 * k));
    }
}

/// So do the entries of archives: those that stand there as they are get theirs.
static void mendEntries(std::string& bytes) {
    const auto number = [&](std::size_t at, std::size_t size) {
        std::size_t out = 0;
        for (std::size_t k = size; k-- > 0;)
            out = out << 8 | static_cast<unsigned char>(bytes[at + k]);
        return out;
    };
    for (std::size_t at = bytes.find("PK\1\2"); at != std::string::npos; at = bytes.find("PK\1\2", at + 4)) {
        if (at + 46 > bytes.size() || number(at + 10, 2) != 0)
            continue;
        const std::size_t size = number(at + 20, 4), local = number(at + 42, 4);
        if (local + 30 > bytes.size())
            continue;
        const std::size_t begin = local + 30 + number(local + 26, 2) + number(local + 28, 2);
        if (begin > bytes.size() || size > bytes.size() - begin)
            continue;
        const std::uint32_t sum = test::crc32(std::string_view(bytes).substr(begin, size));
        for (std::size_t k = 0; k < 4; ++k)
            bytes[at + 16 + k] = static_cast<char>(sum >> 8 * k);
    }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    static const io::FormatRow& row = *base::findRow(io::formatTable(), POINTCLAY_FORMAT);
    std::string bytes(data, data + size);
    if (std::string_view(row.id) == "e57")
        mendChecksums(bytes);
    if (std::string_view(row.id) == "3mf")
        mendEntries(bytes);
    const io::FileBytes file("a." + fuzz::oneOf(row.extensions, size), std::move(bytes));
    const fuzz::Deadline deadline;
    fuzz::tried([&] { checkModel(io::read(file, deadline.progress(), fuzz::folder()), size); });
    fuzz::require(!deadline.passed(), "reading takes a moment");
    return 0;
}
