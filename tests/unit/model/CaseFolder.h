#pragma once

#include "case/Case.h"
#include "mesh/MeshFile.h"

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace fpm::test {

inline std::string readText(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    return (std::ostringstream() << stream.rdbuf()).str();
}

/// A case in a temporary folder, removed at the end of the test.
class CaseFolder
{
public:
    CaseFolder()
    {
        static std::atomic<int> count{0};
        root_ = std::filesystem::temp_directory_path()
                / ("fpmCase." + std::to_string(getpid()) + "." + std::to_string(count++));
        write("system/controlDict", "endTime 1e-4;\n");
        write("constant/caseProperties", "units { length mm; mass tonne; time s; }\n");
    }
    ~CaseFolder() { std::filesystem::remove_all(root_); }
    CaseFolder(const CaseFolder&) = delete;
    CaseFolder& operator=(const CaseFolder&) = delete;

    const std::filesystem::path& root() const { return root_; }
    Case open() const { return Case(root_); }
    Mesh mesh() const { return readMesh(root_ / "constant/mesh.vtkhdf"); }
    std::filesystem::path logFile() const { return root_ / "log"; }
    std::string logText() const { return readText(logFile()); }

    void write(const std::string& relative, const std::string& text) const
    {
        std::filesystem::create_directories((root_ / relative).parent_path());
        std::ofstream(root_ / relative) << text;
    }
    void write(const Mesh& mesh) const { writeMesh(OutputFolder(root_), mesh); }
    /// Copies every file below `source`, over those that are there.
    void overlay(const std::filesystem::path& source) const
    {
        std::filesystem::copy(source, root_,
                              std::filesystem::copy_options::recursive
                                  | std::filesystem::copy_options::overwrite_existing);
    }

private:
    std::filesystem::path root_;
};

} // namespace fpm::test
