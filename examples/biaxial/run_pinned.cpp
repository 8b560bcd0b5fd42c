// Breakable particles with two contacts pinned in their stress analysis, as in the paper.

#include "run.hpp"

void run_with_pinned_contacts(const Options& options) {
  run(options, breakable_model(options).support(riprap::TwoPinnedContacts{}));
}
