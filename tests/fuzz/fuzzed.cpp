#include "fuzz/fuzzed.h"

#include "core/base/parallel.h"
#include "core/io/pictures/colour_png.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <thread>
#include <unistd.h>
#include <vector>

namespace fuzz {

namespace fs = std::filesystem;

void require(bool holds, const char* law) {
    if (holds)
        return;
    std::fprintf(stderr, "does not hold: %s\n", law);
    std::abort();
}

static fs::path& ownFolder() {
    static fs::path path;
    return path;
}

static void removeFolder() {
    std::error_code none;
    fs::remove_all(ownFolder(), none);
}

const fs::path& folder() {
    return ownFolder();
}

fs::path put(const std::string& name, std::string_view content) {
    const fs::path path = ownFolder() / name;
    std::ofstream(path, std::ios::binary) << content;
    return path;
}

// --- patience ---

namespace {

constexpr std::clock_t patience = CLOCKS_PER_SEC / 4;

std::atomic<bool> expired{false};
std::atomic<std::clock_t> end{0}; ///< 0: nothing runs

void watch() {
    for (;;) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        const std::clock_t at = end.load();
        if (at != 0 && std::clock() > at)
            expired = true;
    }
}

} // namespace

Deadline::Deadline() {
    expired = false;
    end = std::clock() + patience;
}

Deadline::~Deadline() {
    end = 0;
}

base::Progress Deadline::progress() const {
    return {{}, &expired};
}

bool Deadline::passed() const {
    return expired;
}

// --- inputs ---

std::string oneOf(std::string_view names, std::size_t number) {
    std::istringstream in{std::string(names)};
    std::vector<std::string> words;
    for (std::string word; in >> word;)
        words.push_back(word);
    return words.at(number % words.size());
}

void putPictures() {
    const std::uint32_t pixels[] = {0xff0000ffu, 0xff00ff00u, 0xffff0000u, 0xffffffffu};
    put("p.png", io::encodePng(pixels, 2, 2, "p.png"));
    put("m.mtl", "newmtl m\nmap_Kd p.png\nnewmtl n\nmap_Kd -clamp on p.png\n");
}

} // namespace fuzz

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    base::setThreadCount(1);
    std::string name = (std::filesystem::temp_directory_path() / "pointclay-fuzz-XXXXXX").string();
    fuzz::require(::mkdtemp(name.data()) != nullptr, "there is a place for files");
    fuzz::ownFolder() = name;
    std::atexit(fuzz::removeFolder);
    fuzz::putPictures();
    std::thread(fuzz::watch).detach();
    return 0;
}
