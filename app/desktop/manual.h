// The manual that F1 opens: pages of plain HTML, which browsers and Qt's text browser show alike. What can be
// counted (tools, looks, commands, options, formats) is a loop over its table; first steps are written by hand. Its
// pictures are made by `pointclay render`.
#pragma once

#include <string>
#include <vector>

namespace app {

/// A chapter, as a file; the first is manual.html, where one begins.
struct ManualPage {
    std::string file, text;
};
/// Without pictures it names none.
std::vector<ManualPage> manual(bool pictures);

/// A picture that the manual shows: the name of its file, and the arguments of `pointclay` that make it.
struct ManualPicture {
    std::string file;
    std::vector<std::string> arguments;
};
std::vector<ManualPicture> manualPictures();

} // namespace app
