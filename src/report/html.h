#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace grafwire {

/// Writes HTML that is XML as well: every element is closed, every text escaped.
class Html {
  public:
    using Attribute = std::pair<std::string_view, std::string_view>;
    using Attributes = std::initializer_list<Attribute>;

    /// Begins an element that holds others.
    void open(std::string_view name, Attributes attributes = {});
    /// Ends the element begun last.
    void close();
    /// An element that holds a text.
    void element(std::string_view name, std::string_view text, Attributes attributes = {});
    /// An element that holds nothing.
    void empty(std::string_view name, Attributes attributes);
    /// Markup that was written elsewhere, such as a picture.
    void markup(std::string_view text) { text_ += text; }

    std::string take() { return std::move(text_); }

  private:
    void begin(std::string_view name, Attributes attributes);

    std::string text_;
    std::vector<std::string> open_;
};

}  // namespace grafwire
