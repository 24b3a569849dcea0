#pragma once

#include "mesher/Mesher.h"
#include "support/TemporaryFolder.h"
#include "support/logFile.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace fpm::test {

/// A case folder that holds what fpmMesh needs.
class MesherCase
{
public:
    MesherCase()
    {
        std::filesystem::create_directory(folder_ / "system");
        writeBytes(folder_ / "system/meshDict", "");
    }
    std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

    /// The mesh of this text as meshDict.
    Mesh mesh(const std::string& meshDict, bool allowGeo = false) const
    {
        Log log = Log::quiet();
        return makeMesh(Dictionary::parse(meshDict, "meshDict"), Case(folder_.path()), allowGeo,
                        log);
    }

    /// What meshing it is reported with.
    std::string said(const std::string& meshDict) const
    {
        {
            Log log = test::logInto(folder_ / "log");
            makeMesh(Dictionary::parse(meshDict, "meshDict"), Case(folder_.path()), false, log);
        }
        return readBytes(folder_ / "log");
    }

private:
    TemporaryFolder folder_;
};

inline Mesh meshOf(const std::string& meshDict)
{
    return MesherCase().mesh(meshDict);
}

/// Nodes of one part, ascending.
inline std::vector<Index> partNodes(const Mesh& mesh, const std::string& name)
{
    const auto& part = mesh.parts.at(std::size_t(mesh.findPart(name)));
    std::vector<Index> nodes;
    for (Index element = 0; element < part.elementCount; ++element)
        for (const Index node : mesh.hexahedra[part.firstElement + element]) nodes.push_back(node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

} // namespace fpm::test
