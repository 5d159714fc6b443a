#pragma once

#include <string>

#include "s7/addresses/io_assignment.h"
#include "s7/machine/machine.h"
#include "s7/parse_listing.h"
#include "support/files.h"

namespace grafwire::testing {

/// The listing of a text that has no errors, else a test failure with the messages.
s7::Listing read_listing(const std::string& text, s7::Cpu cpu = s7::Cpu::cpu_214);
s7::IoAssignment read_assignment(const std::string& text);

/// What the reader has to say about a text, as it is shown; empty if nothing.
std::string messages_of(const std::string& text, s7::Cpu cpu = s7::Cpu::cpu_214);

/// An operand as it is written, such as `V20.1`.
s7::Operand operand(const std::string& text);

/// A machine with its state, for tests that look at single scans.
struct Controller {
    explicit Controller(const std::string& text, s7::Cpu cpu = s7::Cpu::cpu_214)
        : listing(read_listing(text, cpu)), machine(listing, cpu), state(machine.start()) {}

    /// Sets an input bit from now on.
    void set(const std::string& input, bool value);
    /// One scan, which must come to its end, so much later than the last.
    void scan(Time later = 10 * millisecond);
    bool bit(const std::string& text) const { return machine.bit(state, operand(text)).is_one(); }
    std::int32_t value(const std::string& text) const {
        return machine.value(state, operand(text));
    }

    s7::Listing listing;
    s7::Machine machine;
    s7::MachineState state;
    s7::InputImage inputs;
    Time now = 0;
    bool has_scanned = false;
};

}  // namespace grafwire::testing
