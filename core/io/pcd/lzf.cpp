#include "core/io/pcd/lzf.h"

#include <cstring>

namespace io {

bool unpackLzf(std::string_view packed, std::span<char> out) {
    std::size_t in = 0, at = 0;
    while (in < packed.size()) {
        const auto control = static_cast<unsigned char>(packed[in++]);
        if (control < 32) {
            const std::size_t run = control + std::size_t(1);
            if (run > packed.size() - in || run > out.size() - at)
                return false;
            std::memcpy(out.data() + at, packed.data() + in, run);
            in += run, at += run;
            continue;
        }
        std::size_t length = control >> 5;
        if (length == 7) {
            if (in == packed.size())
                return false;
            length += static_cast<unsigned char>(packed[in++]);
        }
        length += 2;
        if (in == packed.size())
            return false;
        const std::size_t back =
            (static_cast<std::size_t>(control & 31) << 8 | static_cast<unsigned char>(packed[in++])) + 1;
        if (back > at || length > out.size() - at)
            return false;
        for (std::size_t k = 0; k < length; ++k, ++at) // byte by byte: the copy may overlap itself
            out[at] = out[at - back];
    }
    return at == out.size();
}

} // namespace io
