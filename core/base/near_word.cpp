#include "core/base/near_word.h"

#include <algorithm>
#include <vector>

namespace base {

static char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Row by row of the table of distances between beginnings of both words; the last two rows are kept.
static std::size_t slips(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

static bool begins(std::string_view whole, std::string_view part) {
    return part.size() >= 3 && whole.size() >= part.size() && slips(whole.substr(0, part.size()), part) == 0;
}

std::string nearWord(std::string_view word, std::string_view known) {
    constexpr std::size_t longest = 64; // nobody types more by mistake
    constexpr std::string_view apart = ", ";
    if (word.empty() || word.size() > longest)
        return {};
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    std::string_view nearest;
    while (!known.empty()) {
        const std::string_view each = known.substr(0, std::min(known.find_first_of(apart), known.size()));
        known.remove_prefix(std::min(each.size() + 1, known.size()));
        if (each.empty() || each.size() > longest)
            continue;
        const std::size_t away = begins(each, word) ? 1 : slips(word, each);
        if (away < least && away < each.size())
            least = away, nearest = each;
    }
    return std::string(nearest);
}

std::string didYouMean(std::string_view word, std::string_view known) {
    const std::string near = nearWord(word, known);
    return near.empty() ? "" : "did you mean '" + near + "'?";
}

std::string didYouMeanOr(std::string_view word, std::string_view known, const std::string& todo) {
    const std::string hint = didYouMean(word, known);
    return hint.empty() || todo.empty() ? hint + todo : hint + " " + todo;
}

} // namespace base
