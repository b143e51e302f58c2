// What a desktop has to know of the program: files that `cmake --install` puts in their places, each a loop over the
// tables of formats and of subcommands, so that none of them names what there is no more.
#pragma once

#include <string>

namespace app {

/// pointclay.desktop: name, icon, what it opens.
std::string desktopEntry();
/// pointclay.xml of shared-mime-info: the types of the formats that can be read, by their extensions.
std::string mimeTypes();
/// pointclay.1: synopsis, every subcommand with its options and example, the formats.
std::string manPage();
/// pointclay.thumbnailer: how a file manager gets its small pictures.
std::string thumbnailer();
/// pointclay.metainfo.xml of AppStream: what a software centre shows.
std::string softwarePage();
/// Words that bash completes after `pointclay`: subcommands, and the options of each.
std::string bashCompletions();

} // namespace app
