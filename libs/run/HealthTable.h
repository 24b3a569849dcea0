#pragma once

#include "run/HealthRow.h"

#include <filesystem>

namespace fpm {

std::size_t findings(const HealthRows& rows);
/// "finished, healthy", "finished, 2 findings".
std::string healthVerdict(const HealthRows& rows);
/// Lines of the table at the end of the log: every row, then findings with their advice.
std::vector<std::string> healthLines(const HealthRows& rows);
/// Entries of `status`: how many findings so far, and which.
std::string healthStatus(const HealthRows& rows);
/// postProcessing/health/0/health.dat of a case: the mark of the run, then one row a line, texts in
/// double quotes: figure value limit time verdict where advice. limit 0: reported, not judged; time
/// -1: of the run as a whole.
void writeHealth(const std::filesystem::path& caseRoot,
                 const std::string& runId,
                 const HealthRows& rows);

} // namespace fpm
