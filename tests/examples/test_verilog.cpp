// The Verilog of the examples in Icarus Verilog, under the generated test bench.

#include <doctest/doctest.h>

#include "examples/example.h"
#include "formats/shared/bench.h"
#include "formats/verilog/write_verilog.h"
#include "support/csv.h"
#include "support/run_program.h"
#include "text/time.h"

namespace grafwire::testing {

namespace {

/// Of a netlist with delays also with gates that take that long, in ns.
std::vector<CsvRow> icarus_rows(const AgreeingNetlist& item, const Bench& bench,
                                const std::string& gate) {
    const ScratchFolder folder;
    const std::string bench_file =
        folder.file("bench.v", write_verilog_bench(item.netlist, bench, scan_period));
    const std::string netlist_file = folder.file("netlist.v", write_verilog(item.netlist));
    const std::string program = folder.path("run");
    std::vector<std::string> command{"iverilog", "-Wall", "-Wno-timescale", "-o", program};
    if (!item.netlist.is_clocked()) command.push_back("-Pgrafwire_bench.GATE_NS=" + gate);
    command.insert(command.end(), {bench_file, netlist_file});
    const Ran compiled = run_program(command);
    REQUIRE_MESSAGE(compiled.status == 0, compiled.err);
    CHECK(compiled.err == "");
    const Ran ran = run_program({"vvp", "-n", program});
    CHECK(ran.status == 0);
    CHECK(ran.err == "");
    return read_csv(ran.out);
}

void check_in_icarus(const AgreeingNetlist& item, const std::string& gate) {
    const Trace trace = reference_for(item);
    const Bench bench = bench_from(item.netlist, item.example->stimuli, trace.times);
    const std::vector<CsvRow> rows = icarus_rows(item, bench, gate);
    REQUIRE(rows.size() == trace.row_count() + 1);
    for (std::size_t row = 0; row < trace.row_count(); ++row) {
        const CsvRow& got = rows[row + 1];
        REQUIRE(got.size() == rows[0].size());
        CHECK(got[0] == format_milliseconds(trace.times[row]));
        std::string ones;
        for (std::size_t i = 1; i < got.size(); ++i) {
            CHECK((got[i] == "0" || got[i] == "1"));
            if (got[i] == "1") ones += rows[0][i] + ' ';
        }
        INFO("at " << got[0] << " ms");
        CHECK(ones == ones_of(item.example->grafcet, trace, row));
    }
}

}  // namespace

TEST_CASE("Icarus Verilog gives the reference's rows for every example") {
    std::size_t count = 0;
    for (const AgreeingNetlist& item : agreeing_netlists()) {
        INFO("netlist: " << item.name());
        check_in_icarus(item, "1");
        if (!item.netlist.is_clocked()) check_in_icarus(item, "3");
        ++count;
        if (is_slow_build && count == 6) break;
    }
    CHECK(count >= (is_slow_build ? 6U : 35U));
}

}  // namespace grafwire::testing
