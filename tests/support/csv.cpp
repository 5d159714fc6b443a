#include "support/csv.h"

namespace grafwire::testing {

std::vector<CsvRow> read_csv(const std::string& text) {
    std::vector<CsvRow> rows;
    CsvRow row;
    std::string field;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            if (quoted && i + 1 < text.size() && text[i + 1] == '"') {
                field += text[++i];
            } else {
                quoted = !quoted;
            }
        } else if (quoted || (c != ',' && c != '\n')) {
            field += c;
        } else {
            row.push_back(std::move(field));
            field.clear();
            if (c == '\n') {
                rows.push_back(std::move(row));
                row.clear();
            }
        }
    }
    return rows;
}

}  // namespace grafwire::testing
