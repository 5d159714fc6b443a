#include "s7/random_listing.h"

#include <algorithm>

#include "random/random_source.h"
#include "s7/instruction_set.h"

namespace grafwire::testing {

using namespace s7;

namespace {

class ListingMaker {
  public:
    explicit ListingMaker(std::uint64_t seed) : random_(seed) {}

    Listing make() {
        subroutines_ = random_.below(4);
        for (std::size_t i = random_.below(3); i > 0; --i) listing_.head.push_back(comment());
        make_block(0);
        for (std::size_t s = 1; s <= subroutines_; ++s) make_block(s);
        return std::move(listing_);
    }

  private:
    std::string comment() {
        static const std::vector<std::string> words = {"Calcul", "de",  "Tpulse", "étape", "X10",
                                                       "//",     "=",   "LD",     "12",    "K0",
                                                       "(non",   "Td)", "ou",     "..."};
        std::string text;
        for (std::size_t i = random_.below(5); i > 0; --i) {
            text += (text.empty() ? "" : " ") + random_.pick(words);
        }
        return text;
    }

    void begin_network() {
        Network network;
        number_ += static_cast<std::uint32_t>(random_.between(1, 2));
        network.number = number_;
        network.comment = comment();
        listing_.networks.push_back(network);
        depth_ = 0;
    }

    Instruction& add(Operation operation, Width width = Width::bit) {
        Instruction instruction;
        instruction.operation = operation;
        instruction.width = width;
        if (random_.one_in(6)) instruction.comment = comment();
        listing_.networks.back().instructions.push_back(instruction);
        return listing_.networks.back().instructions.back();
    }

    void add_numbered(Operation operation, std::size_t number) {
        add(operation).operands = {constant(static_cast<std::int32_t>(number))};
    }

    /// Block 0 is the main program; subroutine s calls only those behind it.
    void make_block(std::size_t block) {
        begin_network();
        if (block != 0) add_numbered(Operation::subroutine, block);
        for (std::size_t n = random_.between(1, 5); n > 0; --n) {
            if (!random_.one_in(3)) begin_network();
            make_network(block);
        }
        begin_network();
        if (has_open_jump_) add_numbered(Operation::label, labels_++);
        has_open_jump_ = false;
        add(block == 0 ? Operation::main_end : Operation::return_);
    }

    void make_network(std::size_t block) {
        if (!random_.one_in(8)) add_any(Operation::load);
        for (std::size_t i = random_.below(8); i > 0; --i) {
            if (random_.one_in(10) && block < subroutines_) {
                add_numbered(Operation::call, random_.between(block + 1, subroutines_));
            } else if (random_.one_in(20) && block != 0) {
                add(Operation::conditional_return);
            } else if (random_.one_in(15) && !has_open_jump_) {
                add_numbered(Operation::jump, labels_);
                has_open_jump_ = true;
            } else {
                const auto rows = instruction_set();
                add_row(rows[random_.below(rows.size())]);
            }
        }
    }

    void add_any(Operation operation) { add_row(*row_of(operation, Width::bit)); }

    void add_row(const InstructionRow& row) {
        switch (row.operation) {
            case Operation::call:
            case Operation::subroutine:
            case Operation::return_:
            case Operation::conditional_return:
            case Operation::jump:
            case Operation::label:
            case Operation::main_end:
            case Operation::end:
                return;
            case Operation::load:
            case Operation::load_not:
            case Operation::load_compare:
                if (depth_ == 9) return;
                ++depth_;
                break;
            case Operation::push:
                if (depth_ == 0 || depth_ == 9) return;
                ++depth_;
                break;
            case Operation::and_load:
            case Operation::or_load:
            case Operation::pop:
                if (depth_ < 2) return;
                --depth_;
                break;
            case Operation::read_push:
            case Operation::count_up:
                if (depth_ < 2) return;
                break;
            case Operation::count_up_down:
                if (depth_ < 3) return;
                break;
            default:
                break;
        }
        Instruction& instruction = add(row.operation, row.width);
        if (row.is_comparison()) instruction.compare = static_cast<Compare>(random_.below(6));
        for (std::size_t i = 0; i < row.operand_count(); ++i) {
            instruction.operands.push_back(make_operand(row, i));
        }
    }

    static Operand constant(std::int32_t value) {
        Operand operand;
        operand.area = Area::constant;
        operand.address = value;
        return operand;
    }

    Operand memory(Width width, bool writable) {
        static const std::vector<Area> areas = {Area::variable, Area::variable, Area::variable,
                                                Area::memento,  Area::output,   Area::input};
        Operand operand;
        operand.area = random_.pick(areas);
        if (!writable && random_.one_in(8)) operand.area = Area::special;
        operand.width = width;
        // Double words that begin at 4 end at 7, the last byte of the smaller areas.
        operand.address = static_cast<std::int32_t>(random_.below(5));
        if (operand.area == Area::special && width == Width::bit) operand.address = 0;
        if (width == Width::bit) operand.bit = static_cast<std::uint8_t>(random_.below(8));
        return operand;
    }

    Operand numbered(Area area, std::int32_t first, std::size_t count) {
        Operand operand;
        operand.area = area;
        operand.address = first + static_cast<std::int32_t>(random_.below(count));
        return operand;
    }

    Operand make_operand(const InstructionRow& row, std::size_t i) {
        const bool is_block =
            row.operation == Operation::block_move || row.operation == Operation::fill;
        switch (row.operands[i]) {
            case OperandKind::bit:
                if (random_.one_in(8)) return numbered(Area::timer, 37, 2);
                if (random_.one_in(8)) return numbered(Area::counter, 0, 2);
                return memory(Width::bit, false);
            case OperandKind::place_bit:
                return memory(Width::bit, true);
            case OperandKind::reset_bit:
                if (random_.one_in(8)) return numbered(Area::timer, 37, 1);
                if (random_.one_in(8)) return numbered(Area::counter, 0, 1);
                return memory(Width::bit, true);
            case OperandKind::value:
                if (random_.one_in(3)) {
                    return constant(static_cast<std::int32_t>(
                        random_.below(row.width == Width::byte ? 256 : 40000)));
                }
                if (row.width == Width::word && random_.one_in(8)) {
                    return numbered(Area::counter, 0, 2);
                }
                return memory(row.width, false);
            case OperandKind::place:
                return memory(row.width, true);
            case OperandKind::count:
                return constant(static_cast<std::int32_t>(random_.between(1, is_block ? 2 : 3)));
            case OperandKind::preset:
                if (random_.one_in(6)) return memory(Width::word, false);
                return constant(static_cast<std::int32_t>(random_.below(5)));
            case OperandKind::timer:
                return numbered(Area::timer, row.operation == Operation::on_delay ? 37 : 5, 2);
            case OperandKind::counter:
                return numbered(Area::counter, 0, 2);
            default:
                return constant(static_cast<std::int32_t>(random_.below(9)));
        }
    }

    RandomSource random_;
    Listing listing_;
    std::uint32_t number_ = 0;
    std::size_t subroutines_ = 0;
    std::size_t labels_ = 0;
    std::size_t depth_ = 0;
    bool has_open_jump_ = false;
};

}  // namespace

Listing random_listing(std::uint64_t seed) {
    return ListingMaker(seed).make();
}

}  // namespace grafwire::testing
