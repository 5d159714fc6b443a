#include <doctest/doctest.h>

#include <limits>

#include "text/packed_bytes.h"

using namespace grafwire;

TEST_CASE("values come back from packed bytes in their order") {
    enum class Colour : std::uint8_t { red, green };
    std::string bytes;
    append_packed(bytes, std::int64_t{-2});
    append_packed(bytes, true);
    append_packed(bytes, Colour::green);
    append_packed(bytes, std::numeric_limits<std::int32_t>::min());
    append_packed(bytes, std::uint8_t{200});
    CHECK(bytes.size() == 8 + 1 + 1 + 4 + 1);
    CHECK(bytes.substr(0, 2) == "\xfe\xff");  // the least significant byte first

    PackedReader reader(bytes);
    std::int64_t number = 0;
    bool flag = false;
    Colour colour = Colour::red;
    std::int32_t least = 0;
    std::uint8_t byte = 0;
    reader.take(number);
    reader.take(flag);
    reader.take(colour);
    reader.take(least);
    reader.take(byte);
    CHECK(number == -2);
    CHECK(flag);
    CHECK(colour == Colour::green);
    CHECK(least == std::numeric_limits<std::int32_t>::min());
    CHECK(byte == 200);
}
