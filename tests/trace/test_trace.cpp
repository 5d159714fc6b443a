#include "trace/sample_trace.h"
#include "trace/small_grafcet.h"
#include "trace/trace.h"

namespace grafwire::testing {

TEST_CASE("the columns of a trace are the declarations in their order") {
    const Trace trace = empty_trace(read_grafcet(R"(
input b, "a x"
output z, y
var w
counter c : 0..9
counter d : -8..7
counter e : 0..0
counter f : 8..8
graph H { initial 2 : z, set y on ↑w  2 -> 2 : b . "a x" }
graph G { initial "my step" : set w, c := d, d := e, e := f, f := c on 1s/w }
)"));
    std::string names;
    for (const Trace::Column& column : trace.columns) {
        names += column.name + ":" + std::to_string(column.width) + " ";
    }
    CHECK(names ==
          "b:1 a x:1 Init:1 AUdur:1 AUdoux:1 X2:1 Xmy step:1 z:1 y:1 w:1 c:5 d:4 e:2 f:5 ");
    CHECK(trace.row_count() == 0);
    CHECK(write_csv(trace) == "time_ms,b,a x,Init,AUdur,AUdoux,X2,Xmy step,z,y,w,c,d,e,f\n");
}

TEST_CASE("CSV: fields quoted where they must be, times without trailing zeros") {
    CHECK(write_csv(sample_trace()) ==
          "time_ms,a,\"a,b \"\"c\"\"\",count\n"
          "0,0,1,-3\n"
          "1.5,1,x,5\n"
          "2000,1,0,5\n");
}

}  // namespace grafwire::testing
