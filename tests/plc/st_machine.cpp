#include "plc/st_machine.h"

#include "support/iec_block.h"
#include "support/st_body.h"

namespace grafwire::testing {

namespace {

class StMachine : public IecMachine {
  public:
    StMachine(const std::string& text, const Grafcet& grafcet)
        : IecMachine(grafcet), body_(block_, declared(text)) {}

    void scan(Time now) override {
        IecTokenCursor rest = body_.run(now);
        rest.expect("end_function_block");
        if (rest.peek().kind != IecToken::Kind::end) rest.fail("text after the block");
    }

  private:
    /// Reads the declarations; gives what follows.
    IecTokenCursor declared(const std::string& text) {
        IecTokenCursor cursor(iec_tokens(text));
        block_.read_declarations(cursor);
        return cursor;
    }

    StBody body_;
};

}  // namespace

std::unique_ptr<PlcMachine> st_machine(const std::string& text, const Grafcet& grafcet) {
    return std::make_unique<StMachine>(text, grafcet);
}

}  // namespace grafwire::testing
