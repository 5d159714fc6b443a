// The bytes of a scan under way. Beside each bit there may be noted whether it is known, an open
// input it depends on otherwise, and who wrote it last.

#include "s7/machine/machine_memory.h"

#include <algorithm>

namespace grafwire::s7 {

void MachineMemory::begin(std::vector<std::uint8_t>& bytes) {
    bytes_ = &bytes;
    if (!all_known_) std::fill(known_.begin(), known_.end(), std::uint8_t{0xff});
    all_known_ = true;
    reads_.clear();
    ++scan_;
}

void MachineMemory::record() {
    writers_.assign(causes_.size(), Writer());
    scan_ = 0;
}

void MachineMemory::note_read(std::size_t at, std::uint8_t bit, Width width) {
    Read read{network_, at * 8 + bit, width, 0, {}};
    const std::size_t count = width == Width::bit ? 1 : 8 * bytes_of(width);
    for (std::size_t i = 0; i < count; ++i) {
        const Writer& writer = writers_[read.memory_bit + i];
        if (writer.order > read.writer.order) read.writer = writer;
    }
    read.value = width == Width::bit ? (*bytes_)[at] >> bit & 1U : word(at, width).value;
    reads_.push_back(read);
}

void MachineMemory::set_input(std::size_t at, std::uint8_t value, std::uint8_t known,
                              std::uint16_t first_cause) {
    (*bytes_)[at] = static_cast<std::uint8_t>(value & known);
    known_[at] = known;
    if (known == 0xff) return;
    all_known_ = false;
    for (std::uint16_t bit = 0; bit < 8; ++bit) {
        causes_[at * 8 + bit] = static_cast<std::uint16_t>(first_cause + bit);
    }
}

void MachineMemory::set_bit(std::size_t at, std::uint8_t bit, Signal value) {
    const auto mask = static_cast<std::uint8_t>(1U << bit);
    const auto others = static_cast<std::uint8_t>(~mask);
    std::uint8_t& byte = (*bytes_)[at];
    byte = static_cast<std::uint8_t>((byte & others) | (value.is_one() ? mask : 0));
    if (value.is_known()) {
        known_[at] |= mask;
    } else {
        known_[at] &= others;
        causes_[at * 8 + bit] = value.cause;
    }
    note_writer(at * 8 + bit, 1);
}

LogicWord MachineMemory::word(std::size_t at, Width width) const {
    LogicWord word{0, 0};
    const std::size_t count = bytes_of(width);
    for (std::size_t i = 0; i < count; ++i) {
        word.value = word.value << 8 | (*bytes_)[at + i];
        word.known = word.known << 8 | known_[at + i];
    }
    if (count < 4) word.known |= 0xffffffffU << (8 * count);
    return word;
}

void MachineMemory::set_word(std::size_t at, Width width, LogicWord value,
                             const std::uint16_t* causes) {
    const std::size_t count = bytes_of(width);
    for (std::size_t i = count; i-- > 0;) {
        const std::size_t shift = 8 * (count - 1 - i);
        (*bytes_)[at + i] = static_cast<std::uint8_t>(value.value >> shift);
        known_[at + i] = static_cast<std::uint8_t>(value.known >> shift);
    }
    for (std::uint32_t bit = 0; bit < 8 * count; ++bit) {
        if (causes == nullptr) break;
        if ((value.known >> bit & 1U) == 0) causes_[memory_bit(at, width, bit)] = causes[bit];
    }
    note_writer(at * 8, count * 8);
}

void MachineMemory::copy(std::size_t from, std::size_t to, std::size_t count) {
    const auto move = [&](auto& items, std::size_t size) {
        const auto first = items.begin() + static_cast<std::ptrdiff_t>(from * size);
        const auto end = first + static_cast<std::ptrdiff_t>(count * size);
        const auto target = items.begin() + static_cast<std::ptrdiff_t>(to * size);
        if (from < to) {
            std::copy_backward(first, end, target + (end - first));
        } else {
            std::copy(first, end, target);
        }
    };
    move(*bytes_, 1);
    if (!all_known_) {
        move(known_, 1);
        move(causes_, 8);
    }
    note_writer(to * 8, count * 8);
}

void MachineMemory::note_writer(std::size_t first_bit, std::size_t count) {
    if (writers_.empty()) return;
    const auto first = writers_.begin() + static_cast<std::ptrdiff_t>(first_bit);
    std::fill(first, first + static_cast<std::ptrdiff_t>(count),
              Writer{network_, scan_, ++writes_});
    if (wrote_.size() <= network_) wrote_.resize(network_ + 1);
    wrote_[network_] = scan_;
}

}  // namespace grafwire::s7
