// Colours of 16 bits a channel, which the 8 bits of a surfel do not bring back: attributes beside the colour keep them.
#pragma once

namespace io {

constexpr const char* wideColours[3] = {"red_16", "green_16", "blue_16"};

} // namespace io
