// SPDX-License-Identifier: BSL-1.0
#pragma once
// SIGINT (Ctrl-C) and SIGTERM end a run at the end of a step; a second signal ends the program at
// once. A signal that the program was started to ignore, as in the background of a script, stays
// ignored.

#include <csignal>

namespace command_line {

inline volatile std::sig_atomic_t stop_signal = 0;

extern "C" inline void note_stop_signal(int signal) {
  stop_signal = signal;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

// An observer of BiaxialTest; from its making on signals are noted.
struct StopOnSignal {
  StopOnSignal() {
    for (const int signal : {SIGINT, SIGTERM})
      if (std::signal(signal, note_stop_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  template <class View>
  [[nodiscard]] bool stop_requested(const View& /*view*/) const {
    return stop_signal != 0;
  }
};

}  // namespace command_line
