// Writes what a desktop has to know of the program (desktop_files.h) into a folder. Run by the build, not installed.
#include "app/desktop_files.h"

#include <filesystem>
#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "give the folder to write to\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    const std::pair<const char*, std::string> files[] = {{"pointclay.desktop", app::desktopEntry()},
                                                         {"pointclay.xml", app::mimeTypes()},
                                                         {"pointclay.1", app::manPage()},
                                                         {"pointclay.bash", app::bashCompletions()}};
    for (const auto& [name, text] : files) {
        std::ofstream out(folder / name, std::ios::binary);
        if (!(out << text).flush()) {
            std::cerr << (folder / name).string() << " cannot be written\n";
            return 1;
        }
    }
    return 0;
}
