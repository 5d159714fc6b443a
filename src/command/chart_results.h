#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command/chart_files.h"
#include "command/command_line.h"
#include "command/files.h"

namespace grafwire {

/// How the results of several charts stand on standard output.
enum class OnOneStream {
    headed,  ///< one behind the other, each under the name of its file
    lines,   ///< a line of JSON each
    never    ///< they cannot, since nothing reads them so: a folder is needed
};

/// What a result that belongs to a chart is called: `b` for `a/b.grafcet`.
std::string name_for(const ChartFile& chart);

/// Whether no two charts have files of the same name, which results in one folder would get too;
/// shows which have.
bool have_names_of_their_own(const ChartFiles& charts);

/// What a command makes of charts, one result each. Of a single chart it goes where `-o` says, or
/// to standard output. Of several, `-o` is a folder, in which results are called after the files of
/// their charts; or they go to standard output together. All appear at the end, or none.
class ChartResults {
  public:
    struct Form {
        std::string_view extension;  ///< of the files, with the dot
        OnOneStream on_one_stream = OnOneStream::never;
    };

    /// `output`: what `-o` says. Charts and `others` are inputs, which are not overwritten. Empty,
    /// and shown, where two results would have one name, or where a folder is needed and none is
    /// there.
    static std::optional<ChartResults> planned(const ChartFiles& charts, std::string output,
                                               Form form, const std::vector<std::string>& others);

    /// Where the result of a chart goes; empty or `-`: to standard output.
    std::string place_of(std::size_t chart) const;
    /// The same of a second result, for which another option than `-o` names a file, or a folder.
    std::string place_of(std::size_t chart, const std::string& other_output,
                         std::string_view extension) const;

    void add(std::size_t chart, std::string text);
    /// A file beside the result.
    void add_beside(std::string path, std::string text);

    /// Writes everything; returns `status`, or bad_request where that cannot be.
    ExitStatus finish(ExitStatus status);

  private:
    ChartResults(const ChartFiles& charts, std::string output, Form form,
                 std::vector<std::string> inputs);
    bool is_folder(const std::string& output) const;

    const ChartFiles& charts_;
    std::string output_;
    Form form_;
    OutputFiles files_;
    std::string stream_;  ///< what goes to standard output, of several charts
};

/// Does the same with each chart: one that fails does not stop the others. The status is the worst.
template <typename Work>
ExitStatus for_each_chart(const ChartFiles& charts, const Work& work) {
    ExitStatus status = ExitStatus::done;
    for (std::size_t i = 0; i < charts.files.size(); ++i) status = worse_of(status, work(i));
    return status;
}

}  // namespace grafwire
