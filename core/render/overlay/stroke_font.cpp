#include "core/render/overlay/stroke_font.h"

#include <algorithm>

namespace render {

namespace {

/// Strokes apart by blanks; a point is two digits, x 0 to 4 and y 0 (top of capitals) to 8, the base line at 6.
struct Letter {
    char letter;
    const char* strokes;
};

constexpr Letter letters[] = {
    {' ', ""},
    {'a', "4246 4332120305163645"},
    {'b', "0006 0312324345361605"},
    {'c', "4332120305163645"},
    {'d', "4046 4332120305163645"},
    {'e', "04444332120305163645"},
    {'f', "30201116 0232"},
    {'g', "4247381807 4332120305163645"},
    {'h', "0006 0312324346"},
    {'i', "0206 00"},
    {'j', "121708 10"},
    {'k', "0006 3204 1436"},
    {'l', "0006"},
    {'m', "0206 03122326 23324346"},
    {'n', "0206 0312324346"},
    {'o', "123243453616050312"},
    {'p', "0208 0312324345361605"},
    {'q', "4248 4332120305163645"},
    {'r', "0206 031232"},
    {'s', "43321203143445361605"},
    {'t', "10152636 0232"},
    {'u', "0205163645 4246"},
    {'v', "022642"},
    {'w', "0216233642"},
    {'x', "0246 4206"},
    {'y', "0205163645 4247381807"},
    {'z', "02420646"},
    {'A', "062046 1434"},
    {'B', "00063645443303 3342413000"},
    {'C', "4130100105163645"},
    {'D', "00062644422000"},
    {'E', "40000646 0333"},
    {'F', "400006 0333"},
    {'G', "41301001051636454323"},
    {'H', "0006 4046 0343"},
    {'I', "0006"},
    {'J', "4045361605"},
    {'K', "0006 4003 1346"},
    {'L', "000646"},
    {'M', "0600234046"},
    {'N', "06004640"},
    {'O', "103041453616050110"},
    {'P', "06003041423303"},
    {'Q', "103041453616050110 3446"},
    {'R', "06003041423303 2346"},
    {'S', "413010010213334445361605"},
    {'T', "0040 2026"},
    {'U', "000516364540"},
    {'V', "002640"},
    {'W', "0016223640"},
    {'X', "0046 4006"},
    {'Y', "002340 2326"},
    {'Z', "00400646"},
    {'0', "103041453616050110"},
    {'1', "012026"},
    {'2', "01103041420646"},
    {'3', "0110304142334445361605 1333"},
    {'4', "36300444"},
    {'5', "40000312324345361605"},
    {'6', "413010010516364544331304"},
    {'7', "004016"},
    {'8', "13020110304142331304051636454433"},
    {'9', "051636454130100102133342"},
    {'+', "0444 2226"},
    {'-', "0434"},
    {'.', "06"},
    {',', "0607"},
    {':', "03 06"},
    {'(', "10010516"},
    {')', "00111506"},
    {'/', "0630"},
    {'^', "021022"},
    {'=', "0343 0545"},
};

const Letter* find(char letter) {
    const auto found = std::ranges::find(letters, letter, &Letter::letter);
    return found != std::end(letters) ? found : nullptr;
}

} // namespace

bool hasGlyph(char letter) {
    return find(letter) != nullptr;
}

Glyph glyph(char letter) {
    const Letter* row = find(letter);
    Glyph out;
    float right = letter == ' ' ? 1 : 0;
    out.strokes.emplace_back();
    for (const char* c = row ? row->strokes : "0040460600"; *c; ++c) {
        if (*c == ' ') {
            out.strokes.emplace_back();
            continue;
        }
        const float x = static_cast<float>(c[0] - '0'), y = static_cast<float>(c[1] - '0' - 6);
        out.strokes.back().push_back({x, y});
        right = std::max(right, x);
        ++c;
    }
    out.advance = right + 1.9f;
    return out;
}

float textWidth(std::string_view text, float capHeight) {
    float sum = 0;
    for (const char letter : text)
        sum += glyph(letter).advance;
    return text.empty() ? 0 : (sum - 1.9f) * capHeight / 6;
}

} // namespace render
