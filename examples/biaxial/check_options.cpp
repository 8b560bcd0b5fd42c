// SPDX-License-Identifier: BSL-1.0
// The rules of the library, before anything is computed.

#include "models.hpp"

void check_values(const Options& options) {
  options.assembly.validate();
  options.rock.validate();
  options.test.validate();
  // A preset has the values of its own, and of the options those that this model has, too.
  model_of_choices(options).validate();
  if (options.breaks_by_loads()) model_by_loads(options).validate();
}
