// Files packed with gzip. Damage is refused or unpacked within bounds, and any bytes come back from one that packs
// them.
#include "core/io/packed/gzip.h"
#include "core/io/packed/inflate.h"
#include "fuzz/fuzzed.h"
#include "support/gzip.h"

/// Its checksum stands behind a member: damage inside is unpacked before it is found.
static void unpack(std::string bytes) {
    const std::size_t most = io::mostInflated(bytes.size());
    const fuzz::Deadline deadline;
    fuzz::tried([&] {
        const io::FileBytes whole = io::unpackedGzip({"a.xyz.gz", std::move(bytes)}, deadline.progress());
        fuzz::require(whole.size() <= most, "no more comes out than was said");
        fuzz::require(!whole.bytes().empty(), "nothing is refused");
    });
    fuzz::require(!deadline.passed(), "unpacking takes a moment");
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(data, data + size);
    unpack(bytes);
    if (bytes.empty())
        return 0;
    const io::FileBytes back = io::unpackedGzip({"a.xyz.gz", test::storedGzip(bytes)}, {});
    fuzz::require(back.bytes() == bytes, "what was packed comes back");
    unpack(test::storedGzip(bytes) + bytes);
    return 0;
}
