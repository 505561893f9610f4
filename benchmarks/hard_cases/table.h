#ifndef PROSUP_BENCHMARKS_HARD_CASES_TABLE_H
#define PROSUP_BENCHMARKS_HARD_CASES_TABLE_H

#include "runner.h"

namespace prosup::benchmarks {

/// docs/stability.md up to the rows of its table.
std::string page_head(Size size);

/// A row of the table.
std::string row(const Case& hard_case, const Result& result);

} // namespace prosup::benchmarks

#endif
