#pragma once

#include <optional>
#include <string>
#include <vector>

namespace grafwire {

/// Lines from standard input; one at a time in the program. At a terminal each has a prompt, and
/// where the program was built with libedit, it can be edited: the arrows bring back earlier lines,
/// and the tabulator completes the words that a line may begin with.
class LineReader {
  public:
    explicit LineReader(std::vector<std::string> beginnings);
    ~LineReader();
    LineReader(const LineReader&) = delete;
    LineReader& operator=(const LineReader&) = delete;

    bool is_terminal() const { return is_terminal_; }
    /// The next line, without its end; empty at the end of the input.
    std::optional<std::string> next(const std::string& prompt);

  private:
    bool is_terminal_;
};

}  // namespace grafwire
