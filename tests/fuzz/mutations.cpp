#include "fuzz/mutations.h"

#include <algorithm>
#include <sstream>

namespace fuzz {

using base::Random;

/// What is longer is slow and finds no more.
constexpr std::size_t longest = 8192;

static constexpr const char* numbers[] = {
    "0",          "-0",         "1",    "-1",     "255",  "256",   "65535", "65536",    "2147483647",
    "2147483648", "4294967295", "1e38", "3.5e38", "1e39", "1e-46", "1e308", "1e999",    "18446744073709551615",
    "nan",        "-inf",       "0x1p", "1.",     ".5",   "+7",    "1,5",   "1.#QNAN0", "99999999999999999999"};

static std::size_t placeIn(const std::string& text, Random& random) {
    return random.below(text.size() + 1);
}

/// A piece of the text: begin and length, short ones by preference.
static std::pair<std::size_t, std::size_t> pieceOf(const std::string& text, Random& random) {
    const std::size_t begin = placeIn(text, random), most = text.size() - begin;
    const std::size_t length = random.below(3) == 0 ? most : std::min<std::size_t>(most, 16);
    return {begin, random.below(length + 1)};
}

/// The line around a place.
static std::pair<std::size_t, std::size_t> lineAt(const std::string& text, std::size_t at) {
    const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    return {begin, std::min(text.find('\n', begin), text.size() - 1) + 1 - begin};
}

static void putNumber(std::string& text, Random& random) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const auto begin =
        std::find_if(text.begin() + static_cast<std::ptrdiff_t>(placeIn(text, random)), text.end(), isDigit);
    const auto end = std::find_if_not(begin, text.end(), isDigit);
    text.replace(begin, end, numbers[random.below(std::size(numbers))]);
}

/// A binary number at the end of a type, in either byte order.
static void putWhole(std::string& text, Random& random) {
    static constexpr std::uint64_t values[] = {
        0,          1,          0x7f,       0x80,       0xff,       0x7fff,           0xffff,
        0x7fffffff, 0x80000000, 0xffffffff, 0x7f800000, 0x7fc00000, ~std::uint64_t(0)};
    const std::uint64_t value = values[random.below(std::size(values))];
    const std::size_t bytes = std::size_t(1) << random.below(4), at = placeIn(text, random);
    const bool big = random.below(2) == 1;
    for (std::size_t k = 0; k < bytes && at + k < text.size(); ++k)
        text[at + k] = static_cast<char>(value >> 8 * (big ? bytes - 1 - k : k));
}

void Mutations::mutate(std::string& text, Random& random) const {
    const auto [begin, length] = pieceOf(text, random);
    switch (random.below(12)) {
    case 0:
        if (!text.empty())
            text[random.below(text.size())] ^= static_cast<char>(1 << random.below(8));
        break;
    case 1:
        if (!text.empty())
            text[random.below(text.size())] = static_cast<char>(random.below(256));
        break;
    case 2:
        text.erase(begin, length);
        break;
    case 3:
        text.insert(placeIn(text, random), text.substr(begin, length));
        break;
    case 4:
        text.insert(begin, std::string(1 + random.below(40), static_cast<char>(random.below(256))));
        break;
    case 5:
        if (!m_words.empty())
            text.insert(begin, m_words[random.below(m_words.size())]);
        break;
    case 6:
        if (!m_words.empty())
            text.replace(begin, length, m_words[random.below(m_words.size())]);
        break;
    case 7:
        putNumber(text, random);
        break;
    case 8:
        putWhole(text, random);
        break;
    case 9: { // the head of this and the tail of another
        const std::string& other = m_seeds[random.below(m_seeds.size())];
        text = text.substr(0, begin) + other.substr(placeIn(other, random));
        break;
    }
    default: // lines: one goes, comes twice, or comes from another seed
        if (text.empty())
            break;
        const auto [from, size] = lineAt(text, random.below(text.size()));
        const std::string& other = m_seeds[random.below(m_seeds.size())];
        if (random.below(3) == 0)
            text.erase(from, size);
        else if (random.below(2) == 0 || other.empty())
            text.insert(from, text.substr(from, size));
        else {
            const auto [otherFrom, otherSize] = lineAt(other, random.below(other.size()));
            text.insert(from, other.substr(otherFrom, otherSize));
        }
    }
    if (text.size() > longest)
        text.resize(longest);
}

std::string Mutations::input(std::uint64_t k) const {
    if (k < m_seeds.size())
        return m_seeds[k];
    Random random(base::mix(m_seed ^ base::mix(k)));
    std::string text = m_seeds[random.below(m_seeds.size())];
    for (std::size_t n = std::size_t(1) << random.below(5); n > 0; --n)
        mutate(text, random);
    return text;
}

std::vector<std::string> dictionaryWords(const std::string& text) {
    std::vector<std::string> out;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        const std::size_t begin = line.find('"'), end = line.rfind('"');
        if (line.starts_with('#') || begin == end)
            continue;
        std::string word;
        for (std::size_t i = begin + 1; i < end; ++i) {
            if (line[i] != '\\' || i + 1 == end) {
                word += line[i];
                continue;
            }
            ++i;
            if (line[i] == 'x' && i + 2 < end) {
                word += static_cast<char>(std::stoi(line.substr(i + 1, 2), nullptr, 16));
                i += 2;
            } else {
                word += line[i];
            }
        }
        out.push_back(word);
    }
    return out;
}

} // namespace fuzz
