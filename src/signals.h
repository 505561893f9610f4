#ifndef PROSUP_SRC_SIGNALS_H
#define PROSUP_SRC_SIGNALS_H

namespace prosup {

/// Lets a signal that asks the program to end (SIGTERM, SIGINT, SIGHUP, ...), or an output that
/// nobody reads any more, end it cleanly: what is unfinished is removed, one rank prints one line,
/// and the exit code is 128 + number of the signal. For the beginning of main().
void watch_signals();

} // namespace prosup

#endif
