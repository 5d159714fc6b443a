#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

namespace grafwire {

// A state packed into a string of bytes, to be kept and to serve as a key: numbers, truth values
// and enumerators one behind the other, each least significant byte first, and read back in the
// same order.

/// Appends a value in as many bytes as its type has.
template <typename Value>
void append_packed(std::string& bytes, Value value) {
    static_assert(std::is_integral_v<Value> || std::is_enum_v<Value>);
    const auto number = static_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < sizeof(Value); ++i) {
        bytes += static_cast<char>(static_cast<unsigned char>(number >> 8 * i));
    }
}

/// Takes values from the front of packed bytes, which must outlive it.
class PackedReader {
  public:
    explicit PackedReader(const std::string& bytes) : bytes_(bytes) {}

    /// Of the type that was appended.
    template <typename Value>
    void take(Value& value) {
        static_assert(std::is_integral_v<Value> || std::is_enum_v<Value>);
        std::uint64_t number = 0;
        for (std::size_t i = 0; i < sizeof(Value); ++i) {
            number |= std::uint64_t{static_cast<unsigned char>(bytes_[at_++])} << 8 * i;
        }
        value = static_cast<Value>(number);
    }

  private:
    const std::string& bytes_;
    std::size_t at_ = 0;
};

}  // namespace grafwire
