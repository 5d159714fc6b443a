// grafwire_describe FOLDER DATE: the manual pages, in English and in French, and the completions of
// bash, zsh and fish, below a folder as they stand below /usr/share.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "command/commands.h"
#include "describe/completions.h"
#include "describe/manual.h"

namespace {

using namespace grafwire;

class Folder {
  public:
    explicit Folder(std::filesystem::path path) : path_(std::move(path)) {}

    void write(const std::string& name, const std::string& text) {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream out(file, std::ios::binary);
        out << text;
        if (!out.flush()) failed_ = true;
    }
    bool failed() const { return failed_; }

  private:
    std::filesystem::path path_;
    bool failed_ = false;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("usage: grafwire_describe FOLDER DATE\n", stderr);
        return 2;
    }
    Folder folder(argv[1]);
    const CommandDescription english = describe_program(all_commands(), Language::english);
    const CommandDescription french = describe_program(all_commands(), Language::french);
    for (const ManualPage& page : manual_pages(english, argv[2], Language::english)) {
        folder.write("man/man1/" + page.file, page.text);
    }
    for (const ManualPage& page : manual_pages(french, argv[2], Language::french)) {
        folder.write("man/fr/man1/" + page.file, page.text);
    }
    folder.write("bash-completion/completions/grafwire", bash_completion(english));
    folder.write("zsh/site-functions/_grafwire", zsh_completion(english, french));
    folder.write("fish/vendor_completions.d/grafwire.fish", fish_completion(english, french));
    return folder.failed() ? 1 : 0;
}
