#include "app/bench/workload.h"

#include <algorithm>
#include <iterator>

namespace bench {

const std::vector<Workload>& workloadTable() {
    static const std::vector<Workload> table = [] {
        std::vector<Workload> all;
        for (auto* rows :
             {treeWorkloads, surfaceWorkloads, rayWorkloads, seamWorkloads, lightWorkloads, castWorkloads, dabWorkloads,
              hapticWorkloads, splatWorkloads, displayWorkloads, fileWorkloads, meshWorkloads, startWorkloads})
            std::ranges::move(rows(), std::back_inserter(all));
        return all;
    }();
    return table;
}

const Workload* findWorkload(const std::string& name) {
    const auto& table = workloadTable();
    const auto found = std::ranges::find(table, name, &Workload::name);
    return found == table.end() ? nullptr : &*found;
}

} // namespace bench
