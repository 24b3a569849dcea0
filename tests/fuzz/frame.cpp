#include "fuzz/ImageEdits.h"
#include "fuzz/tried.h"
#include "io/Frames.h"
#include "io/VtkHdf.h"
#include "support/TemporaryFolder.h"

// A frame whose arrays and attributes say anything has rows of its mesh's nodes and elements, or is
// refused. The input is a label, with its length before it, and a list of edits of a small frame.

using namespace fpm;

namespace {

const FrameMesh mesh{"0123456789abcdef", 8, 1};

/// The file that is edited.
struct Base {
    test::TemporaryFolder folder;
    std::string label;
    fuzz::ImageEdits content;

    Base()
        : label((write(), *hdf5Label(file()))),
          content(file(), {"TimeValue", "nodeCount", "elementCount", "meshChecksum", "runId"})
    {
    }
    std::filesystem::path file() const { return folder / "0/fields.vtkhdf"; }

private:
    void write() const
    {
        Frame frame;
        frame.nodeFields.push_back({"U", 3, std::vector<double>(3 * mesh.nodeCount, 0.5)});
        frame.elementFields.push_back({"S", 6, {1, 2, 3, 4, 5, 6}});
        frame.elementFields.push_back({"PEEQ", 1, {0.25}});
        frame.meshChecksum = mesh.checksum;
        frame.runId = "run";
        writeFrame(OutputFolder(folder.path()), "0", frame, mesh.nodeCount, mesh.elementCount);
    }
};

void requireRows(const std::vector<ResultField>& fields, std::size_t rows)
{
    for (const ResultField& field : fields)
        fuzz::require(field.values.size() == rows * field.columns, "a field has its mesh's rows");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size)
{
    static const Base base;
    fuzz::InputBytes input(bytes, size);
    const std::string label = input.text(input.byte());
    fuzz::ImageEdits edits = base.content;
    edits.apply(input);
    const auto file = base.folder / "1/fields.vtkhdf";
    edits.write(base.folder.path(), "1/fields.vtkhdf", label.empty() ? base.label : label);
    fuzz::tried([&] { listFrames(base.folder.path()); });
    fuzz::tried([&] {
        const Frame frame = readFrame(file, mesh);
        requireRows(frame.nodeFields, mesh.nodeCount);
        requireRows(frame.elementFields, mesh.elementCount);
    });
    return 0;
}
