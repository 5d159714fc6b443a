#include "child.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace bench {

ChildResult in_child(const std::function<std::vector<double>()>& job) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) std::abort();
    if (child == 0) {
        close(ends[0]);
        const std::vector<double> figures = job();
        const std::size_t size = figures.size() * sizeof(double);
        const bool written = write(ends[1], figures.data(), size) == static_cast<ssize_t>(size);
        std::fflush(nullptr);
        _exit(written ? 0 : 1);
    }
    close(ends[1]);
    ChildResult result;
    double figure = 0;
    while (read(ends[0], &figure, sizeof figure) == static_cast<ssize_t>(sizeof figure)) {
        result.figures.push_back(figure);
    }
    close(ends[0]);
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    if (status != 0) result.figures.clear();
    result.peak_bytes = 1024.0 * static_cast<double>(usage.ru_maxrss);
    return result;
}

ProgramResult run_program(const std::vector<std::string>& words, const std::string& output) {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) std::abort();
    if (child == 0) {
        const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
        std::vector<char*> arguments;
        for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return {status == 0, seconds(usage.ru_utime) + seconds(usage.ru_stime),
            1024.0 * static_cast<double>(usage.ru_maxrss)};
}

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double time_of(const std::function<void()>& job) {
    double least = 0;
    double total = 0;
    for (int runs = 0; runs == 0 || (total < 0.3 && runs < 200); ++runs) {
        const double began = cpu_seconds();
        job();
        const double taken = cpu_seconds() - began;
        least = runs == 0 ? taken : std::min(least, taken);
        total += taken;
    }
    return least;
}

}  // namespace bench
