#pragma once

#include <string>
#include <string_view>

#include "core/arguments.h"
#include "core/json.h"

namespace grafwire::playground {

/// The name of a file made of the chart: that of the chart's own with another end, `lift_bench.v`
/// of `lift.grafcet`.
std::string file_beside(const Arguments& arguments, std::string_view end);

/// An answer that is files; the first is what was asked for.
class FilesAnswer {
  public:
    void add(const std::string& name, std::string text);
    Json answer() { return std::move(answer_); }

  private:
    Json answer_{{"files", Json::array()}};
};
/// Of one file.
Json file_answer(const Arguments& arguments, std::string_view extension, std::string text);

/// The kind of a file by its name, as browsers call it.
std::string_view media_type_of(std::string_view name);

// The writers: `format` says in which format. What they write is what the command line writes.

Json export_chart(const Arguments& arguments);
Json export_drawing(const Arguments& arguments);
Json export_equations(const Arguments& arguments);
Json export_netlist(const Arguments& arguments);
Json export_program(const Arguments& arguments);
Json export_trace(const Arguments& arguments);
Json export_gates(const Arguments& arguments);
Json export_waveform(const Arguments& arguments);
Json export_gate_waveform(const Arguments& arguments);
Json export_story(const Arguments& arguments);
Json export_gate_story(const Arguments& arguments);
Json export_report(const Arguments& arguments);

}  // namespace grafwire::playground
