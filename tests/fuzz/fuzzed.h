// What all targets of the fuzzer share. A target is one function that libFuzzer calls with bytes of its own making;
// what it must show is that nothing happens but an answer or a base::Error: no other exception, no access outside of
// memory, no undefined behaviour, nothing that takes seconds, no memory that the bytes do not pay for.
//
// One thread, so that an execution is the same whenever it is tried again.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace fuzz {

/// Ends the program with a report, as the fuzzer wants findings.
void require(bool holds, const char* law);

/// Runs what may be refused; false where it was. A refusal is a sentence.
template <class Work>
bool tried(const Work& work) {
    try {
        work();
        return true;
    } catch (const base::Error& error) {
        require(error.message().size() > 8, "a refusal says what is wrong");
    } catch (const base::Cancelled&) {
    }
    return false;
}

/// A folder of this process that goes with it.
const std::filesystem::path& folder();
/// Puts a file there.
std::filesystem::path put(const std::string& name, std::string_view content);

/// To hand down: cancels work that takes longer than a fuzzer has patience for, a quarter of a second of the processor.
/// What does not stop then is found by libFuzzer's own limit.
class Deadline {
  public:
    Deadline();
    ~Deadline();
    base::Progress progress() const;
    bool passed() const;
};

/// One of `names` that follows from the number: inputs stay files as they are, without bytes that choose.
std::string oneOf(std::string_view names, std::size_t number);

/// A triangle with a picture, its material and image, for readers that follow names.
void putPictures();

} // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
