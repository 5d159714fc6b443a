// A program in C99: the scan, to be called from a loop of one's own, and behind GRAFWIRE_MAIN a
// main function that runs it on scans read from a file, so that it can be tried and compared with
// the reference without writing a line.

#include <fmt/format.h>

#include "plc/computer/c_blocks.h"
#include "plc/computer/c_core.h"
#include "plc/computer/language_parts.h"
#include "plc/computer/languages.h"
#include "plc/shared/reserved_words.h"

namespace grafwire {

namespace {

class CProgram {
  public:
    CProgram(const Grafcet& grafcet, const ScanProgram& program)
        : grafcet_(grafcet), core_(grafcet, program, {true, is_c_word}) {}

    std::string write() {
        write_head();
        out_.blank();
        out_.block("#include <stdbool.h>\n#include <stdint.h>\n#include <string.h>\n\n");
        out_.block(core_.types());
        out_.block(core_.functions());
        out_.block(c::main_head);
        out_.line(fmt::format("enum {{ INPUT_COLUMNS = {} }};", grafcet_.all_input_count()));
        out_.block(c::read_scan);
        write_row_writer();
        write_main();
        out_.block("\n#endif\n");
        return out_.take();
    }

  private:
    void write_head();
    void write_row_writer();
    void write_main();

    const Grafcet& grafcet_;
    CCore core_;
    SourceText out_{"//"};
};

void CProgram::write_head() {
    const std::string& chart = core_.names().chart();
    write_title(out_, grafcet_, "a program in C99");
    out_.comment({});
    out_.comment("Include this file where the scan is called:");
    out_.comment(fmt::format("  {0}_inputs in;      fill in the inputs", chart));
    out_.comment(fmt::format("  {0}_grafcet g;", chart));
    out_.comment(fmt::format("  {0}_start(&g, &in);       once", chart));
    out_.comment(
        fmt::format("  {0}_scan(&g, &in, now);   over and over; now: a clock in us", chart));
    out_.comment("  g.outputs               are the outputs");
    out_.comment("To try it on scans from a trace of the reference:");
    out_.comment("  cc -std=c99 -DGRAFWIRE_MAIN THIS_FILE -o program");
    out_.comment("  grafwire run CHART STIMULI --scan 10ms -o trace.csv");
    out_.comment("  ./program < trace.csv | diff - trace.csv");
    write_changed_names(out_, core_.names());
}

/// A text in C, between quotation marks. Question marks are escaped for the sake of trigraphs.
std::string c_string(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\' || c == '?') result += '\\';
        result += c;
    }
    return result + "\"";
}

void CProgram::write_row_writer() {
    const ProgramNames& names = core_.names();
    out_.blank();
    out_.line(
        fmt::format("static void write_row(const {}_grafcet *g, int64_t now, const int *values) {{",
                    names.chart()));
    out_.indent();
    out_.line("write_moment(now);");
    out_.line("for (int i = 0; i < INPUT_COLUMNS; ++i) printf(\",%d\", values[i]);");
    out_.line("for (int step = 0; step < STEPS; ++step) {");
    out_.indent();
    out_.line("printf(\",%d\", (int)(g->Ts[step / 32] >> (step % 32) & 1u));");
    out_.outdent();
    out_.line("}");
    const auto write_bits = [&](BitKind kind, std::size_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            out_.line(fmt::format("printf(\",%d\", {});", core_.name(Bit{kind, i})));
        }
    };
    write_bits(BitKind::output, grafcet_.outputs.size());
    write_bits(BitKind::var, grafcet_.vars.size());
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        out_.line(
            fmt::format("printf(\",%lld\", (long long){});", core_.name(IntegerCell{false, c})));
    }
    out_.line("putchar('\\n');");
    out_.outdent();
    out_.line("}");
}

void CProgram::write_main() {
    const ProgramNames& names = core_.names();
    out_.blank();
    out_.comment(
        "Reads a line per scan: the moment in ms, the inputs as 0 or 1. The first line, and");
    out_.comment(
        "further columns, are passed over. Writes the trace in the columns of the reference.");
    out_.line("int main(void) {");
    out_.indent();
    out_.line(fmt::format("{}_grafcet g;", names.chart()));
    out_.line(fmt::format("{}_inputs in;", names.chart()));
    out_.line("int values[INPUT_COLUMNS];");
    out_.line("int64_t now;");
    out_.line("memset(&in, 0, sizeof in);");
    for (const std::string& part : trace_heading(grafcet_)) {
        out_.whole_line(fmt::format("fputs({}, stdout);", c_string(part)));
    }
    out_.line("putchar('\\n');");
    out_.line("skip_line();");
    out_.line("for (long row = 2; ; ++row) {");
    out_.indent();
    out_.line("const int c = getchar();");
    out_.line("if (c == EOF) return 0;");
    out_.line("ungetc(c, stdin);");
    out_.line("if (!read_scan(&now, values)) {");
    out_.indent();
    out_.whole_line(
        "fprintf(stderr, \"line %ld: expected a moment in ms, whole in us, and %d inputs\\n\",");
    out_.whole_line("        row, INPUT_COLUMNS);");
    out_.line("return 1;");
    out_.outdent();
    out_.line("}");
    for (const Bit bit : names.inputs()) {
        const std::size_t column =
            bit.kind == BitKind::control ? grafcet_.inputs.size() + bit.index : bit.index;
        out_.line(fmt::format("in.{} = values[{}] != 0;", names[bit], column));
    }
    out_.line(fmt::format("if (row == 2) {}_start(&g, &in);", names.chart()));
    out_.line(fmt::format("{}_scan(&g, &in, now);", names.chart()));
    out_.line("write_row(&g, now, values);");
    out_.outdent();
    out_.line("}");
    out_.outdent();
    out_.line("}");
}

}  // namespace

std::string write_c(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions&,
                    Diagnostics& diagnostics) {
    if (!check_integers(grafcet, program, "C", diagnostics)) return {};
    return CProgram(grafcet, program).write();
}

}  // namespace grafwire
