// Workloads: one table of what is measured, and beside each the naive way to do the same. Two loops go over it:
// `pointclay bench` and Google Benchmark in tests/bench.
//
//     workload.ours(scene)  -> Run     prepares once, outside the clock
//     run()                 -> items   one run, some milliseconds where the workload allows; called again and again
//     run.remark()          -> text    what should be told beside the figures, of the last run
//
// A row is added in one of the *_workloads.cpp files; nothing else knows a workload by name. How baselines are made and
// what makes them fair: app/bench/README.
#pragma once

#include "app/bench/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace bench {

/// Does the work once and returns how many items that were. Holds what was prepared; the scene outlives it.
class Run {
  public:
    Run() = default;
    template <class Work>
    requires std::is_invocable_r_v<std::size_t, Work&> Run(Work work) : m_work(std::move(work)) {}
    template <class Work, class Remark>
    Run(Work work, Remark remark) : m_work(std::move(work)), m_remark(std::move(remark)) {}

    explicit operator bool() const { return static_cast<bool>(m_work); }
    std::size_t operator()() const { return m_work(); }
    std::string remark() const { return m_remark ? m_remark() : std::string(); }

  private:
    std::function<std::size_t()> m_work;
    std::function<std::string()> m_remark;
};

struct Workload {
    std::string name;     ///< scripts know it: "evaluate-scattered"
    std::string item;     ///< what is counted: "position"
    std::string tip;      ///< what one item's work is
    std::string baseline; ///< what it is compared with; empty: nothing
    /// Throws base::Error where the machine lacks what it takes.
    std::function<Run(Scene&)> ours;
    /// One thread. Null where there is no baseline. An empty Run where it does not speak the scene's surface.
    std::function<Run(Scene&)> naive;
    /// A run is what somebody waits for: how long each takes is told beside the rate.
    bool awaited = false;
    /// The baseline answers the same question; otherwise no ratio is told.
    bool sameWork = true;
};

/// All workloads in the order they are told.
const std::vector<Workload>& workloadTable();
/// Null where there is none.
const Workload* findWorkload(const std::string& name);

/// Keeps a result from being optimised away.
template <class T>
void keep(const T& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

/// Rows by room; the table joins them.
std::vector<Workload> treeWorkloads();
std::vector<Workload> surfaceWorkloads();
std::vector<Workload> rayWorkloads();
std::vector<Workload> seamWorkloads();
std::vector<Workload> lightWorkloads();
std::vector<Workload> dabWorkloads();
std::vector<Workload> hapticWorkloads();
std::vector<Workload> splatWorkloads();
std::vector<Workload> displayWorkloads();
std::vector<Workload> fileWorkloads();
std::vector<Workload> startWorkloads();
std::vector<Workload> meshWorkloads();
std::vector<Workload> castWorkloads();

} // namespace bench
