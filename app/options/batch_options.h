// The same for many files: the options --into, --as, --plan and --json of `clean`, `convert`, `mesh` and `resample`
// (app/README 2.8). One file that fails does not end the rest.
//
//     pointclay clean a.ply b.las c.e57 --into cleaned --as ply --outliers surface
#pragma once

#include "app/console.h"
#include "app/options/option_set.h"

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace app {

struct BatchOptions {
    std::vector<std::string> more; ///< inputs behind those that have a name of their own
    std::string into, as, plan;
    bool json = false;

    bool wanted() const { return !into.empty(); }
};

struct BatchJob {
    std::string in, out;
};

/// What the files of a batch become.
struct BatchOutputs {
    std::string fallback;                           ///< extension where the input's cannot be written: "ply"
    std::function<bool(const std::string&)> writes; ///< whether a name's ending can be written
    bool keepsFormat = true;                        ///< the input's extension unless told
};

/// Adds the options, and a last argument for more inputs. REQUIRES: `options` outlives the command.
void addBatchOptions(OptionSet command, BatchOptions& options);

/// Throws UsageError where batch options were given without --into.
void requireNoBatch(const BatchOptions& options);
/// Likewise, and where there is no -o, or one beside --into.
void requireOneOutput(const BatchOptions& options, const std::string& out);

/// Does `work` for every input, in their order, and tells a table of it, or writes a plan instead. What `work` returns,
/// an object, stands in the table as JSON. `name`: of the subcommand. Throws UsageError where two outputs would be one
/// or an input would be written over; base::Error at the end where any job failed; base::Cancelled at once.
void runBatch(const char* name, OptionSet command, const BatchOptions& options, std::vector<std::string> inputs,
              const BatchOutputs& outputs, Console& console,
              const std::function<nlohmann::ordered_json(const BatchJob&)>& work);

} // namespace app
