#pragma once

#include "io/OutputFolder.h"
#include "run/HealthRow.h"

namespace fpm {

std::size_t findings(const HealthRows& rows);
/// "finished, healthy", "finished, 2 findings".
std::string healthVerdict(const HealthRows& rows);
/// Lines of the table at the end of the log: every row, then findings with their advice.
std::vector<std::string> healthLines(const HealthRows& rows);
/// Entries of `status`: how many findings so far, and which.
std::string healthStatus(const HealthRows& rows);
/// postProcessing/health/0/health of a case: a dictionary with runId, findings and a list `figures`
/// of { figure value limit time verdict where advice }. Without limit: reported, not judged;
/// without time: of the run as a whole; without advice: no finding.
void writeHealth(const OutputFolder& theCase, const std::string& runId, const HealthRows& rows);

} // namespace fpm
