#pragma once

#include <filesystem>
#include <string>

namespace fpm {

/// Keeps a second writer out of a case: an advisory lock of the system on <case>/.lock, which falls
/// with its process however that ends. The file alone, left over or copied, locks nothing.
class CaseLock
{
public:
    /// Throws Error(caseLocked) naming process and host of the holder, Error(fileIo) when the
    /// case cannot be written to.
    CaseLock(const std::filesystem::path& caseRoot, const std::string& application);
    CaseLock(const CaseLock&) = delete;
    CaseLock& operator=(const CaseLock&) = delete;
    ~CaseLock();

private:
    int descriptor_;
};

/// Whether a process holds the lock of the case now, as far as the system says: true for a holder
/// without a record, and where the system gives no information about locks.
bool holdsCase(const std::filesystem::path& caseRoot, int process, const std::string& host);

} // namespace fpm
