// Writes what a desktop has to know of the program (desktop_files.h) and the manual into a folder. Run by the build,
// not installed. With the program it makes the manual's pictures, too.
#include "app/desktop/desktop_files.h"
#include "app/desktop/manual.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

/// Whether the program ended well.
static bool makePicture(const std::string& program, const std::string& target, const app::ManualPicture& picture) {
    std::vector<std::string> words = {program};
    words.insert(words.end(), picture.arguments.begin(), picture.arguments.end());
    words.insert(words.end(), {"-o", target});
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    int status = 0;
    return ::posix_spawn(&child, program.c_str(), nullptr, nullptr, argv.data(), environ) == 0 &&
           ::waitpid(child, &status, 0) == child && status == 0;
}

int main(int argc, char** argv) {
    if (argc != 2 && argc != 3) {
        std::cerr << "give the folder to write to, and the program where pictures are wanted\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    std::vector<std::pair<std::string, std::string>> files = {{"pointclay.desktop", app::desktopEntry()},
                                                              {"pointclay.xml", app::mimeTypes()},
                                                              {"pointclay.thumbnailer", app::thumbnailer()},
                                                              {"pointclay.metainfo.xml", app::softwarePage()},
                                                              {"pointclay.1", app::manPage()},
                                                              {"pointclay.bash", app::bashCompletions()}};
    for (const app::ManualPage& page : app::manual(argc == 3))
        files.emplace_back(page.file, page.text);
    for (const auto& [name, text] : files) {
        std::ofstream out(folder / name, std::ios::binary);
        if (!(out << text).flush()) {
            std::cerr << (folder / name).string() << " cannot be written\n";
            return 1;
        }
    }
    if (argc == 3)
        for (const app::ManualPicture& picture : app::manualPictures())
            if (!makePicture(argv[2], (folder / picture.file).string(), picture)) {
                std::cerr << picture.file << " could not be drawn\n";
                return 1;
            }
    return 0;
}
