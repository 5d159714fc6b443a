#pragma once

#include <string>
#include <string_view>

#include "plc/shared/plc_options.h"
#include "plc/step7/stl_memory.h"

namespace grafwire {

/// The lines of a source file in Statement List for STEP 7 (AWL): instructions are given in
/// SIMATIC mnemonics and written in the mnemonics wanted.
class StlText {
  public:
    explicit StlText(s7::Mnemonics mnemonics) : mnemonics_(mnemonics) {}

    /// A line as it stands.
    void line(std::string_view text) { text_ += std::string(text) + "\n"; }
    /// A comment of as many lines as the text has.
    void comment(std::string_view text);
    /// `NETWORK`, with its title, of 64 characters at most.
    void network(std::string_view title);
    void op(std::string_view operation, std::string_view operand = {},
            std::string_view comment = {});
    /// Where a jump leads: `M001: NOP 0;`.
    void label(std::string_view name);

    std::string operand(StlAddress address) const;
    /// The memory word (2 bytes) or double word (4) that begins at a byte.
    static std::string word(std::uint32_t byte, std::uint32_t bytes);

    std::string take() { return std::move(text_); }

  private:
    std::string_view mnemonic(std::string_view simatic) const;

    s7::Mnemonics mnemonics_;
    std::string text_;
};

}  // namespace grafwire
