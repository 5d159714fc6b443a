#pragma once

namespace grafwire::testing {

/// Under the sanitizers everything takes many times longer, and some tests do less.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool is_slow_build = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool is_slow_build = true;
#else
inline constexpr bool is_slow_build = false;
#endif
#else
inline constexpr bool is_slow_build = false;
#endif

}  // namespace grafwire::testing
