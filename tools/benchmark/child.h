#pragma once

#include <functional>
#include <string>
#include <vector>

namespace bench {

struct ChildResult {
    std::vector<double> figures;  ///< what the job returned; empty where it failed
    double peak_bytes = 0;        ///< the largest resident set of the process
};

/// Runs a job in a process of its own, so that its peak memory can be told.
ChildResult in_child(const std::function<std::vector<double>()>& job);

struct ProgramResult {
    bool succeeded = false;
    double seconds = 0;  ///< processor time, its children included
    double peak_bytes = 0;
};

/// Runs another program, its output into a file.
ProgramResult run_program(const std::vector<std::string>& words, const std::string& output);

/// Processor seconds this process has used; unlike the time of day these do not count what else
/// the machine does.
double cpu_seconds();

/// Processor seconds of a job, the least of several runs where it is short.
double time_of(const std::function<void()>& job);

}  // namespace bench
