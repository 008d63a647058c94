#pragma once
// Everything a model needs from the kernel.

#include "sim/kernel/arrivals.h"
#include "sim/kernel/composite.h"
#include "sim/kernel/container.h"
#include "sim/kernel/distribution.h"
#include "sim/kernel/event.h"
#include "sim/kernel/histogram.h"
#include "sim/kernel/output_analysis.h"
#include "sim/kernel/quantile_sketch.h"
#include "sim/kernel/random_stream.h"
#include "sim/kernel/replications.h"
#include "sim/kernel/resource.h"
#include "sim/kernel/simulation.h"
#include "sim/kernel/store.h"
#include "sim/kernel/tally.h"
#include "sim/kernel/unit_pool.h"
