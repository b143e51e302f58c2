// A LAS file of as many points as asked for, larger than memory if need be: hills seen from the air, in flight lines
// that overlap, denser on one side, with strays. The same bytes for the same arguments.
//
//     pointclay_large_las OUT.las COUNT [SEED]
#include "core/base/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <vector>

namespace {

constexpr std::size_t headSize = 227, stride = 20; // LAS 1.2, point format 0

template <class T>
void put(char* bytes, std::size_t at, T value) {
    std::memcpy(bytes + at, &value, sizeof value);
}

std::array<char, headSize> headOf(std::uint32_t count) {
    std::array<char, headSize> out{};
    std::memcpy(out.data(), "LASF", 4);
    put(out.data(), 24, std::uint8_t(1));
    put(out.data(), 25, std::uint8_t(2));
    put(out.data(), 94, std::uint16_t(headSize));
    put(out.data(), 96, std::uint32_t(headSize));
    put(out.data(), 105, std::uint16_t(stride));
    put(out.data(), 107, count);
    for (std::size_t k = 0; k < 3; ++k)
        put(out.data(), 131 + 8 * k, 0.001);
    put(out.data(), 155, 500000.0);
    put(out.data(), 163, 4.4e6);
    return out;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::cerr << "pointclay_large_las OUT.las COUNT [SEED]\n";
        return 2;
    }
    const auto count = static_cast<std::uint32_t>(std::stoul(argv[2]));
    base::Random random(argc > 3 ? std::stoull(argv[3]) : 1);
    std::ofstream out(argv[1], std::ios::binary);
    const auto head = headOf(count);
    out.write(head.data(), head.size());
    const double side = 0.35 * std::sqrt(static_cast<double>(count)); // metres
    constexpr std::size_t block = 65536;
    std::vector<char> bytes(block * stride);
    for (std::uint32_t first = 0; first < count; first += block) {
        const auto here = std::min<std::size_t>(block, count - first);
        for (std::size_t k = 0; k < here; ++k) {
            char* const record = bytes.data() + k * stride;
            const double line = static_cast<double>(first + k) / count; // the aircraft goes on
            const double x = side * (0.9 * line + 0.1 * random.uniform());
            const double y = side * std::pow(random.uniform(), 2);
            double z = 60 * std::sin(x / 300) * std::cos(y / 210) + 8 * std::sin(x / 31 + y / 47);
            z += random.uniform() < 0.002 ? random.uniform(-40, 200) : 0.02 * random.normal();
            put(record, 0, static_cast<std::int32_t>(std::lround(x * 1000)));
            put(record, 4, static_cast<std::int32_t>(std::lround(y * 1000)));
            put(record, 8, static_cast<std::int32_t>(std::lround(z * 1000)));
            put(record, 12, static_cast<std::uint16_t>(random.uniform(0, 4096)));
            put(record, 14, std::uint8_t(0x09)); // the only return
            put(record, 15, std::uint8_t(2));    // ground
            put(record, 16, std::uint32_t(0));
        }
        out.write(bytes.data(), static_cast<std::streamsize>(here * stride));
    }
    out.close();
    if (!out) {
        std::cerr << argv[1] << " cannot be written\n";
        return 1;
    }
    return 0;
}
