// A program in C99: the scan, to be called from a loop of one's own, and behind GRAFWIRE_MAIN a
// main function that runs it on scans read from a file, so that it can be tried and compared with
// the reference without writing a line.

#include <fmt/format.h>

#include "plc/computer/c_blocks.h"
#include "plc/computer/c_core.h"
#include "plc/computer/language_parts.h"
#include "plc/computer/languages.h"
#include "plc/computer/messages.h"
#include "plc/shared/language_words.h"
#include "plc/shared/program_names.h"

namespace grafwire {

namespace {

namespace say = messages::plc_computer;

class CProgram {
  public:
    CProgram(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options)
        : grafcet_(grafcet),
          options_(options),
          language_(options.language),
          core_(grafcet, program, {true, is_c_word}, options.language) {}

    std::string write() {
        write_head();
        out_.blank();
        out_.block("#include <stdbool.h>\n#include <stdint.h>\n#include <string.h>\n\n");
        out_.block(core_.types());
        out_.block(core_.functions());
        out_.block(
            with_texts(c::main_head, {{"@reads_moment", say::reads_moment.in(language_)},
                                      {"@input_columns", say::input_columns.in(language_)}}));
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
    const PlcOptions& options_;
    Language language_;
    CCore core_;
    SourceText out_{"//"};
};

void CProgram::write_head() {
    write_title(out_, grafcet_, say::program_in_c(), options_);
    out_.comment({});
    const std::string& chart = core_.names().chart();
    const auto line_of_use = [&](std::string_view code, const Message<>& comment) {
        out_.comment(fmt::format("  {}{}{}", chart, code, comment.in(language_)));
    };
    out_.comment(say::include_where_called.in(language_));
    line_of_use("_inputs in;      ", say::fill_in_inputs);
    out_.comment(fmt::format("  {}_grafcet g;", chart));
    line_of_use("_start(&g, &in);       ", say::once);
    line_of_use("_scan(&g, &in, now);   ", say::over_and_over);
    out_.comment(fmt::format("  g.outputs               {}", say::are_outputs.in(language_)));
    out_.comment(say::how_to_try_c.in(language_));
    write_changed_names(out_, core_.names(), language_);
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
    out_.comment(say::reads_scans_in_c.in(language_));
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
        fmt::format("fprintf(stderr, \"{}\\n\",", say::bad_line.in(language_, "%ld", "%d")));
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

std::string write_c(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                    Diagnostics& diagnostics) {
    if (!check_integers(grafcet, program, "C", diagnostics)) return {};
    return CProgram(grafcet, program, options).write();
}

}  // namespace grafwire
