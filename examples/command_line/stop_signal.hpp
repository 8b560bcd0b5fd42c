// SPDX-License-Identifier: BSL-1.0
#pragma once
// SIGINT (Ctrl-C) and SIGTERM end a run at the end of a step; a second signal ends the program at
// once. SIGUSR1 asks for a checkpoint. A signal that the program was started to ignore, as in the
// background of a script, stays ignored.

#include <csignal>

namespace command_line {

inline volatile std::sig_atomic_t stop_signal = 0;
inline volatile std::sig_atomic_t checkpoint_signal = 0;

extern "C" inline void note_stop_signal(int signal) {
  stop_signal = signal;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}
extern "C" inline void note_checkpoint_signal(int signal) {
  checkpoint_signal = signal;
  std::signal(SIGUSR1, note_checkpoint_signal);
}

// From here on signals are noted.
inline void note_signals() {
  for (const int signal : {SIGINT, SIGTERM})
    if (std::signal(signal, note_stop_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
  if (std::signal(SIGUSR1, note_checkpoint_signal) == SIG_IGN) std::signal(SIGUSR1, SIG_IGN);
}

}  // namespace command_line
