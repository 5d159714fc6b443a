#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json.h"
#include "text/message.h"

namespace grafwire::playground {

/// The arguments of a request, each of which may be missing. Where one is of another type than it
/// should be it counts as missing, and fault() names it.
class Arguments {
  public:
    /// `members` must outlive it.
    explicit Arguments(const Json& members);

    bool has(std::string_view name) const;
    std::string text(std::string_view name, std::string_view otherwise = {}) const;
    bool flag(std::string_view name, bool otherwise) const;
    std::optional<double> number(std::string_view name) const;
    /// A number of things: 0 where it is missing or below, at most 2^53, whatever was sent.
    std::uint64_t count(std::string_view name) const;
    std::vector<std::string> texts(std::string_view name) const;
    /// The members of an object; empty where there is none.
    const Json& object(std::string_view name) const;

    Language language() const;
    /// The first argument that was asked for and is of another type; empty where there is none.
    const std::string& fault() const { return fault_; }

  private:
    const Json* find(std::string_view name, bool (Json::*is_right)() const noexcept) const;

    const Json& members_;
    mutable std::string fault_;
};

}  // namespace grafwire::playground
