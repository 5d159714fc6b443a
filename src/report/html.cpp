#include "report/html.h"

#include "text/escape.h"

namespace grafwire {

void Html::begin(std::string_view name, Attributes attributes) {
    text_ += '<';
    text_ += name;
    for (const auto& [attribute, value] : attributes) {
        text_ += ' ';
        text_ += attribute;
        text_ += "=\"" + xml_attribute(value) + '"';
    }
}

void Html::open(std::string_view name, Attributes attributes) {
    begin(name, attributes);
    text_ += ">\n";
    open_.emplace_back(name);
}

void Html::close() {
    text_ += "</" + open_.back() + ">\n";
    open_.pop_back();
}

void Html::element(std::string_view name, std::string_view text, Attributes attributes) {
    begin(name, attributes);
    text_ += '>' + xml_text(text) + "</";
    text_ += name;
    text_ += ">\n";
}

void Html::empty(std::string_view name, Attributes attributes) {
    begin(name, attributes);
    text_ += "/>\n";
}

}  // namespace grafwire
