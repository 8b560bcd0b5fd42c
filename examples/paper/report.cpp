// The report of a study.

#include "report.hpp"

void write_report(const std::filesystem::path& /*folder*/) {}
