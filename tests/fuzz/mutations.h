// Mutations of seeds, for fuzzing without a fuzzer: bytes and bits, pieces of the input and of other seeds, words of
// the format, numbers at the ends of their types. They learn nothing from what they meet, but the k-th input is the
// same whenever it is tried again.
#pragma once

#include "core/base/random.h"

#include <string>
#include <vector>

namespace fuzz {

class Mutations {
  public:
    /// REQUIRES: at least one seed.
    Mutations(std::vector<std::string> seeds, std::vector<std::string> words, std::uint64_t seed)
        : m_seeds(std::move(seeds)), m_words(std::move(words)), m_seed(seed) {}

    /// The seeds as they are, then mutations of one of them: the k-th follows from seeds, words and seed alone.
    std::string input(std::uint64_t k) const;

  private:
    void mutate(std::string& input, base::Random& random) const;

    std::vector<std::string> m_seeds, m_words;
    std::uint64_t m_seed;
};

/// The words of a dictionary in libFuzzer's form: lines of ["name"=]"word" with \\, \" and \xNN.
std::vector<std::string> dictionaryWords(const std::string& text);

} // namespace fuzz
