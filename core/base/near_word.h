// Which of the known words a mistyped one may have meant: what errors about unknown words suggest.
#pragma once

#include <string>
#include <string_view>

namespace base {

/// The known word that is the fewest slips away, whatever the case of letters: one left out, put in or changed, or two
/// neighbours swapped (the optimal string alignment distance). Of equals the first; a word that goes on where the given
/// one, of three letters or more, ends counts as one slip. Empty where every known word is more than a third of the
/// letters away. `known`: words apart by blanks or commas.
std::string nearWord(std::string_view word, std::string_view known);

/// "did you mean 'draw'?", or "" where no word is near.
std::string didYouMean(std::string_view word, std::string_view known);

/// The same before a clause that tells the way out: "did you mean 'draw'? choose one of ...".
std::string didYouMeanOr(std::string_view word, std::string_view known, const std::string& todo);

} // namespace base
