#pragma once

#include "support/TemporaryFolder.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace fpm {

/// A case folder of its own for each object, removed with it.
class TemporaryCase
{
public:
    const std::filesystem::path& root() const { return folder_.path(); }

    void write(const std::string& name, const std::string& text) const
    {
        std::filesystem::create_directories((root() / name).parent_path());
        std::ofstream(root() / name) << text;
    }
    std::string read(const std::string& name) const
    {
        std::ostringstream text;
        text << std::ifstream(root() / name).rdbuf();
        return text.str();
    }
    bool has(const std::string& name) const { return std::filesystem::exists(root() / name); }

private:
    test::TemporaryFolder folder_;
};

} // namespace fpm
