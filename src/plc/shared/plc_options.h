#pragma once

#include <optional>
#include <string>

#include "s7/addresses/cpu.h"
#include "s7/addresses/io_assignment.h"
#include "text/message.h"

namespace grafwire {

/// Each format uses some of them (see PlcFormat::options); all use the language.
struct PlcOptions {
    /// Addresses for inputs, outputs and steps; without, they are assigned in order.
    const s7::IoAssignment* io = nullptr;
    s7::Mnemonics mnemonics = s7::Mnemonics::simatic;  ///< of instruction lists
    bool offsets = true;                               ///< byte offsets before instructions
    bool wide_tables = false;                          ///< tables beyond the 80 steps of the method
    std::optional<s7::Cpu> cpu;  ///< the controller that the program has to fit
    bool pull_up = false;        ///< inputs of a board are contacts to ground
    /// Of comments, headings and what a program says to its users. Names and addresses do not
    /// depend on it.
    Language language = Language::english;
    /// A line for the head of the program: who wrote it, and the request that writes it again.
    /// Empty where nobody says so.
    std::string made_by{};
};

}  // namespace grafwire
